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

/// The Moon in the shadow, at one moment or along its path, together with the Sun and the Earth's air.
struct ShadowedMoon {
  eclipse::ShadowPlace centre{};
  double sun_distance_m = 0;
  bool limb_darkening = true;
  atmosphere::Atmosphere air{};
  std::vector<eclipse::ShadowPlace> path{};  ///< path of the Moon's centre; empty for one moment
};

/// What the light is used for. The computing time depends on it.
struct Purpose {
  double texels = 0;       ///< number of texels to bake; 0 if there is no texture
  bool map_file = false;   ///< whether an albedo map is read from a file
  bool error_told = true;  ///< whether to determine the light's error
};

/// Refuses settings made by the user that are outside their ranges.
///
/// Throws  Error
void require_knobs(const plan::ByHand& by_hand);

/// Arrangement of the Sun's disc and of planes behind the Earth at the given depths.
shadow::Arrangement arrangement_of(const ShadowedMoon& moon, std::vector<double> depths_m);

/// Depths of planes through the half of the Moon that faces the Sun. For a path, planes with the same spacing cover all
/// depths that this half reaches.
std::vector<double> depths_of(const ShadowedMoon& moon, int planes);

/// Axis distances, at most 200 km apart, that cover the Moon's disc with a margin on both sides.
std::vector<double> distances_over_the_disc(const ShadowedMoon& moon);

/// Air without the terms that the given work leaves out, such as regions or the ellipsoid.
atmosphere::Atmosphere air_for(const plan::Work& work, const ShadowedMoon& moon);

/// Number of sectors around the axis, between which light is interpolated with cubics. In a plan of reference quality,
/// the relative error deep in the umbra is 7e-4 with 48 sectors, 3e-4 with 64 and 2e-4 with 96, other errors included.
inline constexpr std::size_t sectors_of_a_plan = 96;

/// Settings for the quadrature, with the sectors that the disc covers and one more on either side.
///
/// Given  around  number of sectors around the axis
shadow::QuadratureSettings quadrature_for(const plan::Work& work, const ShadowedMoon& moon,
                                          std::size_t around = sectors_of_a_plan);

/// The scene that the planner needs, with a rough estimate of each term's effect at a few places.
plan::Scene scene_of(const ShadowedMoon& moon, const Purpose& purpose);

/// Speed of this machine, measured by timing a small quadrature.
plan::Machine this_machine();

/// Weights of spectral bands of 1 nm (band_edges_nm) for the luminance of moonlight.
shadow::ChannelWeights luminance_weights();

/// How a check of the light's error treats scattered light.
struct ScatteredInCheck {
  std::optional<shadow::RefractedLight>
      computed{};       ///< twilight that the checked light includes; it is not checked itself
  bool counts = false;  ///< whether scattered light, if not computed, counts as error
};

/// Largest relative error of luminance at sample places, in comparison with light that has all terms and finer settings
/// (plan::finer). The places are spread evenly over the disc, with more where light is least smooth. All lie at the
/// depth farthest from the planes. Places without refracted light are ignored within 1 km of where direct sunlight
/// begins. The points of the look-up table are 1 km apart, so errors there mean nothing.
///
/// Given  luminance  one channel, made with luminance_weights
double error_found(const ShadowedMoon& moon, const plan::Work& work,
                   const shadow::Lookup& luminance, const ScatteredInCheck& scattered);

}  // namespace coppermoon::uses
