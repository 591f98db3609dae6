// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "almanac/sky.h"
#include "atmosphere/atmosphere.h"
#include "shadow/irradiance.h"
#include "shadow/lookup.h"
#include "verbs/air_options.h"
#include "verbs/flags.h"
#include "verbs/photon_options.h"
#include "verbs/plan_options.h"
#include "verbs/planning.h"

namespace coppermoon::verbs {

/// Sun, Earth and air, and how light is sent through them.
struct LightOptions {
  AirOptions air;
  std::optional<std::string> limb_darkening;  ///< without: on, but for the paper's atmosphere
  std::string scattered_light = "auto", starlight = "off";
  std::string solver = "auto", trace = "table", precision = "full";
  PlanOptions plan;
  std::optional<double> photons;  ///< without: as many as the tolerance asks for
  double step_km = 1, ring_km = 50, smoothing_km = 0;
  std::uint64_t seed = 1;
  PhotonOptions photon_files;
};

void add_light_options(CLI::App& verb, LightOptions& options);

/// The Sun's disc, uniform or not, over planes behind the Earth.
shadow::Arrangement arrangement_of(const LightOptions& options, double sun_distance_m,
                                   std::vector<double> depths_m);

/// The Moon of one moment, in the shadow of that air.
ShadowedMoon shadowed_moon(const LightOptions& options, const almanac::SkyState& sky);

/// Refracted light by the solver chosen, with a progress bar; scattered light and starlight are added
/// to it where they are on. Its rays and the terms of the Sun are those that 0.1 % of light asks for,
/// or a finer tolerance.
///
/// Given  axis_distances_m  for the quadrature; photons gather in rings of their own
///        around            sectors of the quadrature, where light differs around the axis
shadow::RefractedLight refracted_light(const LightOptions& options,
                                       const atmosphere::Atmosphere& air,
                                       const shadow::Arrangement& arrangement,
                                       std::span<const double> wavelengths_nm,
                                       std::span<const double> axis_distances_m,
                                       std::size_t around = shadow::sectors_around);

/// The light that falls on the Moon's sphere; without `refracted` it is sunlight, as if the Earth were
/// away.
struct Moonlight {
  std::optional<shadow::RefractedLight> refracted;
  std::optional<shadow::DirectLight> direct;
  shadow::LookupRange range;
  plan::Plan plan;
  double error_found = 0;  ///< of luminance, the largest at some places of the disc

  /// Given  weights  (channel, band)
  shadow::Lookup in_channels(const shadow::ChannelWeights& weights) const;

  /// Given  weights  (channel, wavelength), of the plan's `wavelengths_nm`
  shadow::Lookup in_sums(const shadow::ChannelWeights& weights, const shadow::LookupRange& within,
                         shadow::LightPart part = shadow::LightPart::all) const;
};

/// Plans and computes it.
///
/// Given   unshadowed  as if the Earth were away
/// Throws  Error       when the Moon is not in the Earth's shadow at that moment, unless
///                     unshadowed: names the nearest eclipse
Moonlight light_on_the_moon(const LightOptions& options, const almanac::SkyState& sky,
                            bool unshadowed, const Purpose& purpose = {});

/// Throws  Error  when no eclipse is under way: names the nearest, and then a way out of it
void require_eclipse(const almanac::Instant& when, const std::string& way_out = {});

/// Whether light is to be photons: whoever says how many wants them.
bool wants_photons(const LightOptions& options);

/// The Moon on its way through the shadow.
///
/// Given   skies  in order of time, at most a few minutes apart
/// Throws  Error  when no eclipse is under way at any of them: names the nearest there is
ShadowedMoon moon_on_its_way(const LightOptions& options, std::span<const almanac::SkyState> skies);

/// The light on all of a Moon's way, from one simulation.
Moonlight light_on_the_way(const LightOptions& options, const ShadowedMoon& moon,
                           const Purpose& purpose);

/// Adds the direct part, to light that was read without.
///
/// Returned  whether it is light on that way
bool complete(const LightOptions& options, const ShadowedMoon& moon, Moonlight& light);

/// What of the light on a Moon's way its disc takes in at one moment; nothing where all is sunlight.
std::optional<shadow::LookupRange> range_at(const Moonlight& light, const almanac::SkyState& sky);

/// What light_on_the_moon would do.
///
/// Throws  Error  as it
plan::Plan planned_light(const LightOptions& options, const almanac::SkyState& sky, bool unshadowed,
                         const Purpose& purpose);

}  // namespace coppermoon::verbs
