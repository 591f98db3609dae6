// SPDX-License-Identifier: MIT
// Results that exist only in the Python package.
#pragma once

#include <vector>

#include "algebra/grid.h"
#include "eclipse/seen_sky.h"
#include "plan/plan.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::python {

/// A SeenSky that also gives Python its vectors and its matrix, as arrays.
struct SkyOfArrays : eclipse::SeenSky {};

inline algebra::Grid<double> grid_of(const glm::dmat3& matrix) {
  algebra::Grid<double> grid(3, 3);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      grid(static_cast<std::size_t>(row), static_cast<std::size_t>(column)) = matrix[column][row];
  return grid;
}

inline std::vector<double> vector_of(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

template <class Field>
void describe(Field&& is, const SkyOfArrays& seen) {
  const auto& sky = seen.sky;
  eclipse::describe(is, static_cast<const eclipse::SeenSky&>(seen));
  is("sun_m", vector_of(sky.sun_m), algebra::unit::metres,
     "apparent place of the Sun, geocentric, GCRS axes, shape (3,)");
  is("moon_m", vector_of(sky.moon_m), algebra::unit::metres,
     "apparent place of the Moon, geocentric, GCRS axes, shape (3,)");
  is("selenographic_from_gcrs", grid_of(sky.selenographic_from_gcrs),
     "matrix from GCRS axes to the Moon's: X to longitude 0, Z north, shape (3, 3)");
}

/// The light on the Moon at one moment, for each wavelength separately.
struct LitSphere {
  almanac::Instant instant;
  plan::Work work;
  double error_found = 0;
};

template <class Field>
void describe(Field&& is, const LitSphere& moon) {
  is.a("Moonlight", "Light that falls on the Moon at one moment.");
  is("instant", moon.instant, "the moment, UTC");
  is(
      "wavelengths_nm", [&] { return uses::wavelengths_nm(moon.work.bands); },
      algebra::unit::nanometres, "wavelengths that light was computed at, shape (W,)");
  is("method", name(moon.work.solver), "how it was computed, in words");
  is("error_found", moon.error_found,
     "relative error of luminance that was found, the largest on the disc");
}

}  // namespace coppermoon::python
