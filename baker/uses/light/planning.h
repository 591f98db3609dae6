// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "almanac/sky.h"
#include "atmosphere/atmosphere.h"
#include "eclipse/shadow_axis.h"
#include "plan/plan.h"
#include "shadow/by_quadrature.h"
#include "shadow/lookup.h"

namespace coppermoon::uses {

/// The Moon as it stands in the shadow, under what Sun and air; or as it goes through it.
struct ShadowedMoon {
  eclipse::ShadowPlace centre{};
  double sun_distance_m = 0;
  bool limb_darkening = true;
  atmosphere::Atmosphere air{};
  std::vector<eclipse::ShadowPlace> path{};  ///< the centre's, where it goes; empty: it stands
};

/// What is made of its light.
struct Purpose {
  double texels = 0;      ///< that are baked; 0: no texture
  bool map_file = false;  ///< an albedo map is read from a file
};

/// Refuses knobs set by hand that are outside their ranges.
///
/// Throws  Error
void require_knobs(const plan::ByHand& by_hand);

/// Planes through the half of the Moon that faces the Sun, as many as asked for; where it goes, as
/// close through all that it takes up.
std::vector<double> depths_of(const ShadowedMoon& moon, int planes);

/// A few axis distances, 200 km apart or less, from before its disc to behind it.
std::vector<double> distances_over_the_disc(const ShadowedMoon& moon);

/// The air with some terms left out: see plan::Work.
atmosphere::Atmosphere air_for(const plan::Work& work, const ShadowedMoon& moon);

/// Sectors of all position angles, between which light runs on cubics. Of a plan of reference quality, deep in the
/// umbra, 48 leave 7e-4, 64 3e-4, 96 2e-4, other errors among them.
inline constexpr std::size_t sectors_of_a_plan = 96;

/// The quadrature's settings, and the sectors that the disc takes in, with one more on either side.
///
/// Given  around  sectors of all position angles
shadow::QuadratureSettings quadrature_for(const plan::Work& work, const ShadowedMoon& moon,
                                          std::size_t around = sectors_of_a_plan);

/// What work depends on; how much each term matters is tried at a few places, coarsely.
plan::Scene scene_of(const ShadowedMoon& moon, const Purpose& purpose);

/// How fast this machine is: a small quadrature, timed.
plan::Machine this_machine();

/// The luminance that weights of wavelengths make.
shadow::ChannelWeights luminance_weights();

/// The largest error of luminance that is found at some places of the disc, against all terms computed
/// more finely (plan::finer): evenly over it, where direct light begins, and where light is least smooth;
/// at the depth that is farthest from all planes. A node of the look-up, 1 km, from where all light begins,
/// it is no measure.
///
/// Given  luminance         one channel, luminance_weights
///        scattered_counts  where it was left out, scattered light is part of the error
double error_found(const ShadowedMoon& moon, const plan::Work& work,
                   const shadow::Lookup& luminance, bool scattered_counts);

}  // namespace coppermoon::uses
