// SPDX-License-Identifier: MIT
#include "verbs/light_options.h"

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

void add_solver_options(CLI::App& verb, LightOptions& options) {
  const std::string group = "How light is computed";
  add_flag(verb, "--solver", options.solver,
           "quadrature: without noise; photons: the paper's simulation; auto: the quicker, "
           "or photons where --photons says how many")
      .one_of({"auto", "quadrature", "photons"})
      .in(group);
  add_flag(
      verb, "--trace", options.trace,
      "of photons; each: step by step, as in the paper; marched: step by step, all wavelengths "
      "together; table: by a table of the limb's rays")
      .one_of({"each", "marched", "table"})
      .in(group);
  add_flag(verb, "--photons", options.photons,
           "how many, 1 to 1e12, rounded up to blocks of 1024; 1e6 take minutes with "
           "--trace each, seconds marched, a second by the table; without: until the "
           "tolerance is reached")
      .in(group);
  add_flag(verb, "--seed", options.seed, "of the photons").not_negative().in(group);
  add_flag(verb, "--step-km", options.step_km, "of a photon's path, traced each or marched")
      .in(group);
  add_flag(verb, "--precision", options.precision,
           "of photons that are marched; single: 7 digits, in two thirds of the time; "
           "full: 16")
      .one_of({"single", "full"})
      .in(group);
  add_flag(verb, "--ring-km", options.ring_km, "width of the rings that gather photons").in(group);
  add_flag(verb, "--smoothing-km", options.smoothing_km,
           "standard deviation of the Gaussian that smooths photons; 0: none")
      .in(group);
  add_photon_options(verb, options.photon_files);
}

/// How many photons, where none are asked for: an end to those that a tolerance asks for.
constexpr double most_photons = 1e10;

shadow::Trace trace_of(const LightOptions& options) {
  if (options.trace == "each") return shadow::Trace::each;
  return options.trace == "marched" ? shadow::Trace::marched : shadow::Trace::table;
}

shadow::PhotonSettings photon_settings(const LightOptions& options) {
  const double photons = options.photons.value_or(most_photons);
  algebra::require_within("photons", photons, 1, 1e12);
  shadow::PhotonSettings settings;
  settings.photons = static_cast<std::uint64_t>(photons);
  settings.seed = options.seed;
  settings.trace = trace_of(options);
  settings.rays = options.plan.rays.value_or(settings.rays);
  settings.stepping.step_m = settings.marching.step_m = options.step_km * 1e3;
  settings.marching.precision =
      options.precision == "single" ? photons::Precision::single : photons::Precision::full;
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

/// --quality paper is a word for other flags; --danjon's air stands for all that was seen of such
/// eclipses, scattered light included.
LightOptions meant(LightOptions options) {
  if (options.air.column.danjon && options.scattered_light == "auto")
    options.scattered_light = "off";
  if (options.plan.quality != "paper") return options;
  options.solver = "photons";
  options.trace = "each";
  options.photons = options.photons.value_or(1e7);
  options.plan.bands = options.plan.bands.value_or(200);
  options.plan.leave_out = options.plan.leave_out.value_or("scattered-light");
  return options;
}

shadow::RefractedLight photons_of(const LightOptions& options, const atmosphere::Atmosphere& air,
                                  const shadow::Arrangement& arrangement,
                                  std::span<const double> wavelengths_nm,
                                  const std::optional<shadow::StoppingRule>& enough,
                                  double most = most_photons) {
  ProgressBar bar(options.solver);
  auto settings = photon_settings(options);
  if (!air.symmetric()) settings.sectors = shadow::sectors_around;
  if (!options.photons) {
    settings.enough = enough;
    settings.photons = static_cast<std::uint64_t>(most);
  }
  const auto light = light_of_photons(options.photon_files, air, arrangement, wavelengths_nm,
                                      settings, bar.progress());
  return shadow::smoothed(light, options.smoothing_km * 1e3);
}

constexpr const char* unshadowed_goes_on = " (--unshadowed goes on without one)";

}  // namespace

