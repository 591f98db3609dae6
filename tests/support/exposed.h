// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "colour/srgb.h"
#include "texture/image.h"

namespace coppermoon::testing_support {

/// Share of a picture's pixels, in sRGB, that are white: within 2 % of it in each channel.
inline double white_share(const texture::Image& picture) {
  std::size_t white = 0;
  for (std::size_t i = 0; i < picture.values.size(); i += 3)
    white += std::min({picture.values[i], picture.values[i + 1], picture.values[i + 2]}) > 0.98F;
  return 3 * static_cast<double>(white) / static_cast<double>(picture.values.size());
}

/// Difference of codes between the 99th percentile and the 1st.
inline double spread(std::vector<double> codes) {
  std::ranges::sort(codes);
  return codes[codes.size() * 99 / 100] - codes[codes.size() / 100];
}

/// Contrast of a picture: spread of red, in which an eclipsed Moon stands out from a sky.
inline double contrast(const texture::Image& picture) {
  std::vector<double> codes;
  for (std::size_t i = 0; i < picture.values.size(); i += 3)
    codes.push_back(static_cast<double>(picture.values[i]));
  return spread(std::move(codes));
}

/// Contrast that the light of a frame allows: of an exposure that brings the brightest hundredth to white. A sky that is
/// shown at 0.1 of white, 0.08 in red, has by sRGB's curve a quarter of it.
inline double contrast_allowed(const texture::Image& frame) {
  std::vector<double> light;
  for (std::size_t i = 0; i < frame.values.size(); i += 3)
    light.push_back(static_cast<double>(frame.values[i]));
  std::ranges::sort(light);
  const double white = light[light.size() * 99 / 100];
  for (double& value : light) value = colour::srgb_code(std::min(1., value / white));
  return spread(std::move(light));
}

}  // namespace coppermoon::testing_support
