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
#include "shadow/twilight.h"
#include "verbs/progress_bar.h"
#include "verbs/spectral_bands.h"

namespace coppermoon::verbs {
namespace {

constexpr double quadrature_error = 1e-3;  // of luminance, at 300 rays

void add_solver_options(CLI::App& verb, LightOptions& options) {
  const std::string group = "How light is computed";
  verb.add_option("--solver", options.solver,
                  "quadrature: without noise; photons: the paper's simulation")
      ->check(CLI::IsMember({"quadrature", "photons"}))
      ->group(group);
  verb.add_option("--rays", options.rays,
                  "from the ground to the top of the air: of the quadrature and of the table")
      ->group(group);
  verb.add_option(
          "--trace", options.trace,
          "of photons; each: step by step, as in the paper; table: by a table of the limb's rays")
      ->check(CLI::IsMember({"each", "table"}))
      ->group(group);
  verb.add_option("--photons", options.photons,
                  "how many, 1 to 1e12, rounded up to blocks of 1024; 1e6 take minutes with "
                  "--trace each, a "
                  "second by the table")
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
  add_photon_options(verb, options.photon_files);
}

shadow::PhotonSettings photon_settings(const LightOptions& options) {
  algebra::require_within("photons", options.photons, 1, 1e12);
  shadow::PhotonSettings settings;
  settings.photons = static_cast<std::uint64_t>(options.photons);
  settings.seed = options.seed;
  settings.trace = options.trace == "table" ? shadow::Trace::table : shadow::Trace::each;
  settings.rays = options.rays;
  settings.stepping.step_m = options.step_km * 1e3;
  settings.ring_width_m = options.ring_km * 1e3;
  return settings;
}

/// What a solver would find only when it is run, or never when the other one is.
void require_sound(const LightOptions& options) {
  photon_settings(options);
  if (options.solver != "photons" && given(options.photon_files))
    throw algebra::Error(
        fmt::format("solver = {}, allowed photons with --shard, --keep or --add", options.solver));
  algebra::require_within("smoothing [km]", options.smoothing_km, 0, 2000);
}

/// Refracted light alone, by the solver chosen.
shadow::RefractedLight solved(const LightOptions& options, const atmosphere::Atmosphere& air,
                              const shadow::Arrangement& arrangement,
                              std::span<const double> wavelengths_nm,
                              std::span<const double> axis_distances_m) {
  ProgressBar bar(options.solver);
  if (options.solver == "quadrature")
    return shadow::by_quadrature(air, arrangement, wavelengths_nm, axis_distances_m, {.rays = options.rays},
                                 bar.progress());
  auto settings = photon_settings(options);
  if (!air.symmetric()) settings.sectors = shadow::sectors_around;
  const auto light = light_of_photons(options.photon_files, air, arrangement, wavelengths_nm,
                                      settings, bar.progress());
  return shadow::smoothed(light, options.smoothing_km * 1e3);
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
  add_air_options(verb, options.air);
  verb.add_option("--limb-darkening", options.limb_darkening,
                  "of the Sun, by wavelength, on or off; with --atmosphere paper it is off")
      ->check(CLI::IsMember({"on", "off"}))
      ->group("The Earth's air");
  verb.add_option("--scattered-light", options.scattered_light,
                  "sunlight that the air scatters into the shadow, on or off")
      ->check(CLI::IsMember({"on", "off"}))
      ->group("The Earth's air");
  verb.add_option("--starlight", options.starlight, "the stars' light on the Moon, on or off")
      ->check(CLI::IsMember({"on", "off"}))
      ->group("The Earth's air");
  add_solver_options(verb, options);
}

shadow::Arrangement arrangement_of(const LightOptions& options, double sun_distance_m,
                                   std::vector<double> depths_m) {
  const std::string usual = options.air.atmosphere == "paper" ? "off" : "on";
  return {sun_distance_m, std::move(depths_m), options.limb_darkening.value_or(usual) == "on"};
}

shadow::RefractedLight refracted_light(const LightOptions& options,
                                       const atmosphere::Atmosphere& air,
                                       const shadow::Arrangement& arrangement,
                                       std::span<const double> wavelengths_nm,
                                       std::span<const double> axis_distances_m) {
  require_sound(options);
  auto light = solved(options, air, arrangement, wavelengths_nm, axis_distances_m);
  if (options.scattered_light == "on") shadow::add_twilight(light, air);
  if (options.starlight == "on") shadow::add_starlight(light);
  return light;
}

shadow::Lookup Moonlight::in_channels(const shadow::ChannelWeights& weights) const {
  if (!refracted) return shadow::Lookup(weights);
  const auto& known_m = refracted->axis_distances_m;
  shadow::LookupRange range{.from_m = known_m.front()};
  if (known_m.size() > 1) range.to_m = known_m.back() + known_m[1] - known_m[0];
  return shadow::Lookup(*refracted, *direct, weights, range);
}

Moonlight light_on_the_moon(const LightOptions& options, const almanac::SkyState& sky,
                            bool unshadowed) {
  const auto axis = eclipse::shadow_axis(sky);
  const auto air = atmosphere_of(options.air, axis.sun_declination);
  if (unshadowed) return {};
  require_eclipse(sky);
  const auto centre = moon_in_shadow(sky);
  // Planes through the half of the Moon that faces the Sun.
  const double depth = algebra::in_metres(centre.depth);
  const double radius = algebra::in_metres(almanac::lunar_radius);
  const auto arrangement = arrangement_of(options, algebra::in_metres(axis.sun_distance),
                                          {depth - radius, depth - radius / 2, depth});
  const auto wavelengths = band_centres_nm();
  return {refracted_light(options, air, arrangement, wavelengths, distances_over_the_disc(centre)),
          shadow::DirectLight(air, arrangement, wavelengths)};
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
