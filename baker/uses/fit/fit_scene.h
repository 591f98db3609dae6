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

/// Size on the Moon of a scene's pixel in the middle of the disc [km].
inline constexpr double fit_pixel_km =
    2 * algebra::in_kilometres(almanac::lunar_radius) / (fit_disc_share * fit_side_px);

/// Least ratio of a channel's light to the brightest channel's light. Cameras do not write smaller ratios.
inline constexpr double least_of_brightest = 0.003;

/// The ground shown by a pixel of a scene. Only pixels well within the limb have one.
struct FitGround {
  std::size_t pixel;  ///< row × columns + column
  glm::dvec3 ground;  ///< unit vector, Moon-fixed
  double sunlit;      ///< light without the shadow; 1 for white ground at 1 au
  double colour;      ///< ground's colour c, as in surface::Ground; 0 for the mean Moon
  std::size_t bin;    ///< step of distance from the shadow's axis
};

/// The Moon at one moment as an observer sees it, in a picture of fit_side_px a side, to be compared with photographs.
struct FitScene {
  almanac::SkyState sky;
  algebra::Grid<float> usual;  ///< luminance for the usual air, for registration
  colour::Disc disc;           ///< in `usual`
  std::vector<FitGround> grounds;
  std::size_t bins = 0;
  std::vector<double> distances_km;    ///< [bin] mean distance from the axis
  algebra::Grid<double> weights;       ///< (X Y Z, band): weights of moonlight seen through the air
  double pixel_rad = 0;                ///< angular size of a pixel
  colour::Image moon;                  ///< for the usual air, in linear Rec.709
  colour::Image glow = {};             ///< from glow_of; empty if not yet computed
  algebra::Grid<double> usual_values;  ///< (bin, channel): light of `moon` / sunlit light
  /// Grid (bin, channel) for each other camera, with the logarithm of light through its filters / light through the
  /// assumed response. Empty if the response is known.
  std::vector<algebra::Grid<double>> by_filters = {};
};

/// Map and light that all scenes of one eclipse share.
struct FitGroundwork {
  algebra::Grid<float> albedo;                    ///< normal albedo
  std::shared_ptr<const surface::Ground> ground;  ///< map of colour and surge; nullptr if uniform
  shadow::Lookup usual;  ///< X, Y, Z of moonlight for the usual air, seen from space
  /// X, Y, Z of moonlight for the usual air, through the assumed response and then through each other camera's filters.
  /// Absent if the response is known.
  std::optional<shadow::Lookup> by_filters = {};
};

/// Light of sunlit ground outside the shadow, converted by rec709_of.
///
/// Given  weights  (X Y Z, band)
std::array<double, 3> sunlight_of(const algebra::Grid<double>& weights);

/// Computes the groundwork for the scenes of an eclipse.
///
/// Given   moon   request for light, map and response
///         skies  in order of time, at most a few minutes apart
///         response_assumed  whether the response is that of another camera, because the camera's is unknown
/// Throws  Error  when no eclipse is under way in any of the skies
FitGroundwork groundwork_of(const MoonRequest& moon, std::span<const almanac::SkyState> skies,
                            bool response_assumed = false);

/// Computes the scene at one moment.
///
/// Given   moon        photometry and response; the rest is ignored
///         groundwork  for the same Moon and eclipse
///         view        observer, and the air above; the frame is ignored
/// Throws  Error       when no eclipse is under way; as view_of
FitScene fit_scene(const MoonRequest& moon, const FitGroundwork& groundwork,
                   const ViewRequest& view, const almanac::SkyState& sky);

/// Glow around a scene's Moon as if the lens scattered all of its light, in linear Rec.709.
colour::Image glow_of(const FitScene& scene);

/// Whether the whole Moon lies within the umbra.
bool lies_in_umbra(const almanac::SkyState& sky);

}  // namespace coppermoon::uses
