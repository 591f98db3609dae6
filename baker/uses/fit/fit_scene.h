// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "algebra/grid.h"
#include "almanac/sky.h"
#include "colour/display.h"
#include "colour/moon_limb.h"
#include "shadow/lookup.h"
#include "surface/ground.h"
#include "uses/fit/sky_and_glow.h"
#include "uses/picture/camera_colours.h"
#include "uses/picture/moon.h"
#include "uses/picture/view.h"

namespace coppermoon::uses {

/// Width of the ground that a pixel of a scene shows in the middle of the disc [km].
inline constexpr double fit_pixel_km =
    2 * algebra::in_kilometres(almanac::lunar_radius) / (fit_disc_share * fit_side_px);

/// Computed channels are raised to this share of the brightest channel, because no camera writes a smaller share.
inline constexpr double least_of_brightest = 0.003;

/// The ground that a pixel of a scene shows. It is known only for pixels well within the limb.
struct FitGround {
  std::size_t pixel;  ///< index of the pixel: row × columns + column
  glm::dvec3 ground;  ///< unit vector to the ground, Moon-fixed
  double sunlit;      ///< light without the shadow, relative to white ground at 1 au
  double colour;      ///< colour of the ground (surface::Ground); 0 for the mean Moon
  std::size_t bin;    ///< index of the pixel's bin; bins are steps of axis distance
};

/// The Moon at one moment as an observer sees it, in a square picture fit_side_px wide, to compare with photographs.
struct FitScene {
  almanac::SkyState sky;
  algebra::Grid<float> usual;  ///< luminance in the air assumed before the fit
  colour::Disc disc;           ///< the Moon's disc in `usual`
  std::vector<FitGround> grounds;
  std::size_t bins = 0;
  std::vector<double> distances_km;    ///< mean distance of each bin from the shadow's axis
  algebra::Grid<double> weights;       ///< weights for moonlight through the air: (X Y Z, band)
  double pixel_rad = 0;                ///< angular size of a pixel
  colour::Image moon;                  ///< the Moon as computed before the fit, linear Rec.709
  colour::Image glow = {};             ///< glow around the Moon; empty if not yet computed
  algebra::Grid<double> usual_values;  ///< ratio of light to full sunlight: (bin, channel)
  /// Derivative of the logarithm of usual_values with respect to the ground's distance from the shadow's axis [1/km]:
  /// (bin, channel).
  algebra::Grid<double> place_slopes = {};
  /// For each camera other than the assumed one, a grid (bin, channel) of ln(light through its filters / light through
  /// the assumed response). Empty if the response is known.
  std::vector<algebra::Grid<double>> by_filters = {};
};

/// Maps and light that all scenes of one eclipse share.
struct FitGroundwork {
  algebra::Grid<float> albedo;                    ///< map of normal albedo
  std::shared_ptr<const surface::Ground> ground;  ///< colour and opposition surge; null if uniform
  shadow::Lookup usual;  ///< X, Y, Z of moonlight in the assumed air, seen from space
  /// X, Y, Z of moonlight in the air assumed before the fit: three channels for the assumed response, then three for
  /// the filters of each other camera. Absent if the response is known.
  std::optional<shadow::Lookup> by_filters = {};
};

/// Light of ground in full sunlight, outside the shadow, in linear Rec.709 within the gamut.
///
/// Given  weights  grid (X Y Z, band) for moonlight
std::array<double, 3> sunlight_of(const algebra::Grid<double>& weights);

/// Computes the maps and light that the scenes of an eclipse share.
///
/// Given   moon   request for light, map and response
///         skies  in order of time, at most a few minutes apart
///         response_assumed  whether the response is that of another camera, because the camera's is unknown
/// Throws  Error  when no eclipse is under way in any of the skies
FitGroundwork groundwork_of(const MoonRequest& moon, std::span<const almanac::SkyState> skies,
                            bool response_assumed = false);

/// Computes the scene at one moment.
///
/// Given   moon        supplies photometry and response; its other members are ignored
///         groundwork  computed for the same Moon and eclipse
///         view        supplies the observer and the air above; its frame is ignored
/// Throws  Error       when no eclipse is under way, or when view_of does
FitScene fit_scene(const MoonRequest& moon, const FitGroundwork& groundwork,
                   const ViewRequest& view, const almanac::SkyState& sky);

/// Glow around the Moon of a scene, in linear Rec.709, for a lens that scatters all of the Moon's light.
colour::Image glow_of(const FitScene& scene);

/// Whether the whole Moon lies within the umbra.
bool lies_in_umbra(const almanac::SkyState& sky);

}  // namespace coppermoon::uses