void require_eclipse(const almanac::Instant& when, const std::string& way_out) {
  const auto convention = eclipse::ShadowConvention::danjon;
  if (eclipse::eclipse_at(when, convention)) return;
  throw algebra::Error(fmt::format(
      "no lunar eclipse at {}; the nearest is greatest at {}{}", almanac::utc_text(when),
      almanac::utc_text(eclipse::nearest_eclipse(when, convention).greatest), way_out));
}

void add_light_options(CLI::App& verb, LightOptions& options) {
  add_air_options(verb, options.air);
  add_flag(verb, "--limb-darkening", options.limb_darkening,
           "of the Sun, by wavelength, on or off; with --atmosphere paper it is off")
      .one_of({"on", "off"})
      .in("The Earth's air");
  add_flag(verb, "--scattered-light", options.scattered_light,
           "sunlight that the air scatters into the shadow, on, off, or where it counts: auto")
      .one_of({"auto", "on", "off"})
      .in("The Earth's air");
  add_flag(verb, "--starlight", options.starlight, "the stars' light on the Moon, on or off")
      .one_of({"on", "off"})
      .in("The Earth's air");
  add_plan_options(verb, options.plan);
  add_solver_options(verb, options);
}

shadow::Arrangement arrangement_of(const LightOptions& options, double sun_distance_m,
                                   std::vector<double> depths_m) {
  const std::string usual = options.air.atmosphere == "paper" ? "off" : "on";
  return {sun_distance_m, std::move(depths_m), options.limb_darkening.value_or(usual) == "on"};
}

shadow::RefractedLight refracted_light(const LightOptions& asked, const atmosphere::Atmosphere& air,
                                       const shadow::Arrangement& arrangement,
                                       std::span<const double> wavelengths_nm,
                                       std::span<const double> axis_distances_m,
                                       std::size_t around) {
  const auto options = meant(asked);
  require_sound(options);
  auto light = [&] {
    if (options.solver == "photons") {
      if (!options.photons)
        throw algebra::Error(
            "photons: none given, allowed 1 to 1e12; only light on a Moon has a tolerance that "
            "says how many");
      return photons_of(options, air, arrangement, wavelengths_nm, {});
    }
    // what a hundredth of the light's tolerance takes, and no places of its own
    auto wish = wish_of(options.plan);
    auto hand = by_hand(options.plan);
    hand.bands = 400, hand.planes = 9, hand.place_error = 3e-5;
    wish.tolerance = std::min(wish.tolerance.value_or(1e-3), 1e-3);
    wish.budget_s = {};
    const auto work =
        plan::plan_for({.limb_darkening = arrangement.limb_darkening, .ellipsoid = false}, wish, {},
                       hand)
            .work;
    ProgressBar bar(options.solver);
    return shadow::by_quadrature(air, arrangement, wavelengths_nm, axis_distances_m,
                                 {.rays = work.rays, .sun_terms = work.sun_terms, .around = around},
                                 bar.progress());
  }();
  if (options.scattered_light == "on") shadow::add_twilight(light, air);
  if (options.starlight == "on") shadow::add_starlight(light);
  return light;
}

ShadowedMoon shadowed_moon(const LightOptions& options, const almanac::SkyState& sky) {
  const auto axis = eclipse::shadow_axis(sky);
  return {eclipse::place_in_shadow(axis, sky.moon_m), algebra::in_metres(axis.sun_distance),
          arrangement_of(options, algebra::in_metres(axis.sun_distance), {}).limb_darkening,
          atmosphere_of(options.air, axis.sun_declination)};
}

