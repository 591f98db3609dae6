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

/// A quantity that is linear in the direction of a point from the Moon's centre. Along a row of texels it is
///
///     constant + cosine cos λ + sine sin λ        λ: longitude
struct AlongRow {
  double constant, cosine, sine;
};

/// Geometry of the Moon, Sun and Earth: everything that a texel's light depends on, except albedo and shadow.
struct Globe {
  /// Given  rows               number of rows in the texture
  ///        beyond_the_limb    sine of an angle: lit ground stays dark if the Earth's centre is further than this below
  ///                           its horizon
  Globe(const almanac::SkyState& sky, std::size_t rows, surface::Photometry photometry,
        double beyond_the_limb = std::numeric_limits<double>::infinity());

  /// A vector in the Moon-fixed frame, and a constant that is added to its scalar products.
  struct Direction {
    double x, y, z, constant;
  };
  AlongRow along_row(std::size_t row, const Direction& direction) const;

  std::size_t rows;
  std::vector<double> cos_longitude, sin_longitude;  ///< by column
  Direction sun, moon;  ///< unit vectors from the Moon to the Sun, from the Earth to the Moon
  Direction east, north, depth;   ///< for coordinates in the shadow [m]
  double sun_ratio, earth_ratio;  ///< the Moon's radius / distance to Sun, to Earth
  double sun_cos_earth;           ///< cosine of the angle between `sun` and `moon`
  double earth_sine;              ///< the Earth's radius / its distance
  double inverse_square;          ///< (1 au / distance to the Sun)²
  double beyond_the_limb;
  surface::CosineLaw law;
  std::vector<double> phase_factors;  ///< at even steps of sin(g/2), 0 to 1
  std::vector<double> surge_factors;  ///< derivatives with respect to surge, at the same steps
};

/// Values that the texels of a row share. Pointers into lists by column point to the first texel.
struct TexelRow {
  AlongRow sun, moon, east, north, depth;
  const double *cos_longitude, *sin_longitude;
  const float *albedo, *surge;  ///< surge: nullptr means the mean Moon's
};

/// For each texel, its place in the shadow, and the ratio of its reflected light to that of white ground facing the Sun
/// at 1 au: albedo times photometric function times (1 au / d)².
struct LitTexels {
  std::span<double> reflected, east_m, north_m, depth_m;
};

/// Lights a run of texels in a row.
///
/// Given     column    column of the first texel
///           albedo    normal albedo, one value per texel
///           surge     surge as in surface::Ground, one value per texel; if empty, the mean Moon's
/// Returned  whether light falls on any of them
/// Accuracy  1e-5 of the photometric function, because the phase factor comes from a table
bool light_texels(const Globe& globe, std::size_t row, std::size_t column,
                  std::span<const float> albedo, std::span<const float> surge,
                  const LitTexels& lit);

}  // namespace coppermoon::texture
