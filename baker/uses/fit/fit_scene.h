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
#include "uses/picture/moon.h"
#include "uses/picture/view.h"

namespace coppermoon::uses {

/// Size of a scene's pixel at the middle of the disc.
inline constexpr double fit_pixel_km =
    2 * algebra::in_kilometres(almanac::lunar_radius) / (fit_disc_share * fit_side_px);

/// Least ratio of a channel's light to the brightest channel's: cameras do not write less.
inline constexpr double least_of_brightest = 0.003;

/// The ground shown by one pixel of the scene, well within the limb.
struct FitGround {
  std::size_t pixel;  ///< row × columns + column
  glm::dvec3 ground;  ///< unit vector, Moon-fixed
  double sunlit;      ///< light without the shadow; 1 for white ground at 1 au
  double colour;      ///< colour c as in surface::Ground; 0 for the mean Moon
  std::size_t bin;    ///< step of distance from the shadow's axis
};

/// The Moon at one moment as an observer sees it, fit_side_px on a side, with which photographs are compared.
struct FitScene {
  almanac::SkyState sky;
  algebra::Grid<float> usual;  ///< luminance under the usual air, for registration
  colour::Disc disc;           ///< in `usual`
  std::vector<FitGround> grounds;
  std::size_t bins = 0;
  std::vector<double> distances_km;  ///< [bin] mean distance from the axis
  algebra::Grid<double> weights;     ///< (X Y Z, band): weights of moonlight through the air above
  double pixel_rad = 0;              ///< angular size of a pixel
  colour::Image moon;                ///< under the usual air, linear Rec.709
  colour::Image glow = {};           ///< as glow_of; empty if not computed yet
  algebra::Grid<double> usual_values;  ///< (bin, channel): light of `moon` / sunlit light
  /// (bin, channel) for each other camera: logarithm of the light through its filters over that through the response;
  /// empty if the response is known.
  std::vector<algebra::Grid<double>> by_filters = {};
};

/// Map and light that all scenes of one eclipse share.
struct FitGroundwork {
  algebra::Grid<float> albedo;                    ///< normal albedo
  std::shared_ptr<const surface::Ground> ground;  ///< colour and surge by place; uniform if nullptr
  shadow::Lookup usual;  ///< X, Y, Z of moonlight under the usual air, seen from space
  /// X, Y, Z of the usual light through the response, then through each other camera's filters; absent if the response
  /// is known.
  std::optional<shadow::Lookup> by_filters = {};
};

/// Moonlight in linear Rec.709, brought into the gamut as in renders; 1e-12 or more.
///
/// Given  xyz  of moonlight, in any unit
std::array<double, 3> rec709_of(std::span<const double> xyz);

/// Moonlight of sunlit ground in linear Rec.709, as rec709_of.
///
/// Given  weights  (X Y Z, band)
std::array<double, 3> sunlight_of(const algebra::Grid<double>& weights);

/// Groundwork of an eclipse.
///
/// Given   moon   light as in FittedLight, map
///         skies  in order of time, at most a few minutes apart
///         response_assumed  whether the response stands in for an unknown camera's
/// Throws  Error  when no eclipse is under way at any of them
FitGroundwork groundwork_of(const MoonRequest& moon, std::span<const almanac::SkyState> skies,
                            bool response_assumed = false);

/// Scene at one moment.
///
/// Given   moon        photometry
///         groundwork  for the same Moon and eclipse
///         view        observer, and the air above; its frame is ignored
/// Throws  Error       as view_of; when no eclipse is under way
FitScene fit_scene(const MoonRequest& moon, const FitGroundwork& groundwork,
                   const ViewRequest& view, const almanac::SkyState& sky);

/// Glow of a scene's Moon, as if the lens scattered all its light; linear Rec.709.
colour::Image glow_of(const FitScene& scene);

/// Whether all of the Moon lies within the umbra.
bool lies_in_umbra(const almanac::SkyState& sky);

}  // namespace coppermoon::uses