namespace {

/// Whether scattered light was left out that may be a twentieth of the error or more.
bool leaves_scattered_light(const plan::Plan& plan) {
  const auto& all = plan.left_out;
  const auto scattered = std::ranges::find(all, "scattered light", &plan::LeftOut::term);
  return scattered != all.end() && scattered->size > plan.error / 20;
}

/// Of luminance: what the quadrature is found to err by; two standard errors of photons.
double found_error(const ShadowedMoon& moon, const Moonlight& light) {
  const auto weights = at_wavelengths(luminance_weights(), light.plan.work.bands);
  const auto luminance = light.in_sums(weights, light.range);
  if (light.plan.work.method == plan::Method::quadrature || !light.plan.work.refracted)
    return error_found(moon, light.plan.work, luminance, leaves_scattered_light(light.plan));
  const auto distances = distances_over_the_disc(moon);
  return 2 * luminance.worst_relative_error(*light.refracted, weights, distances.front(),
                                            distances.back());
}

plan::Method method_of(const LightOptions& options) {
  switch (trace_of(options)) {
    case shadow::Trace::each:
      return plan::Method::literal;
    case shadow::Trace::marched:
      return plan::Method::marched;
    default:
      return plan::Method::table;
  }
}

plan::Plan plan_of(const LightOptions& options, const ShadowedMoon& moon, const Purpose& purpose) {
  auto scene = scene_of(moon, purpose);
  auto hand = by_hand(options.plan);
  if (options.scattered_light == "off") scene.without_scattered = 0;
  hand.scattered_light = options.scattered_light == "on";
  hand.photons = options.photons;
  if (options.solver == "quadrature") hand.method = plan::Method::quadrature;
  if (wants_photons(options)) hand.method = method_of(options);
  const auto wish = wish_of(options.plan);
  return plan::plan_for(scene, wish, this_machine(), hand);
}

shadow::RefractedLight light_of_work(const LightOptions& options, const ShadowedMoon& moon,
                                     const plan::Plan& plan,
                                     const shadow::Arrangement& arrangement) {
  const auto waves = wavelengths_nm(plan.work.bands);
  const auto distances = distances_over_the_disc(moon);
  if (!plan.work.refracted) return shadow::darkness(arrangement, waves, distances, 1);
  const auto air = air_for(plan.work, moon);
  if (plan.work.method == plan::Method::quadrature) {
    ProgressBar bar("quadrature");
    return shadow::by_quadrature(air, arrangement, waves, distances,
                                 quadrature_for(plan.work, moon), bar.progress());
  }
  const auto weights = at_wavelengths(luminance_weights(), plan.work.bands);
  const auto row = weights.row(0);
  auto limited = options;
  if (options.plan.budget && !options.photons) limited.photons = plan.work.photons;
  // who asked for none does not wait until the darkest sector has enough of them
  const double most = wants_photons(options) ? most_photons : std::max(1e6, 16 * plan.work.photons);
  return photons_of(
      limited, air, arrangement, waves,
      shadow::StoppingRule{
          {row.begin(), row.end()}, plan.tolerance, distances.front(), distances.back()},
      most);
}

}  // namespace

shadow::Lookup Moonlight::in_sums(const shadow::ChannelWeights& weights,
                                  const shadow::LookupRange& within, shadow::LightPart part) const {
  if (!refracted) return shadow::Lookup(weights, part);
  return shadow::Lookup(*refracted, *direct, weights, within, part);
}

shadow::Lookup Moonlight::in_channels(const shadow::ChannelWeights& weights) const {
  return in_sums(at_wavelengths(weights, plan.work.bands), range);
}

plan::Plan planned_light(const LightOptions& asked, const almanac::SkyState& sky, bool unshadowed,
                         const Purpose& purpose) {
  const auto options = meant(asked);
  require_sound(options);
  if (unshadowed) return {};
  require_eclipse(sky.when, unshadowed_goes_on);
  return plan_of(options, shadowed_moon(options, sky), purpose);
}

