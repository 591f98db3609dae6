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

/// Geometry of the Moon between Sun and Earth: everything on which a texel's light depends but albedo and shadow.
struct Globe {
  /// Given  rows               of the texture
  ///        beyond_the_limb    lit ground is left dark where the Earth's centre is lower than that
  ///                           below its horizon, as the sine of the angle
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
  double sun_ratio, earth_ratio;  ///< the Moon's radius over the distances of Sun and Earth
  double sun_cos_earth;           ///< of the angle between `sun` and `moon`
  double earth_sine;              ///< the Earth's radius over its distance
  double inverse_square;          ///< (1 au / distance of the Sun)²
  double beyond_the_limb;
  surface::CosineLaw law;
  std::vector<double> phase_factors;  ///< even in sin(g/2), 0 to 1
  std::vector<double> surge_factors;  ///< as many: derivative by surge
};

/// Values that the texels of a row share, and the index of the first in the lists by column.
struct TexelRow {
  AlongRow sun, moon, east, north, depth;
  const double *cos_longitude, *sin_longitude;
  const float *albedo, *surge;  ///< surge may be nullptr: the mean Moon's
};

/// Reflected light over that of white ground facing the Sun at 1 au: albedo times photometric function times
/// (1 au / d)²; and places in the shadow.
struct LitTexels {
  std::span<double> reflected, east_m, north_m, depth_m;
};

/// Some texels of a row.
///
/// Given     column    of the first; albedo: normal, as many as there are to be
///           surge     as many, of surface::Ground; or none, where all have the mean Moon's
/// Returned  whether light falls on any
/// Accuracy  1e-5 of the photometric function, from the phase factors' table
bool light_texels(const Globe& globe, std::size_t row, std::size_t column,
                  std::span<const float> albedo, std::span<const float> surge,
                  const LitTexels& lit);

}  // namespace coppermoon::texture
