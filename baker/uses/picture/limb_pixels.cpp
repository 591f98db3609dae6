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

}  // namespace

LimbPixels::LimbPixels(const std::optional<DiscOutline>& disc, const texture::Image& frame) {
  if (!disc || frame.channels.size() < 3) return;
  const auto window = window_of(*disc, frame.width, frame.height);
  if (!window) return;
  for (std::size_t r = window->top; r < window->bottom; ++r)
    for (std::size_t c = window->left; c < window->right; ++c) {
      const double share = share_at(*disc, r, c);
      if (share <= 0 || share >= 1) continue;
      if (const auto ground = beside(*disc, frame, r, c)) pixels_.push_back({r, c, *ground, share});
    }
}

texture::Image LimbPixels::with_ground(texture::Image frame) const {
  for (const auto& [row, column, ground, share] : pixels_)
    for (std::size_t k = 0; k < 3; ++k)
      frame(row, column, k) = frame(ground.first, ground.second, k);
  return frame;
}

texture::Image LimbPixels::covered(texture::Image frame) const {
  for (const auto& [row, column, ground, share] : pixels_)
    for (std::size_t k = 0; k < 3; ++k) frame(row, column, k) *= static_cast<float>(share);
  return frame;
}

void LimbPixels::cover(texture::Image& picture, bool pq) const {
  for (const auto& [row, column, ground, share] : pixels_)
    for (std::size_t k = 0; k < 3; ++k) {
      float& code = picture(row, column, k);
      code = static_cast<float>(code_of(share * light_of(code, pq), pq));
    }
}

/// Nearest pixel towards the disc's middle that the Moon covers wholly; none in a disc of few pixels.
std::optional<LimbPixels::Place> LimbPixels::beside(const DiscOutline& disc,
                                                    const texture::Image& frame, std::size_t row,
                                                    std::size_t column) {
  const double x = static_cast<double>(column) + 0.5, y = static_cast<double>(row) + 0.5;
  const double away = std::hypot(disc.x - x, disc.y - y);
  for (const double step : {1., 1.5, 2., 2.5}) {
    const double there_x = x + step * (disc.x - x) / away, there_y = y + step * (disc.y - y) / away;
    if (step > away || there_x < 0 || there_y < 0) return std::nullopt;
    const Place place{static_cast<std::size_t>(there_y), static_cast<std::size_t>(there_x)};
    if (place.first >= frame.height || place.second >= frame.width) return std::nullopt;
    if (share_at(disc, place.first, place.second) == 1) return place;
  }
  return std::nullopt;
}

}  // namespace coppermoon::uses
