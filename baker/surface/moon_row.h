// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "surface/features.h"
#include "surface/noise.h"

namespace coppermoon::surface {

/// One row of the built-in Moon on its way: where its texels are, where noise bends them to, and how it
/// shades them.
struct MoonRow {
  double latitude_rad;
  std::vector<float> x, y, z, bent_x, bent_y, bent_z, shade, grain;
  std::span<float> albedo;
};

/// Columns from the first to before the last.
struct Columns {
  std::size_t first, last;
};

/// Moves the bent texels back to the sphere, after noise was added to them.
void normalise_bent(MoonRow& row);

/// Paints a feature over some columns of a row, with what the machine has of SIMD.
void paint(const Patch& patch, const Columns& columns, MoonRow& row);
void paint(const OldCrater& crater, const Columns& columns, MoonRow& row);
void paint(const RayCrater& crater, const Columns& columns, MoonRow& row);

}  // namespace coppermoon::surface
