// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "algebra/grid.h"
#include "almanac/sky.h"
#include "texture/image.h"

namespace coppermoon::uses {

/// What a texture's channels must be for its Moon to be measured: photometric_bands, and luminance.
struct Photometer {
  std::vector<std::string> channels;
  algebra::Grid<double> weights;  ///< [channel][band], of moonlight above the air
  std::vector<double> sunlight;   ///< [channel], the Sun's at 1 au
};

Photometer photometer();

/// The whole disc as seen from the Earth's centre.
struct DiscBrightness {
  std::vector<double> magnitudes;  ///< [band]; infinite when nothing is lit
  double mean_luminance_cd_m2;
};

/// Given  texture  plate carrée, the photometer's channels
DiscBrightness measured(const Photometer& photometer, const texture::Image& texture,
                        const almanac::SkyState& sky);

}  // namespace coppermoon::uses
