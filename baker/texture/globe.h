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

/// A quantity that is linear in a point's direction from the Moon's centre; along a row of texels:
///
///     constant + cosine cos λ + sine sin λ        λ: longitude
struct AlongRow {
  double constant, cosine, sine;
};

/// Geometry of the Moon, Sun and Earth: everything a texel's light depends on except albedo and shadow.
struct Globe {
  /// Given  rows               of the texture
  ///        beyond_the_limb    lit ground stays dark if the Earth's centre is further below its
  ///                           horizon than this, as the sine of the angle
  Globe(const almanac::SkyState& sky, std::size_t rows, surface::Photometry photometry,
        double beyond_the_limb = std::numeric_limits<double>::infinity());

  /// Directions are in the Moon-fixed frame.
  struct Direction {
    double x, y, z, constant;
  };
  AlongRow along_row(std::size_t row, const Direction& direction) const;

  std::size_t rows;
  std::vector<double> cos_longitude, sin_longitude;  ///< [column]
  Direction sun, moon;  ///< unit vectors from the Moon to the Sun, from the Earth to the Moon
  Direction east, north, depth;   ///< the place in the shadow [m]
  double sun_ratio, earth_ratio;  ///< the Moon's radius over the distances to Sun and Earth
  double sun_cos_earth;           ///< of the angle between `sun` and `moon`
  double earth_sine;              ///< the Earth's radius over its distance
  double inverse_square;          ///< (1 au / distance to the Sun)²
  double beyond_the_limb;
  surface::CosineLaw law;
  std::vector<double> phase_factors;  ///< at even steps of sin(g/2), 0 to 1
  std::vector<double> surge_factors;  ///< at the same steps: derivatives by surge
};

/// Values that the texels of a row share, with pointers to the lists by column at the first texel.
struct TexelRow {
  AlongRow sun, moon, east, north, depth;
  const double *cos_longitude, *sin_longitude;
  const float *albedo, *surge;  ///< surge: nullptr for the mean Moon's
};

/// Places in the shadow, and the ratio of reflected light to that of white ground facing the Sun at 1 au: albedo times
/// photometric function times (1 au / d)².
struct LitTexels {
  std::span<double> reflected, east_m, north_m, depth_m;
};

/// Lights some texels of a row.
///
/// Given     column    of the first texel
///           albedo    normal albedo, one value per texel
///           surge     surge as in surface::Ground, one value per texel; if empty, the mean Moon's
/// Returned  whether light falls on any of them
/// Accuracy  1e-5 of the photometric function, from the table of phase factors
bool light_texels(const Globe& globe, std::size_t row, std::size_t column,
                  std::span<const float> albedo, std::span<const float> surge,
                  const LitTexels& lit);

}  // namespace coppermoon::texture
