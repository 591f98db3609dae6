// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "algebra/grid.h"
#include "colour/exposure.h"
#include "colour/registration.h"
#include "colour/tone_curve.h"
#include "texture/image.h"
#include "uses/compare/frame_places.h"

namespace coppermoon::uses {

/// Luminance of an image of linear Rec.709, in its own unit; what is clipped, in any channel, is as
/// bright as the brightest.
algebra::Grid<float> luminance_of(const texture::Image& light);

/// Value from which on a photograph counts as clipped: all but a hundredth of its largest.
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

/// Pixels of a photograph where the disc is; of a large photograph evenly chosen ones, as if it had
/// some million pixels in all.
std::vector<SharedPixel> shared_pixels(const texture::Image& photo, const texture::Image& render,
                                       const FramePlaces& places,
                                       const colour::Similarity& render_to_photo);

/// The exposure that makes the render as bright as the photograph: the median over pixels that are
/// neither clipped nor below a hundredth of the brightest.
///
/// Returned  photograph's value of 1 cd/m²
/// Throws    Error  when there is no such pixel
double fitted_exposure(const std::vector<SharedPixel>& pixels);

/// Difference between pixels of a photograph and those of a render, clipped ones left out. Where more than
/// half of the photograph's pixels are black nothing is said: its numbers end above the light.
struct Difference {
  double from_km = 0, to_km = 0;  ///< axis distances
  std::size_t pixels = 0, clipped = 0;
  std::size_t black = 0;             ///< of the pixels, those without light in the photograph
  std::optional<double> stops = {};  ///< mean luminance of the photograph over the render's
  std::optional<std::array<double, 2>> photo_uv = {},
                                       render_uv = {};  ///< CIE 1976 u', v' of the mean light
  std::optional<double> delta_e_2000 = {};              ///< the mean over the developed pixels
};

/// Differences by axis distance, in even steps; the last of them is that of the whole disc.
///
/// Given  exposure  photograph's value of 1 cd/m²
///        bins      how many steps
std::vector<Difference> differences(const std::vector<SharedPixel>& pixels, double exposure,
                                    std::size_t bins);

/// The tone curve of a camera that makes a photograph's light that of a render: exposure and colours are
/// free, light is believed to 3 % where as much of it is rendered. What the render has wrong in bright
/// and dark, the curve takes up as far as cameras differ.
///
/// Given   pixels  light as displayed
/// Throws  Error   when fewer than three steps of light are to be seen
colour::ToneCurve fitted_curve(const std::vector<SharedPixel>& pixels);

/// A photograph beside a render: where it lies, how it was exposed, how the two differ.
struct Comparison {
  colour::Registration registration;
  double exposure, fitted_exposure;     ///< photograph's value of 1 cd/m²: as used, and as fitted
  std::vector<Difference> differences;  ///< as `differences` has them
  texture::Image render;                ///< with glow, of the photograph's exposure, linear Rec.709
  std::optional<colour::ToneCurve> curve{};  ///< that makes the photograph's light the scene's
};

/// What is known of a photograph, and how finely it is compared.
struct ComparisonRequest {
  std::optional<colour::Exposure> exposure = {};  ///< without: the one that suits it best
  bool curved = false;    ///< it has its camera's tone curve, which is found
  double glow = 0;        ///< share of the light that optics and air scattered: colour::with_glow
  std::size_t bins = 12;  ///< steps of axis distance, 1 to 1000
};

/// Registers a rendered frame in a photograph, gives it glow and exposure, and compares the two.
///
/// Given   photo  linear Rec.709, 1 saturates
///         frame  linear Rec.709 [cd/m²], rendered with the camera of its places, without glow
/// Throws  Error  as colour::registered, with_glow, fitted_exposure and fitted_curve; when the frame's size is
///                not its camera's
Comparison compared(const texture::Image& photo, const texture::Image& frame,
                    const FramePlaces& places, const ComparisonRequest& request = {});

}  // namespace coppermoon::uses
