// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "algebra/described.h"
#include "algebra/grid.h"
#include "almanac/sky.h"
#include "colour/exposure.h"
#include "colour/registration.h"
#include "colour/tone_curve.h"
#include "povray_scenes/scene_camera.h"
#include "texture/image.h"
#include "uses/picture/camera_colours.h"

namespace coppermoon::uses {

/// Luminance of each pixel of a linear Rec.709 image, in the image's unit. A pixel that is clipped in any channel gets
/// the image's largest channel value.
algebra::Grid<float> luminance_of(const texture::Image& light);

/// Resamples an image so that it lies pixel for pixel over another picture of the given size.
texture::Image resampled(const texture::Image& image, const colour::Similarity& similarity,
                         std::size_t rows, std::size_t columns);

/// A pixel of a photograph, or the mean over a block of its pixels, and the render at the same place.
struct SharedPixel {
  double axis_distance_km;
  glm::dvec3 photo;         ///< photograph's light, in linear Rec.709; 1 saturates
  glm::dvec3 render_cd_m2;  ///< render's light, in linear Rec.709
  bool clipped;             ///< whether the photograph is clipped here
};

/// Difference between a photograph and a render, without pixels that are clipped. If more than half of the
/// photograph's pixels are black, the optional values are left empty, because noise cut off at black brightens means.
struct Difference {
  double from_km = 0, to_km = 0;  ///< range of distances from the shadow's axis
  std::size_t pixels = 0;         ///< number of pixels that are not clipped
  std::size_t clipped = 0;
  std::size_t black = 0;  ///< how many of `pixels` have no light in the photograph
  /// Mean luminance of the photograph relative to that of the render [stops].
  std::optional<double> stops = {};
  std::optional<std::array<double, 2>> photo_uv = {},
                                       render_uv = {};  ///< CIE 1976 u', v' of the mean light
  std::optional<double> delta_e_2000 = {};              ///< mean colour difference, as displayed
};

template <class Field>
void describe(Field&& is, const Difference& difference) {
  namespace unit = algebra::unit;
  const auto part = [](const std::optional<std::array<double, 2>>& uv, std::size_t k) {
    return uv ? std::optional((*uv)[k]) : std::nullopt;
  };
  is.a("Difference", "A step of distance from the shadow's axis, or the whole disc.");
  is("axis_distance_from_km", difference.from_km, unit::kilometres, "least distance from the axis");
  is("axis_distance_to_km", difference.to_km, unit::kilometres, "largest distance from the axis");
  is("pixels", difference.pixels, "number of pixels that are compared, no finer than the render's");
  is("clipped_pixels", difference.clipped, "number of pixels that the photograph clips");
  is("black_pixels", difference.black, "number of pixels that are black in the photograph");
  is("difference_stops", difference.stops, unit::stops,
     "luminance of the photograph over the render's");
  is("photo_u", part(difference.photo_uv, 0), "chromaticity u' of the photograph");
  is("photo_v", part(difference.photo_uv, 1), "chromaticity v' of the photograph");
  is("render_u", part(difference.render_uv, 0), "chromaticity u' of the render");
  is("render_v", part(difference.render_uv, 1), "chromaticity v' of the render");
  is("delta_e_2000", difference.delta_e_2000, "colour difference CIEDE2000");
}

/// Differences in equally wide ranges of distance from the shadow's axis, then the difference over the whole disc.
///
/// Given  exposure  pixel value for a luminance of 1 cd/m²
///        bins      number of ranges
std::vector<Difference> differences(const std::vector<SharedPixel>& pixels, double exposure,
                                    std::size_t bins);

/// How a camera converted light to the values in a photograph.
struct CameraWriting {
  colour::ToneCurve curve;
  CameraColours colours;  ///< camera's colours, with the best-fitting gains
};

/// Fits a camera's tone curve and its gains of red and blue to pixels as displayed.
///
/// The exposure is free. The priors of the gains are the given values, with a standard deviation of 0.3 in ln(gain).
/// Pixels are grouped in steps of the render's light, and each step's median has an error of 3 %. Levels outside
/// colour::least_displayed to most_displayed are ignored, and so is light of which the sky is more than a third. The
/// curve absorbs errors of the render in bright and dark parts, within the range of real cameras. The gains absorb the
/// reddening by the observer's air.
///
/// Given   sky    light of the sky over the Moon, as displayed, that the render does not have
/// Throws  Error  when there are fewer than three steps of light
CameraWriting fitted_writing(const std::vector<SharedPixel>& pixels, const CameraColours& colours,
                             const glm::dvec3& sky = glm::dvec3(0));

/// A photograph compared with a render.
struct Comparison {
  colour::Registration registration;
  double exposure, fitted_exposure;     ///< pixel value for 1 cd/m², as used and as fitted
  std::vector<Difference> differences;  ///< result of differences()
  texture::Image
      render;  ///< render with glow, at the exposure that `exposure` states, as the camera writes it
  std::optional<CameraWriting> writing{};  ///< the camera's tone curve and gains, if fitted
};

/// Settings for comparing a photograph with a render.
struct ComparisonRequest {
  std::optional<colour::Exposure> exposure = {};  ///< the photograph's exposure; fitted if absent
  std::optional<CameraColours> colours =
      {};                 ///< camera's colours; if set, its tone curve and gains are fitted
  double glow = 0;        ///< share of light that optics and air scatter, for colour::with_glow
  std::size_t bins = 12;  ///< number of ranges of distance from the shadow's axis, 1 to 1000
};

/// Registers a rendered frame in a photograph, adds glow and exposure to the frame, and compares the two. If the
/// photograph is finer than the frame, it is averaged over blocks no larger than the frame's pixels, so that noise and
/// detail that the frame cannot show do not count as differences.
///
/// Given   photo        in linear Rec.709; 1 saturates
///         frame        in linear Rec.709 [cd/m²], without glow
///         sky, camera  those with which the frame was rendered
/// Throws  Error  if the camera is not valid or differs from the frame in size; if every pixel is clipped or is black
///                in one of the pictures; if fewer than three levels of light remain to fit a tone curve; also as
///                colour::registered and with_glow
Comparison compared(const texture::Image& photo, const texture::Image& frame,
                    const almanac::SkyState& sky, const povray_scenes::SceneCamera& camera,
                    const ComparisonRequest& request = {});

}  // namespace coppermoon::uses
