// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "algebra/random.h"
#include "baker/surface/small_moon.h"
#include "colour/moon_limb.h"
#include "colour/similarity.h"
#include "surface/albedo_map.h"

namespace coppermoon::colour {

using Luminance = algebra::Grid<float>;

/// The Earth's shadow on the disc: how much of the light is left a way from its middle, both in
/// the disc's radii.
struct Shadow {
  glm::dvec2 middle{0, 0};
  double left_in_umbra = 1;  ///< 1: no shadow

  double light_at(const glm::dvec2& place) const {
    constexpr double umbra = 2.6, penumbra = 4.6;
    const double away = std::hypot(place.x - middle.x, place.y - middle.y);
    const double out = std::clamp((away - umbra) / (penumbra - umbra), 0., 1.);
    const double in_umbra = left_in_umbra * (0.3 + away / umbra);
    return left_in_umbra == 1 ? 1 : std::max(std::min(in_umbra, 1.), out * out);
  }
};

/// The Moon as a function on its disc, seen from far above a longitude, north up; x and y in its
/// radii, y down.
class Moon {
 public:
  explicit Moon(Shadow shadow = {}, double longitude_deg = 0)
      : shadow_(shadow), longitude_(algebra::degrees(longitude_deg)) {}

  double operator()(const glm::dvec2& place) const {
    static const auto map = surface::small_moon(256);
    const double squared = place.x * place.x + place.y * place.y;
    if (squared >= 1) return 0;
    const double depth = std::sqrt(1 - squared);
    return shadow_.light_at(place) *
           surface::sampled(map, {algebra::radians(std::asin(-place.y)),
                                  longitude_ + algebra::radians(std::atan2(place.x, depth))});
  }

 private:
  Shadow shadow_;
  algebra::Angle longitude_;
};

/// A picture of it, each pixel the mean of 3 × 3 rays.
///
/// Given  to_picture  from the disc's own coordinates to pixels
inline Luminance drawn(const Moon& moon, const Similarity& to_picture, std::size_t rows,
                       std::size_t columns) {
  constexpr int rays = 3;
  const auto back = inverse(to_picture);
  const auto corner = moved(back, {0, 0}), across = moved(back, {1, 0}) - corner,
             down = moved(back, {0, 1}) - corner;
  Luminance picture(rows, columns);
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < columns; ++c) {
      double sum = 0;
      for (int i = 0; i < rays * rays; ++i)
        sum += moon(corner + (static_cast<double>(c) + (i % rays + 0.5) / rays) * across +
                    (static_cast<double>(r) + (i / rays + 0.5) / rays) * down);
      picture(r, c) = static_cast<float>(sum / (rays * rays));
    }
  return picture;
}

/// By a Gaussian both ways.
inline Luminance blurred(const Luminance& picture, double sigma_px) {
  if (sigma_px <= 0) return picture;
  const int reach = static_cast<int>(std::ceil(4 * sigma_px));
  const auto pass = [&](const Luminance& from, bool across) {
    Luminance to(from.rows(), from.columns());
    for (std::size_t r = 0; r < to.rows(); ++r)
      for (std::size_t c = 0; c < to.columns(); ++c) {
        double sum = 0, weights = 0;
        for (int i = -reach; i <= reach; ++i) {
          const double weight = std::exp(-0.5 * i * i / (sigma_px * sigma_px));
          weights += weight;
          const auto row = static_cast<std::ptrdiff_t>(r) + (across ? 0 : i),
                     column = static_cast<std::ptrdiff_t>(c) + (across ? i : 0);
          if (row < 0 || column < 0 || row >= static_cast<std::ptrdiff_t>(to.rows()) ||
              column >= static_cast<std::ptrdiff_t>(to.columns()))
            continue;
          sum += weight *
                 double{from(static_cast<std::size_t>(row), static_cast<std::size_t>(column))};
        }
        to(r, c) = static_cast<float>(sum / weights);
      }
    return to;
  };
  return pass(pass(picture, true), false);
}

/// What a camera makes of it.
struct Camera {
  double blur_px = 0;     ///< standard deviation of a Gaussian
  double noise = 0;       ///< standard deviation over the brightest pixel
  double saturation = 1;  ///< over the brightest pixel
  double sky = 0;         ///< over the brightest pixel
};

inline double normal(algebra::Random& random) {
  const double radius = std::sqrt(-2 * std::log(1 - random.uniform()));
  return radius * std::cos(2 * std::numbers::pi * random.uniform());
}

inline Luminance photographed(const Luminance& picture, const Camera& camera,
                              algebra::Random& random) {
  auto photo = blurred(picture, camera.blur_px);
  const double most = *std::ranges::max_element(photo.values());
  for (float& value : photo.values()) {
    const double seen = value / most + camera.sky + camera.noise * normal(random);
    value = static_cast<float>(std::clamp(seen, 0., camera.saturation));
  }
  return photo;
}

}  // namespace coppermoon::colour
