// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "algebra/grid.h"
#include "shadow/padding.h"

namespace coppermoon::shadow {

/// Length of a row for that many wavelengths; values beyond them land nowhere.
constexpr std::size_t padded(std::size_t waves) { return padded(waves, 16); }

/// A place between two rows that follow each other, and what their mean is multiplied with.
struct Between {
  const float* first;
  float along;  ///< 0 at the first, 1 at the next
  float factor = 1;
};

/// Writes the row at each place.
void interpolate(std::span<const Between> places, algebra::Grid<float>& rows);

/// Multiplies each row by the one at its place.
void multiply(std::span<const Between> places, algebra::Grid<float>& rows);

/// How a plane is cut: into rings, and all around into sectors, of which s is centred at
/// 2π s / sectors; one more ring for all that lands farther out.
struct Rings {
  float width_m;
  std::size_t rings, sectors;

  std::size_t rows() const { return sectors * (rings + 1); }
  std::size_t row(double x_m, double y_m) const;
};

/// Light that a few photons bring, by cell and wavelength.
struct Tally {
  Tally(std::size_t rows, std::size_t waves) : light(rows, padded(waves)), touched(rows) {}

  algebra::Grid<float> light;
  std::vector<std::uint8_t> touched;  ///< rows that are not all zero
};

/// A line through the axis that a photon's wavelengths land along, and how far aside of it.
struct Aside {
  float toward_x, toward_y;      ///< unit
  float source_x_m, source_y_m;  ///< of its place on the Sun, projected through the limb
};

/// Adds light where it lands: at r (toward) − (source).
///
/// Given  landing_m  r, by photon and wavelength, padded as the last one; light: as many rows; 0
///                   where padded
///        first_row  of the plane, in the tally
void gather(std::span<const Aside> photons, const algebra::Grid<float>& landing_m,
            const algebra::Grid<float>& light, const Rings& rings, std::size_t first_row,
            Tally& tally);

/// Adds the numbers, and their squares, of a tally's touched rows to sums, and empties them.
///
/// Given  sums, squares  (row, wavelength)
void drain(Tally& tally, algebra::Grid<double>& sums, algebra::Grid<double>& squares);

}  // namespace coppermoon::shadow
