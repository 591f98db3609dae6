// SPDX-License-Identifier: MIT
// How far two frames of one camera are apart, in luminance and in place.
#pragma once

#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>

#include "algebra/grid.h"
#include "end_to_end/luminance.h"
#include "povray_scenes/scene_camera.h"

namespace coppermoon::hand_off {

using Luminances = algebra::Grid<double>;  ///< [row][column]

inline Luminances luminances(const texture::Image& frame) {
  Luminances all(frame.height, frame.width);
  for (std::size_t r = 0; r < frame.height; ++r)
    for (std::size_t c = 0; c < frame.width; ++c) all(r, c) = end_to_end::luminance(frame, r, c);
  return all;
}

/// Pixels from the picture's middle, which is that of the disc.
inline glm::dvec2 from_middle(const Luminances& frame, std::size_t row, std::size_t column) {
  return {static_cast<double>(column) + 0.5 - static_cast<double>(frame.columns()) / 2,
          static_cast<double>(row) + 0.5 - static_cast<double>(frame.rows()) / 2};
}

/// Radius of the disc, in pixels.
inline double radius_px(const povray_scenes::SceneCamera& camera) {
  const double distance = glm::length(camera.position);
  return static_cast<double>(camera.width) / 2 / std::tan(in_radians(camera.horizontal_field) / 2) /
         std::sqrt(distance * distance - 1);
}

/// The part of the pixels more than 2 px inside the limb that differs by more than `relative`.
inline double part_that_differs(const Luminances& frame, const Luminances& reference,
                                double within_px, double relative) {
  double differing = 0, all = 0;
  for (std::size_t r = 0; r < frame.rows(); ++r)
    for (std::size_t c = 0; c < frame.columns(); ++c) {
      if (glm::length(from_middle(frame, r, c)) > within_px - 2) continue;
      const bool near =
          std::abs(frame(r, c) - reference(r, c)) <= relative * std::abs(reference(r, c));
      ++all, differing += near ? 0 : 1;
    }
  return all > 0 ? differing / all : 1;
}

/// Sum over the whole frame [cd/m² px].
inline double total(const Luminances& frame) {
  double sum = 0;
  for (const double value : frame.values()) sum += value;
  return sum;
}

/// Centroid of the light, in pixels from the picture's middle.
inline glm::dvec2 centroid(const Luminances& frame) {
  glm::dvec2 sum{0, 0};
  for (std::size_t r = 0; r < frame.rows(); ++r)
    for (std::size_t c = 0; c < frame.columns(); ++c) sum += frame(r, c) * from_middle(frame, r, c);
  return sum / total(frame);
}

/// By how many pixels a frame is moved against its reference, by least squares over the whole frame:
///
///     frame − reference ≈ −s · ∇reference
inline glm::dvec2 shift(const Luminances& frame, const Luminances& reference) {
  glm::dmat2 normal(0);
  glm::dvec2 right{0, 0};
  for (std::size_t r = 1; r + 1 < frame.rows(); ++r)
    for (std::size_t c = 1; c + 1 < frame.columns(); ++c) {
      const glm::dvec2 slope{(reference(r, c + 1) - reference(r, c - 1)) / 2,
                             (reference(r + 1, c) - reference(r - 1, c)) / 2};
      normal += glm::outerProduct(slope, slope);
      right -= (frame(r, c) - reference(r, c)) * slope;
    }
  return glm::inverse(normal) * right;
}

}  // namespace coppermoon::hand_off
