// SPDX-License-Identifier: MIT
#include "uses/picture/limb_pixels.h"

#include "colour/srgb.h"
#include "uses/picture/avif_file.h"

namespace coppermoon::uses {
namespace {

double light_of(double code, bool pq) { return pq ? light_of_pq(code) : colour::srgb_light(code); }

double code_of(double light, bool pq) { return pq ? pq_of_light(light) : colour::srgb_code(light); }

double share_at(const DiscOutline& disc, std::size_t row, std::size_t column) {
  return covered_share(disc, static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5);
}

/// Pixel that lies nearest along the radius and is covered by that share: 1 inwards, 0 outwards. None in a disc of few
/// pixels, or beyond the frame.
std::optional<std::pair<std::size_t, std::size_t>> beside(const DiscOutline& disc,
                                                          const texture::Image& frame,
                                                          std::size_t row, std::size_t column,
                                                          double share) {
  const double x = static_cast<double>(column) + 0.5, y = static_cast<double>(row) + 0.5;
  const double away = std::hypot(disc.x - x, disc.y - y), inwards = share > 0 ? 1 : -1;
  for (const double step : {1., 1.5, 2., 2.5}) {
    const double there_x = x + inwards * step * (disc.x - x) / away,
                 there_y = y + inwards * step * (disc.y - y) / away;
    if ((share > 0 && step > away) || there_x < 0 || there_y < 0) return std::nullopt;
    const std::pair place{static_cast<std::size_t>(there_y), static_cast<std::size_t>(there_x)};
    if (place.first >= frame.height || place.second >= frame.width) return std::nullopt;
    if (share_at(disc, place.first, place.second) == share) return place;
  }
  return std::nullopt;
}

}  // namespace

LimbPixels::LimbPixels(const std::optional<DiscOutline>& disc, const texture::Image& frame,
                       bool sky) {
  if (!disc || frame.channels.size() < 3) return;
  const auto window = window_of(*disc, frame.width, frame.height);
  if (!window) return;
  for (std::size_t r = window->top; r < window->bottom; ++r)
    for (std::size_t c = window->left; c < window->right; ++c) {
      const double share = share_at(*disc, r, c);
      if (share <= 0 || share >= 1) continue;
      const auto ground = beside(*disc, frame, r, c, 1),
                 air = sky ? beside(*disc, frame, r, c, 0) : std::nullopt;
      if (ground && (air || !sky)) pixels_.push_back({r, c, *ground, air, share});
    }
}

texture::Image LimbPixels::with_ground(texture::Image frame) const {
  for (const auto& [row, column, ground, sky, share] : pixels_)
    for (std::size_t k = 0; k < 3; ++k)
      frame(row, column, k) = frame(ground.first, ground.second, k);
  return frame;
}

texture::Image LimbPixels::covered(texture::Image frame) const {
  for (const auto& [row, column, ground, sky, share] : pixels_)
    for (std::size_t k = 0; k < 3; ++k) {
      frame(row, column, k) *= static_cast<float>(share);
      if (sky)
        frame(row, column, k) += static_cast<float>(1 - share) * frame(sky->first, sky->second, k);
    }
  return frame;
}

void LimbPixels::cover(texture::Image& picture, bool pq) const {
  for (const auto& [row, column, ground, sky, share] : pixels_)
    for (std::size_t k = 0; k < 3; ++k) {
      float& code = picture(row, column, k);
      double light = share * light_of(code, pq);
      if (sky) light += (1 - share) * light_of(picture(sky->first, sky->second, k), pq);
      code = static_cast<float>(code_of(light, pq));
    }
}

}  // namespace coppermoon::uses
