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

/// Moon in the shadow, at one moment or on its path, with Sun and air.
struct ShadowedMoon {
  eclipse::ShadowPlace centre{};
  double sun_distance_m = 0;
  bool limb_darkening = true;
  atmosphere::Atmosphere air{};
  std::vector<eclipse::ShadowPlace> path{};  ///< of the centre; empty: one moment
};

/// Purpose of the light, for its cost.
struct Purpose {
  double texels = 0;       ///< that are baked; 0: no texture
  bool map_file = false;   ///< an albedo map is read from a file
  bool error_told = true;  ///< the error that the light has is found
};

/// Refuses knobs set by hand that are outside their ranges.
///
/// Throws  Error
void require_knobs(const plan::ByHand& by_hand);

/// Depths of planes through the half of the Moon that faces the Sun; for a path, equally dense over all its depths.
std::vector<double> depths_of(const ShadowedMoon& moon, int planes);

/// Axis distances at most 200 km apart, from before the disc to behind it.
std::vector<double> distances_over_the_disc(const ShadowedMoon& moon);

/// Air without the terms that some work leaves out (plan::Work).
atmosphere::Atmosphere air_for(const plan::Work& work, const ShadowedMoon& moon);

/// Sectors of all position angles, between which light runs on cubics. Of a plan of reference quality, deep in the
/// umbra, 48 leave 7e-4, 64 3e-4, 96 2e-4, other errors among them.
inline constexpr std::size_t sectors_of_a_plan = 96;

/// Settings of the quadrature, with the sectors that the disc takes in and one more on either side.
///
/// Given  around  sectors of all position angles
shadow::QuadratureSettings quadrature_for(const plan::Work& work, const ShadowedMoon& moon,
                                          std::size_t around = sectors_of_a_plan);

/// Scene for the planner; the size of each term is found at a few places, coarsely.
plan::Scene scene_of(const ShadowedMoon& moon, const Purpose& purpose);

/// Speed of this machine, by a small quadrature that is timed.
plan::Machine this_machine();

/// Weights of wavelengths that give luminance.
shadow::ChannelWeights luminance_weights();

/// Scattered light in a check of the error.
struct ScatteredInCheck {
  std::optional<shadow::RefractedLight>
      computed{};       ///< what the light has (shadow::twilight_about): taken as true
  bool counts = false;  ///< where none was computed, it is part of the error
};

/// Largest relative error of luminance at sample places, against light with all terms and finer settings (plan::finer).
/// Places lie evenly over the disc, where direct light begins, and where light is least smooth, at the depth farthest
/// from all planes. Within one node of the look-up (1 km) of the beginning of all light, the error is no measure.
///
/// Given  luminance  one channel, luminance_weights
double error_found(const ShadowedMoon& moon, const plan::Work& work,
                   const shadow::Lookup& luminance, const ScatteredInCheck& scattered);

}  // namespace coppermoon::uses
