// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "almanac/sky.h"
#include "shadow/lookup_table.h"
#include "surface/photometry.h"

namespace coppermoon::texture {

/// Coefficients of a quantity that depends linearly on the direction from the Moon's centre, for one row of texels:
///
///     constant + cosine cos λ + sine sin λ        λ: longitude
struct AlongRow {
  double constant, cosine, sine;
};

/// Geometry of the Moon, Sun and Earth: everything on which a texel's light depends, except albedo and shadow.
struct Globe {
  /// Given  rows               number of rows in the texture
  ///        beyond_the_limb    sine of an angle: texels stay dark if the Earth's centre is further than this angle
  ///                           below their horizon
  Globe(const almanac::SkyState& sky, std::size_t rows, surface::Photometry photometry,
        double beyond_the_limb = std::numeric_limits<double>::infinity());

  /// A vector in the Moon-fixed frame, and a constant to be added to its dot product with another vector.
  struct Direction {
    double x, y, z, constant;
  };
  AlongRow along_row(std::size_t row, const Direction& direction) const;

  std::size_t rows;
  std::vector<double> cos_longitude, sin_longitude;  ///< one value per column
  Direction sun, moon;  ///< unit vectors from the Moon to the Sun and from the Earth to the Moon
  Direction east, north, depth;   ///< give a texel's coordinates in the shadow [m]
  double sun_ratio, earth_ratio;  ///< the Moon's radius / its distance to the Sun and to the Earth
  double sun_cos_earth;           ///< cosine of the angle between `sun` and `moon`
  double earth_sine;              ///< the Earth's radius / its distance to the Moon
  double inverse_square;          ///< (1 au / the Moon's distance to the Sun)²
  double beyond_the_limb;
  surface::CosineLaw law;
  std::vector<double> phase_factors;  ///< table at equal steps of sin(g/2), 0 to 1; g: phase angle
  std::vector<double> surge_factors;  ///< derivatives of phase_factors with respect to the surge
};

/// Inputs for a run of texels in one row. Each pointer points to the value for the first texel of the run.
struct TexelRow {
  AlongRow sun, moon, east, north, depth;
  const double *cos_longitude, *sin_longitude;
  const float *albedo, *surge;  ///< if `surge` is nullptr, the mean Moon's surge is used
};

/// Position of each texel in the shadow, and its reflected light relative to white ground that faces the Sun at 1 au:
/// albedo times photometric function times (1 au / d)², where d is the distance to the Sun.
struct LitTexels {
  std::span<double> reflected, east_m, north_m, depth_m;
};

/// Computes the light that a run of texels in one row reflects.
///
/// Given     column    column of the first texel
///           albedo    normal albedo, one value per texel
///           surge     surge as in surface::Ground, one value per texel; if empty, the mean Moon's surge is used
/// Returned  whether any of the texels is lit
/// Accuracy  1e-5 relative to the exact photometric function, because the phase factor comes from a table
bool light_texels(const Globe& globe, std::size_t row, std::size_t column,
                  std::span<const float> albedo, std::span<const float> surge,
                  const LitTexels& lit);

}  // namespace coppermoon::texture
