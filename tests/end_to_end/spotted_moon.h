// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <vector>

#include "almanac/lunar_orientation.h"
#include "surface/albedo_map.h"
#include "texture/image.h"

namespace coppermoon::end_to_end {

/// A place anyone finds on the Moon, painted as a spot of some albedo.
struct Spot {
  const char* name;
  almanac::SelenographicPoint at;
  float albedo;
};

/// No two are alike in brightness, so that a frame tells which is which.
inline std::array<Spot, 3> spots() {
  using algebra::degrees;
  return {{{"Tycho", {degrees(-43.3), degrees(-11.4)}, 1.F},
           {"Mare Crisium", {degrees(17), degrees(59)}, 0.7F},
           {"Plato", {degrees(51.6), degrees(-9.3)}, 0.45F}}};
}

/// A dark albedo map with the spots on it, each two degrees in radius. Darker ground, brought to
/// the Moon's mean albedo, would make them too bright for half floats.
inline texture::Image spotted_map(std::size_t rows) {
  texture::Image map(2 * rows, rows, {"Y"});
  const double least_cosine = std::cos(2 * std::numbers::pi / 180);
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < 2 * rows; ++c) {
      const auto here = almanac::selenographic_direction(surface::texel_centre(r, c, rows));
      map(r, c, 0) = 0.12F;
      for (const auto& spot : spots())
        if (glm::dot(here, almanac::selenographic_direction(spot.at)) > least_cosine)
          map(r, c, 0) = spot.albedo;
    }
  return map;
}

/// A bright patch of a frame.
struct Blob {
  glm::dvec2 centre{};  ///< pixels from the upper left corner, weighted by light
  double light = 0, brightest = 0;
};

/// Takes the pixels that hang together with one, out of the frame.
inline Blob taken_blob(texture::Image& frame, std::size_t row, std::size_t column, float floor) {
  Blob blob;
  std::vector<std::array<std::size_t, 2>> waiting{{row, column}};
  while (!waiting.empty()) {
    const auto [r, c] = waiting.back();
    waiting.pop_back();
    const double light = frame(r, c, 1);
    if (light <= floor) continue;
    frame(r, c, 1) = 0;
    blob.centre += light * glm::dvec2(static_cast<double>(c) + 0.5, static_cast<double>(r) + 0.5);
    blob.light += light;
    blob.brightest = std::max(blob.brightest, light);
    if (r > 0) waiting.push_back({r - 1, c});
    if (c > 0) waiting.push_back({r, c - 1});
    if (r + 1 < frame.height) waiting.push_back({r + 1, c});
    if (c + 1 < frame.width) waiting.push_back({r, c + 1});
  }
  blob.centre /= blob.light;
  return blob;
}

/// The bright patches of a frame, the brightest first.
inline std::vector<Blob> blobs(texture::Image frame) {
  float most = 0;
  for (std::size_t r = 0; r < frame.height; ++r)
    for (std::size_t c = 0; c < frame.width; ++c) most = std::max(most, frame(r, c, 1));
  std::vector<Blob> found;
  for (std::size_t r = 0; r < frame.height; ++r)
    for (std::size_t c = 0; c < frame.width; ++c)
      if (frame(r, c, 1) > most / 4) found.push_back(taken_blob(frame, r, c, most / 4));
  std::ranges::sort(found, std::greater{}, &Blob::brightest);
  return found;
}

inline texture::Image mirrored(const texture::Image& frame) {
  texture::Image other(frame.width, frame.height, frame.channels);
  for (std::size_t r = 0; r < frame.height; ++r)
    for (std::size_t c = 0; c < frame.width; ++c)
      for (std::size_t k = 0; k < frame.channels.size(); ++k)
        other(r, c, k) = frame(r, frame.width - 1 - c, k);
  return other;
}

}  // namespace coppermoon::end_to_end
