// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "almanac/sky.h"
#include "atmosphere/atmosphere.h"
#include "eclipse/shadow_axis.h"
#include "plan/plan.h"
#include "shadow/by_quadrature.h"
#include "shadow/lookup.h"

namespace coppermoon::uses {

/// The Moon in the shadow, at one moment or along its path, with the Sun and the air.
struct ShadowedMoon {
  eclipse::ShadowPlace centre{};
  double sun_distance_m = 0;
  bool limb_darkening = true;
  atmosphere::Atmosphere air{};
  std::vector<eclipse::ShadowPlace> path{};  ///< of the Moon's centre; empty for one moment
};

/// What the light is for, which decides what it may cost.
struct Purpose {
  double texels = 0;       ///< number of texels to bake; 0: no texture
  bool map_file = false;   ///< whether an albedo map is read from a file
  bool error_told = true;  ///< whether the light's error is determined
};

/// Refuses knobs set by hand that are outside their ranges.
///
/// Throws  Error
void require_knobs(const plan::ByHand& by_hand);

/// Sun's disc, and the planes behind the Earth at these depths.
shadow::Arrangement arrangement_of(const ShadowedMoon& moon, std::vector<double> depths_m);

/// Depths of planes through the half of the Moon that faces the Sun. For a path, they cover all its depths as densely.
std::vector<double> depths_of(const ShadowedMoon& moon, int planes);

/// Axis distances at most 200 km apart, covering the disc with a margin on both sides.
std::vector<double> distances_over_the_disc(const ShadowedMoon& moon);

/// Air without the terms that some work leaves out (plan::Work).
atmosphere::Atmosphere air_for(const plan::Work& work, const ShadowedMoon& moon);

/// Number of sectors around the axis, between which light is interpolated by cubics. In a plan of reference quality,
/// the error deep in the umbra is 7e-4 with 48 sectors, 3e-4 with 64 and 2e-4 with 96, other errors included.
inline constexpr std::size_t sectors_of_a_plan = 96;

/// Settings for the quadrature, with the sectors that the disc covers and one more on either side.
///
/// Given  around  number of sectors around the axis
shadow::QuadratureSettings quadrature_for(const plan::Work& work, const ShadowedMoon& moon,
                                          std::size_t around = sectors_of_a_plan);

/// Scene for the planner. The size of each term is roughly estimated at a few places.
plan::Scene scene_of(const ShadowedMoon& moon, const Purpose& purpose);

/// Speed of this machine, measured by timing a small quadrature.
plan::Machine this_machine();

/// Weights of the wavelengths for luminance.
shadow::ChannelWeights luminance_weights();

/// How a check of the error treats scattered light.
struct ScatteredInCheck {
  std::optional<shadow::RefractedLight>
      computed{};       ///< twilight already in the light (shadow::twilight_about), not checked
  bool counts = false;  ///< if not computed, it is part of the error
};

/// Largest relative error of luminance at sample places, compared with light with all terms and finer settings
/// (plan::finer). The places lie evenly over the disc, where direct light begins, and where light is least smooth, at
/// the depth farthest from all planes. Within one node of the look-up (1 km) of where light begins at all, the error
/// means nothing.
///
/// Given  luminance  one channel, made with luminance_weights
double error_found(const ShadowedMoon& moon, const plan::Work& work,
                   const shadow::Lookup& luminance, const ScatteredInCheck& scattered);

}  // namespace coppermoon::uses