namespace {

shadow::Arrangement arrangement_of(const LightOptions& options, const ShadowedMoon& moon,
                                   const plan::Work& work) {
  return arrangement_of(options, moon.sun_distance_m, depths_of(moon, work.planes));
}

Moonlight refracted_light_of(const LightOptions& options, const ShadowedMoon& moon,
                             const Purpose& purpose) {
  Moonlight light;
  light.plan = plan_of(options, moon, purpose);
  const auto& work = light.plan.work;
  light.refracted = light_of_work(options, moon, light.plan, arrangement_of(options, moon, work));
  if (light.refracted->photons > 0)
    light.plan.work.photons = static_cast<double>(light.refracted->photons);
  if (work.scattered_light) shadow::add_twilight(*light.refracted, moon.air);
  if (options.starlight == "on") shadow::add_starlight(*light.refracted);
  const auto settings = quadrature_for(work, moon);
  light.range = {light.refracted->axis_distances_m.front(),
                 light.refracted->axis_distances_m.back(),
                 std::clamp(light.plan.tolerance / 10, 1e-5, 1e-3)};
  if (work.method == plan::Method::quadrature) {  // photons are gathered all around
    light.range.first_sector = settings.first_sector;
    light.range.sectors = settings.sectors;
  }
  return light;
}

void add_direct_light(const LightOptions& options, const ShadowedMoon& moon, Moonlight& light) {
  const auto& work = light.plan.work;
  light.direct.emplace(air_for(work, moon), arrangement_of(options, moon, work),
                       wavelengths_nm(work.bands));
}

/// To the metre: other processors round otherwise.
bool are_alike(const shadow::Arrangement& a, const shadow::Arrangement& b) {
  const auto alike = [](double x, double y) { return std::abs(x - y) < 1; };
  return a.limb_darkening == b.limb_darkening &&
         alike(a.sun_distance_m / 1e3, b.sun_distance_m / 1e3) &&
         std::ranges::equal(a.depths_m, b.depths_m, alike);
}

}  // namespace

bool complete(const LightOptions& asked, const ShadowedMoon& moon, Moonlight& light) {
  const auto options = meant(asked);
  const auto& work = light.plan.work;
  if (!are_alike(light.refracted->arrangement, arrangement_of(options, moon, work))) return false;
  add_direct_light(options, moon, light);
  return true;
}

Moonlight light_on_the_moon(const LightOptions& asked, const almanac::SkyState& sky,
                            bool unshadowed, const Purpose& purpose) {
  const auto options = meant(asked);
  const auto moon = shadowed_moon(options, sky);
  require_sound(options);
  if (unshadowed) return {};
  require_eclipse(sky.when, unshadowed_goes_on);
  auto light = refracted_light_of(options, moon, purpose);
  add_direct_light(options, moon, light);
  light.error_found = found_error(moon, light);
  return light;
}

bool wants_photons(const LightOptions& asked) {
  const auto options = meant(asked);
  return options.solver == "photons" || (options.solver == "auto" && options.photons);
}

ShadowedMoon moon_on_its_way(const LightOptions& asked, std::span<const almanac::SkyState> skies) {
  const auto options = meant(asked);
  require_sound(options);
  ShadowedMoon moon;
  for (const auto& sky : skies) {
    auto here = shadowed_moon(options, sky);
    const bool deepest = moon.path.empty() || here.centre.axis_distance < moon.centre.axis_distance;
    auto path = std::move(moon.path);
    path.push_back(here.centre);
    if (deepest) moon = std::move(here);
    moon.path = std::move(path);
  }
  const auto deepest = std::ranges::min_element(
      moon.path, {}, [](const auto& place) { return algebra::in_metres(place.axis_distance); });
  require_eclipse(skies[static_cast<std::size_t>(deepest - moon.path.begin())].when,
                  unshadowed_goes_on);
  return moon;
}

Moonlight light_on_the_way(const LightOptions& asked, const ShadowedMoon& moon,
                           const Purpose& purpose) {
  const auto options = meant(asked);
  auto light = refracted_light_of(options, moon, purpose);
  add_direct_light(options, moon, light);
  light.error_found = found_error(moon, light);
  return light;
}

std::optional<shadow::LookupRange> range_at(const Moonlight& light, const almanac::SkyState& sky) {
  const ShadowedMoon moon{.centre =
                              eclipse::place_in_shadow(eclipse::shadow_axis(sky), sky.moon_m)};
  const auto distances = distances_over_the_disc(moon);
  auto range = light.range;
  const double depth = algebra::in_metres(moon.centre.depth);
  if (distances.front() >= light.direct->penumbra_m(depth)) return std::nullopt;
  range.from_m = std::max(range.from_m, distances.front());
  range.to_m = std::min(range.to_m, distances.back());
  if (range.sectors < light.refracted->sectors) {
    const auto settings = quadrature_for(light.plan.work, moon);
    range.first_sector = settings.first_sector;
    range.sectors = settings.sectors;
  }
  return range;
}

}  // namespace coppermoon::verbs
