// SPDX-License-Identifier: MIT
#include "uses/study/comparison_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "colour/similarity.h"
#include "colour/working_space.h"
#include "uses/light/spectral_bands.h"
#include "uses/picture/development.h"

namespace coppermoon::uses {
namespace {

/// The disc with a little sky around it.
texture::Image cut_out(const texture::Image& picture, const colour::Disc& disc) {
  constexpr double most_px = 640, margin = 1.12;
  const double side = std::min(most_px, std::ceil(2 * margin * disc.radius_px));
  const double scale = side / (2 * margin * disc.radius_px);
  const auto pixels = static_cast<std::size_t>(side);
  return resampled(picture, {scale, 0, side / 2 - scale * disc.x_px, side / 2 - scale * disc.y_px},
                   pixels, pixels);
}

double luminance(const texture::Image& image, std::size_t row, std::size_t column) {
  const std::array<double, 3> rgb{image(row, column, 0), image(row, column, 1),
                                  image(row, column, 2)};
  return colour::luminance(picture_space, rgb);
}

/// Colour of a difference: red above 0, blue below, grey at 0.
std::array<float, 3> colour_of(double stops) {
  constexpr double most = 2;
  const auto share = static_cast<float>(std::clamp(stops / most, -1., 1.));
  const float fade = 0.5F * (1 - std::abs(share));
  return {share > 0 ? 0.5F + 0.5F * share : fade, fade, share < 0 ? 0.5F - 0.5F * share : fade};
}

texture::Image difference_of(const texture::Image& photo, const texture::Image& render) {
  constexpr double dark = 1. / 2048;
  texture::Image picture(photo.width, photo.height, {"R", "G", "B"});
  for (std::size_t r = 0; r < photo.height; ++r)
    for (std::size_t c = 0; c < photo.width; ++c) {
      const double seen = luminance(photo, r, c), expected = luminance(render, r, c);
      if (seen < dark || expected < dark) continue;
      const auto pixel = colour_of(std::log2(seen / expected));
      for (std::size_t k = 0; k < 3; ++k) picture(r, c, k) = pixel[k];
    }
  return picture;
}

}  // namespace

texture::Image comparison_sheet(const texture::Image& photo, const texture::Image& render,
                                const colour::Disc& in_photo) {
  const auto seen = cut_out(photo, in_photo), expected = cut_out(render, in_photo);
  const std::array panels{shown({}, 1, seen, picture_space), shown({}, 1, expected, picture_space),
                          difference_of(seen, expected)};
  texture::Image sheet(3 * seen.width, seen.height, {"R", "G", "B"});
  for (std::size_t p = 0; p < panels.size(); ++p)
    for (std::size_t r = 0; r < seen.height; ++r)
      for (std::size_t c = 0; c < seen.width; ++c)
        for (std::size_t k = 0; k < 3; ++k) sheet(r, p * seen.width + c, k) = panels[p](r, c, k);
  return sheet;
}

texture::Image comparison_sheet(const texture::Image& photo, const Comparison& found) {
  return comparison_sheet(photo, found.render, colour::limb_of(luminance_of(photo)).value());
}

}  // namespace coppermoon::uses
