// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/App.hpp>
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
#include "verbs/photon_options.h"

namespace coppermoon::verbs {

/// Sun, Earth and air, and how light is sent through them.
struct LightOptions {
  AirOptions air;
  std::optional<std::string> limb_darkening;  ///< without: on, but for the paper's atmosphere
  std::string scattered_light = "off", starlight = "off";
  std::string solver = "quadrature", trace = "table";
  int rays = 300;
  double photons = 1e6, step_km = 1, ring_km = 50, smoothing_km = 0;
  std::uint64_t seed = 1;
  PhotonOptions photon_files;
};

void add_light_options(CLI::App& verb, LightOptions& options);

/// The Sun's disc, uniform or not, over planes behind the Earth.
shadow::Arrangement arrangement_of(const LightOptions& options, double sun_distance_m,
                                   std::vector<double> depths_m);

/// Refracted light by the solver chosen, with a progress bar; scattered light and starlight are
/// added to it where they are on.
///
/// Given  axis_distances_m  for the quadrature; photons gather in rings of their own
shadow::RefractedLight refracted_light(const LightOptions& options,
                                       const atmosphere::Atmosphere& air,
                                       const shadow::Arrangement& arrangement,
                                       std::span<const double> wavelengths_nm,
                                       std::span<const double> axis_distances_m);

/// The light that falls on the Moon's sphere; without `refracted` it is sunlight, as if the Earth were
/// away.
struct Moonlight {
  std::optional<shadow::RefractedLight> refracted;
  std::optional<shadow::DirectLight> direct;

  /// Given  weights  (channel, band)
  shadow::Lookup in_channels(const shadow::ChannelWeights& weights) const;
};

/// Given   unshadowed  as if the Earth were away
/// Throws  Error       when the Moon is not in the Earth's shadow at that moment, unless
///                     unshadowed: names the nearest eclipse
Moonlight light_on_the_moon(const LightOptions& options, const almanac::SkyState& sky,
                            bool unshadowed);

/// The worst relative error of luminance on the Moon's disc: the quadrature's own, or one standard
/// error of the photons; 1 where too few of them landed to know.
double relative_error(const LightOptions& options, const almanac::SkyState& sky,
                      const Moonlight& light);

}  // namespace coppermoon::verbs
