// SPDX-License-Identifier: MIT
#include "uses/picture/disc_outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "algebra/number.h"
#include "colour/srgb.h"
#include "povray_scenes/scene_camera.h"
#include "uses/picture/picture_files.h"

namespace coppermoon::uses {
namespace {

/// Area of the part of a pixel on the inner side of a straight line.
///
/// Given  inside  signed distance of the pixel's middle from the line, whose unit normal is (along, across)
double area_inside(double inside, double along, double across) {
  const double a = std::max(std::abs(along), std::abs(across)),
               b = std::min(std::abs(along), std::abs(across));
  const double out = std::abs(inside), corner = (a + b) / 2 - out;
  if (corner <= 0) return inside > 0 ? 1 : 0;
  const double smaller = out <= (a - b) / 2 ? 0.5 - out / a : corner * corner / (2 * a * b);
  return inside > 0 ? 1 - smaller : smaller;
}

using povray_scenes::RenderWindow;

/// Range of the pixels from middle − reach to middle + reach: the first, and one past the last. The range is widened by
/// one pixel on each side, has at least two pixels, and stays within the frame.
std::optional<std::pair<std::size_t, std::size_t>> pixels_about(double middle, double reach,
                                                                std::size_t count) {
  const auto most = static_cast<double>(count);
  const double first = std::floor(middle - reach) - 1, end = std::ceil(middle + reach) + 1;
  if (!(first < most && end > 0)) return std::nullopt;
  return std::pair{static_cast<std::size_t>(std::clamp(first, 0., most - 2)),
                   static_cast<std::size_t>(std::clamp(end, 2., most))};
}

RenderWindow around(const RenderWindow& a, const RenderWindow& b) {
  return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right),
          std::max(a.bottom, b.bottom)};
}

double light_of(double code, bool pq) { return pq ? light_of_pq(code) : colour::srgb_light(code); }

double code_of(double light, bool pq) { return pq ? pq_of_light(light) : colour::srgb_code(light); }

double share_at(const DiscOutline& disc, std::size_t row, std::size_t column) {
  return covered_share(disc, static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5);
}

/// The nearest pixel that the disc covers wholly (share 1) or not at all (share 0), found by going inwards or outwards
/// along the disc's radius. Nothing if the disc has only a few pixels, or if that pixel is outside the frame.
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

/// Derivation: a line of sight v from the camera's place f passes within one lunar radius of the Moon's centre if
/// (|f|² − 1) |v|² < (f·v)². Since v is linear in the pixel's x and y, the Moon's edge is a conic.
std::optional<DiscOutline> disc_outline(const povray_scenes::SceneCamera& camera) {
  const auto sight = povray_scenes::sight_of(camera);
  const auto& round = sight.round_from_flattened;
  const glm::dvec3 from = round * sight.position;
  const glm::dmat3 ray = round * glm::dmat3(sight.across, sight.down, sight.corner);
  const auto conic = glm::transpose(ray) *
                     ((glm::dot(from, from) - 1) * glm::dmat3(1) - glm::outerProduct(from, from)) *
                     ray;
  const double xx = conic[0][0], xy = conic[0][1], yy = conic[1][1],
               determinant = xx * yy - xy * xy;
  if (!(xx > 0 && determinant > 0)) return std::nullopt;
  const double x = (xy * conic[2][1] - yy * conic[2][0]) / determinant,
               y = (xy * conic[2][0] - xx * conic[2][1]) / determinant;
  const double inside = -(conic[2][2] + conic[2][0] * x + conic[2][1] * y);
  const glm::dvec3 middle = sight.corner + x * sight.across + y * sight.down;
  if (!(inside > 0 && glm::dot(middle, sight.position) < 0)) return std::nullopt;
  return DiscOutline{x, y, xx / inside, 2 * xy / inside, yy / inside};
}

double covered_share(const DiscOutline& o, double x, double y) {
  const double dx = x - o.x, dy = y - o.y;
  const double value = o.xx * dx * dx + o.xy * dx * dy + o.yy * dy * dy;
  const double slope_x = 2 * o.xx * dx + o.xy * dy, slope_y = o.xy * dx + 2 * o.yy * dy;
  const double slope = std::hypot(slope_x, slope_y);
  if (slope == 0) return 1;
  return area_inside((1 - value) / slope, slope_x / slope, slope_y / slope);
}

/// The ellipse xx dx² + xy dx dy + yy dy² = 1 is 2 sqrt(yy/d) wide and 2 sqrt(xx/d) high, where d = xx yy − xy²/4.
std::optional<RenderWindow> window_of(const DiscOutline& o, std::size_t width, std::size_t height) {
  if (width < 2 || height < 2) return std::nullopt;
  const double determinant = o.xx * o.yy - o.xy * o.xy / 4;
  const auto across = pixels_about(o.x, std::sqrt(o.yy / determinant), width),
             down = pixels_about(o.y, std::sqrt(o.xx / determinant), height);
  if (!across || !down) return std::nullopt;
  return RenderWindow{across->first, down->first, across->second, down->second};
}

std::optional<RenderWindow> disc_window(std::span<const povray_scenes::SceneCamera> cameras) {
  std::optional<RenderWindow> all;
  for (const auto& camera : cameras) {
    const auto outline = disc_outline(camera);
    if (!outline) return std::nullopt;
    const auto window = window_of(*outline, camera.width, camera.height);
    if (window) all = all ? around(*all, *window) : *window;
  }
  return all;
}

std::string text_of(const DiscOutline& o) {
  return fmt::format("{},{},{},{},{}", o.x, o.y, o.xx, o.xy, o.yy);
}

std::optional<DiscOutline> outline_in(std::string_view text) {
  std::array<double, 5> numbers;
  for (double& number : numbers) {
    const auto comma = std::min(text.find(','), text.size());
    const auto found = algebra::number_in(text.substr(0, comma));
    if (!found) return std::nullopt;
    number = *found;
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  const auto& [x, y, xx, xy, yy] = numbers;
  const bool ellipse = std::isfinite(x + y) && xx > 0 && 4 * xx * yy > xy * xy;
  if (!text.empty() || !ellipse) return std::nullopt;
  return DiscOutline{x, y, xx, xy, yy};
}

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
