// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "algebra/grid.h"
#include "almanac/sky.h"
#include "atmosphere/observer_air.h"
#include "texture/image.h"

namespace coppermoon::uses {

/// Channels of a texture from which a Moon is measured: photometric_bands, and luminance.
struct Photometer {
  std::vector<std::string> channels;
  algebra::Grid<double> weights;  ///< [channel][band], of moonlight
  std::vector<double> sunlight;   ///< [channel], the Sun's at 1 au
};

/// Given  sightline  through the air above an observer, which dims the Moon; without: above the air
Photometer photometer(const std::optional<atmosphere::Sightline>& sightline = {});

/// Measures of the whole disc.
struct DiscBrightness {
  std::vector<double> magnitudes;  ///< [band]; infinite when nothing is lit
  double mean_luminance_cd_m2;
  double illuminance_lx;  ///< on a surface that faces the Moon
};

/// Given  texture  plate carrée, the photometer's channels
///        from_m   the place it is seen from, geocentric, GCRS axes; the Earth's centre
DiscBrightness measured(const Photometer& photometer, const texture::Image& texture,
                        const almanac::SkyState& sky, const glm::dvec3& from_m = {0, 0, 0});

}  // namespace coppermoon::uses
