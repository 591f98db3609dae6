// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "algebra/grid.h"
#include "almanac/sky.h"
#include "colour/display.h"
#include "shadow/lookup.h"
#include "surface/ground.h"
#include "uses/fit/fitted_light.h"
#include "uses/fit/sky_and_glow.h"
#include "uses/picture/moon.h"
#include "uses/picture/view.h"

namespace coppermoon::uses {

/// Ground well within the disc, that a pixel of the scene shows.
struct FitGround {
  std::size_t pixel;  ///< row × columns + column
  glm::dvec3 ground;  ///< unit vector, Moon-fixed
  double sunlit;      ///< its light without the shadow; 1: a white ground at 1 au
  double colour;      ///< c, as surface::Ground has it; 0: the mean Moon's
  std::size_t bin;    ///< step of distance from the shadow's axis
};

/// The Moon of one moment as a place on Earth sees it, which photographs of it are held against.
struct FitScene {
  almanac::SkyState sky;
  algebra::Grid<float> usual;  ///< its luminance under the usual air, to be recognised by
  std::vector<FitGround> grounds;
  std::size_t bins = 0;
  std::vector<double> distances_km;  ///< [bin] the mean of its grounds
  algebra::Grid<double> weights;  ///< (channel, band): X, Y, Z of moonlight through the air above
  double pixel_rad = 0;           ///< angle that a pixel takes in
  /// Linear Rec.709 of each pixel: what a lens that gave all its light to its glow would make of the Moon
  /// under the usual air
  colour::Image glow;
  algebra::Grid<double>
      usual_values;  ///< (bin, channel), linear Rec.709: that Moon's light over sunlit
};

/// What scenes of one eclipse have in common.
struct FitGroundwork {
  algebra::Grid<float> albedo;                    ///< normal albedo of the ground
  std::shared_ptr<const surface::Ground> ground;  ///< what differs by place; none: nothing
  shadow::Lookup usual;  ///< X, Y, Z of moonlight under the usual air, seen from space
};

/// Linear Rec.709 as renders have it: within its gamut, never below 1e-12.
///
/// Given  xyz  of moonlight, any unit
std::array<double, 3> rec709_of(std::span<const double> xyz);

/// The same of sunlit ground.
///
/// Given  weights  (channel, band): X, Y, Z
std::array<double, 3> sunlight_of(const algebra::Grid<double>& weights);

/// Given   moon   its light as FittedLight takes it, its map
///         skies  in order of time, at most a few minutes apart
/// Throws  Error  when no eclipse is under way at any of them
FitGroundwork groundwork_of(const MoonRequest& moon, std::span<const almanac::SkyState> skies);

/// The scene that photographs of one moment are held against.
///
/// Given   moon        its photometry
///         groundwork  of that moon and eclipse
///         view        the observer, and the air above; the frame is one of its own
/// Throws  Error       as view_of; when no eclipse is under way
FitScene fit_scene(const MoonRequest& moon, const FitGroundwork& groundwork,
                   const ViewRequest& view, const almanac::SkyState& sky);

/// What a photograph of that scene would show were it taken at another moment: the same ground in the
/// same bins, elsewhere in the shadow. A few places stand for all of a bin.
LitBins lit_bins(const FitScene& scene, const almanac::SkyState& sky);

}  // namespace coppermoon::uses
