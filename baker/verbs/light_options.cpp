// SPDX-License-Identifier: MIT
#include "verbs/light_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "algebra/error.h"
#include "almanac/instant.h"
#include "colour/cie_observer.h"
#include "eclipse/contacts.h"
#include "eclipse/shadow_axis.h"
#include "shadow/by_photons.h"
#include "shadow/by_quadrature.h"
#include "verbs/progress_bar.h"
#include "verbs/spectral_bands.h"

namespace coppermoon::verbs {
namespace {

constexpr double paper_ozone_du = 345;  // the column of the U.S. Standard Atmosphere 1976
constexpr double quadrature_error = 3e-4;

const CLI::IsMember on_or_off({"on", "off"});

void add_air_options(CLI::App& verb, LightOptions& options) {
  verb.add_option("--atmosphere", options.atmosphere,
                  "paper: with ozone; molecular: without; none: the bare Earth")
      ->check(CLI::IsMember({"paper", "molecular", "none"}))
      ->group("The Earth's air");
  verb.add_option("--refraction", options.refraction, "on or off")
      ->check(on_or_off)
      ->group("The Earth's air");
  verb.add_option("--rayleigh", options.rayleigh, "Rayleigh scattering out of the ray, on or off")
      ->check(on_or_off)
      ->group("The Earth's air");
  verb.add_option("--ozone-du", options.ozone_du,
                  "vertical column of ozone [DU], 0 to 1000; 0: none")
      ->group("The Earth's air");
  verb.add_option("--dust-extinction", options.dust_extinction_per_m,
                  "of the dust layer from 15 to 20 km [1/m]; 1e-6 slight, 4.7e-6 usual, 1e-4 a "
                  "dark eclipse")
      ->group("The Earth's air");
}

void add_solver_options(CLI::App& verb, LightOptions& options) {
  const std::string group = "How light is computed";
  verb.add_option(
          "--solver", options.solver,
          "quadrature: exact for air that is alike all around; photons: the paper's simulation")
      ->check(CLI::IsMember({"quadrature", "photons"}))
      ->group(group);
  verb.add_option("--rays", options.rays, "of the quadrature, for each wavelength")->group(group);
  verb.add_option("--trace", options.trace, "each: every photon step by step")
      ->check(CLI::IsMember({"each"}))
      ->group(group);
  verb.add_option("--photons", options.photons, "how many, 1 to 1e12; 1e6 take minutes")
      ->group(group);
  verb.add_option("--seed", options.seed, "of the photons")
      ->check(CLI::NonNegativeNumber)
      ->group(group);
  verb.add_option("--step-km", options.step_km, "of a photon's path")->group(group);
  verb.add_option("--ring-km", options.ring_km, "width of the rings that gather photons")
      ->group(group);
  verb.add_option("--smoothing-km", options.smoothing_km,
                  "standard deviation of the Gaussian that smooths photons; 0: none")
      ->group(group);
}

shadow::PhotonSettings photon_settings(const LightOptions& options) {
  algebra::require_within("photons", options.photons, 1, 1e12);
  shadow::PhotonSettings settings;
  settings.photons = static_cast<std::uint64_t>(options.photons);
  settings.seed = options.seed;
  settings.stepping.step_m = options.step_km * 1e3;
  settings.ring_width_m = options.ring_km * 1e3;
  return settings;
}

/// What a solver would find only when it is run, or never when the other one is.
void require_sound(const LightOptions& options) {
  photon_settings(options);
  algebra::require_within("smoothing [km]", options.smoothing_km, 0, 2000);
}

/// Planes through the half of the Moon that faces the Sun.
shadow::Arrangement arrangement_of(const almanac::SkyState& sky,
                                   const eclipse::ShadowPlace& centre) {
  const double depth = algebra::in_metres(centre.depth);
  const double radius = algebra::in_metres(almanac::lunar_radius);
  return {algebra::in_metres(eclipse::shadow_axis(sky).sun_distance),
          {depth - radius, depth - radius / 2, depth}};
}

eclipse::ShadowPlace moon_in_shadow(const almanac::SkyState& sky) {
  return eclipse::place_in_shadow(eclipse::shadow_axis(sky), sky.moon_m);
}

/// Axis distances that the Moon's disc takes in, closely spaced; the rest of the shadow is not
/// asked for.
std::vector<double> distances_over_the_disc(const eclipse::ShadowPlace& centre) {
  constexpr double spacing_m = 25e3;
  const double radius = algebra::in_metres(almanac::lunar_radius) + spacing_m;
  const double from = std::max(0., algebra::in_metres(centre.axis_distance) - radius);
  const double to = algebra::in_metres(centre.axis_distance) + radius;
  std::vector<double> distances;
  for (double d = from; d < to + spacing_m; d += spacing_m) distances.push_back(d);
  return distances;
}

void require_eclipse(const almanac::SkyState& sky) {
  const auto convention = eclipse::ShadowConvention::danjon;
  if (eclipse::eclipse_at(sky.when, convention)) return;
  const auto nearest = eclipse::nearest_eclipse(sky.when, convention);
  throw algebra::Error(fmt::format(
      "no lunar eclipse at {}; the nearest is greatest at {} (--unshadowed goes on without one)",
      almanac::utc_text(sky.when), almanac::utc_text(nearest.greatest)));
}

}  // namespace

void add_light_options(CLI::App& verb, LightOptions& options) {
  add_air_options(verb, options);
  add_solver_options(verb, options);
}

atmosphere::Atmosphere atmosphere_of(const LightOptions& options) {
  atmosphere::Atmosphere air;
  if (options.atmosphere == "none") air.top_m = 0;
  air.column.refraction = options.refraction == "on";
  air.column.rayleigh = options.rayleigh == "on";
  air.column.ozone_du =
      options.ozone_du.value_or(options.atmosphere == "paper" ? paper_ozone_du : 0);
  air.column.dust_extinction_per_m = options.dust_extinction_per_m;
  require_valid(air);
  return air;
}

shadow::RefractedLight refracted_light(const LightOptions& options,
                                       const shadow::Arrangement& arrangement,
                                       std::span<const double> wavelengths_nm,
                                       std::span<const double> axis_distances_m) {
  require_sound(options);
  const auto air = atmosphere_of(options);
  ProgressBar bar(options.solver);
  if (options.solver == "quadrature")
    return shadow::by_quadrature(air, arrangement, wavelengths_nm, axis_distances_m, options.rays,
                                 bar.progress());
  const auto light = shadow::by_photons(air, arrangement, wavelengths_nm, photon_settings(options),
                                        bar.progress());
  return shadow::smoothed(light, options.smoothing_km * 1e3);
}

shadow::Lookup Moonlight::in_channels(const shadow::ChannelWeights& weights) const {
  if (!refracted) return shadow::Lookup(weights);
  return shadow::Lookup(*refracted, opaque_radius_m, weights);
}

Moonlight light_on_the_moon(const LightOptions& options, const almanac::SkyState& sky,
                            bool unshadowed) {
  const auto air = atmosphere_of(options);
  if (unshadowed) return {};
  require_eclipse(sky);
  const auto centre = moon_in_shadow(sky);
  return {refracted_light(options, arrangement_of(sky, centre), band_centres_nm(),
                          distances_over_the_disc(centre)),
          air.top_radius_m()};
}

double relative_error(const LightOptions& options, const almanac::SkyState& sky,
                      const Moonlight& light) {
  if (!light.refracted) return 0;
  if (options.solver == "quadrature") return quadrature_error;
  const auto xyz = colour::xyz_weights(band_edges_nm());
  shadow::ChannelWeights luminance(1, xyz.columns());
  std::copy(xyz.row(1).begin(), xyz.row(1).end(), luminance.row(0).begin());
  const double centre = algebra::in_metres(moon_in_shadow(sky).axis_distance);
  const double radius = algebra::in_metres(almanac::lunar_radius);
  return light.in_channels(moonlight_weights(luminance))
      .worst_relative_error(0, std::max(0., centre - radius), centre + radius);
}

}  // namespace coppermoon::verbs
