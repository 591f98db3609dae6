// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "algebra/grid.h"
#include "colour/registration.h"
#include "texture/image.h"
#include "verbs/frame_places.h"

namespace coppermoon::verbs {

/// Luminance of an image of linear Rec.709, in its own unit; what is clipped, in any channel, is as
/// bright as the brightest.
algebra::Grid<float> luminance_of(const texture::Image& light);

/// The value from which on a photograph counts as clipped: all but a hundredth of its largest.
float clipping_value(const texture::Image& photo);

/// An image brought into another picture's geometry.
texture::Image resampled(const texture::Image& image, const colour::Similarity& similarity,
                         std::size_t rows, std::size_t columns);

/// A pixel of a photograph, and what the render has at its place.
struct SharedPixel {
  double axis_distance_km;
  glm::dvec3 photo;         ///< linear Rec.709; 1 saturates
  glm::dvec3 render_cd_m2;  ///< linear Rec.709
  bool clipped;             ///< in the photograph
};

/// All pixels of a photograph where the disc is, or some millionfold of them evenly chosen.
///
/// Given  render  in the photograph's geometry
std::vector<SharedPixel> shared_pixels(const texture::Image& photo, const texture::Image& render,
                                       const FramePlaces& places,
                                       const colour::Similarity& render_to_photo);

/// The exposure that makes the render as bright as the photograph: the median over what is neither
/// clipped nor below a hundredth of the brightest.
///
/// Returned  photograph's value per cd/m²
/// Throws    Error  when there is no such pixel
double fitted_exposure(const std::vector<SharedPixel>& pixels);

/// How pixels of a photograph differ from those of a render, clipped ones left out.
struct Difference {
  double from_km = 0, to_km = 0;  ///< axis distances
  std::size_t pixels = 0, clipped = 0;
  std::optional<double> stops = {};  ///< of the mean luminance, photograph over render
  std::optional<std::array<double, 2>> photo_uv = {},
                                       render_uv = {};  ///< CIE 1976 u', v' of the mean light
  std::optional<double> delta_e_2000 = {};              ///< the mean over the developed pixels
};

/// In so many steps of axis distance, as wide as each other; last the whole disc.
///
/// Given   exposure  photograph's value per cd/m²
std::vector<Difference> differences(const std::vector<SharedPixel>& pixels, double exposure,
                                    std::size_t bins);

}  // namespace coppermoon::verbs
