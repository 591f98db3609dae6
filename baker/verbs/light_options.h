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

namespace coppermoon::verbs {

/// The Earth's air, term by term, and how light is sent through it.
struct LightOptions {
  std::string atmosphere = "paper", refraction = "on", rayleigh = "on";
  std::optional<double> ozone_du;  ///< without: as the atmosphere has it
  double dust_extinction_per_m = 0;
  std::string solver = "quadrature", trace = "each";
  int rays = 600;
  double photons = 1e6, step_km = 1, ring_km = 50, smoothing_km = 0;
  std::uint64_t seed = 1;
};

void add_light_options(CLI::App& verb, LightOptions& options);

/// Throws Error when a term is outside its range
atmosphere::Atmosphere atmosphere_of(const LightOptions& options);

/// Refracted light by the solver chosen, with a progress bar.
///
/// Given  axis_distances_m  for the quadrature; photons gather in rings of their own
shadow::RefractedLight refracted_light(const LightOptions& options,
                                       const shadow::Arrangement& arrangement,
                                       std::span<const double> wavelengths_nm,
                                       std::span<const double> axis_distances_m);

/// The light that falls on the Moon's sphere; without `refracted` it is sunlight, as if the Earth were
/// away.
struct Moonlight {
  std::optional<shadow::RefractedLight> refracted;
  double opaque_radius_m = 0;  ///< of the Earth with its air, for the direct part

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
