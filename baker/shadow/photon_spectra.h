// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "algebra/grid.h"
#include "shadow/padding.h"

namespace coppermoon::shadow {

/// Length of a photon's row for the given number of wavelengths, with padding. Light in the padding is not gathered.
constexpr std::size_t padded(std::size_t waves) { return padded(waves, 16); }

/// Place between two consecutive rows of a table, and a factor by which their weighted mean is multiplied.
struct Between {
  const float* first;
  float along;  ///< place: 0 at the first row, 1 at the next
  float factor = 1;
};

/// Writes each photon's row, interpolated between two rows of a table at the photon's place.
void interpolate(std::span<const Between> places, algebra::Grid<float>& rows);

/// Multiplies each photon's row by a row that is interpolated between two rows of a table at the photon's place.
void multiply(std::span<const Between> places, algebra::Grid<float>& rows);

/// Cells of a plane: rings of axis distance, and one more ring for all light that lands farther out, each divided
/// into sectors. Sector s is centred at the position angle 2π s / sectors.
struct Rings {
  float width_m;
  std::size_t rings, sectors;

  std::size_t rows() const { return sectors * (rings + 1); }
  std::size_t row(double x_m, double y_m) const;
};

/// Light from a block of photons, by cell and wavelength.
struct Tally {
  Tally(std::size_t rows, std::size_t waves) : light(rows, padded(waves)), touched(rows) {}

  algebra::Grid<float> light;
  std::vector<std::uint8_t> touched;  ///< for each row, whether anything was added to it
};

/// Line on which a photon's wavelengths land: direction from the axis, and offset due to the photon's place on the Sun.
struct Aside {
  float toward_x, toward_y;      ///< unit vector from the axis to the limb
  float source_x_m, source_y_m;  ///< photon's source on the Sun, projected through the limb
};

/// Adds light to the cells where it lands, at r × toward − source.
///
/// Given  landing_m  r, indexed by (photon, wavelength), padded with the last wavelength's value
///        light      indexed by (photon, wavelength), padded with 0
///        first_row  first row of the plane in the tally
void gather(std::span<const Aside> photons, const algebra::Grid<float>& landing_m,
            const algebra::Grid<float>& light, const Rings& rings, std::size_t first_row,
            Tally& tally);

/// Adds a tally's touched rows to `sums` and their squares to `squares`, and clears these rows.
///
/// Given  sums, squares  (row, wavelength)
void drain(Tally& tally, algebra::Grid<double>& sums, algebra::Grid<double>& squares);

}  // namespace coppermoon::shadow
