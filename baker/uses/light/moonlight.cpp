// SPDX-License-Identifier: MIT
#include "uses/light/moonlight.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "algebra/error.h"
#include "almanac/calendar.h"
#include "eclipse/contacts.h"
#include "eclipse/shadow_axis.h"
#include "shadow/by_quadrature.h"
#include "shadow/twilight.h"
#include "uses/light/photon_file.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses {
namespace {

/// Largest number of photons that a tolerance may ask for.
constexpr double most_photons = 1e10;

shadow::PhotonSettings photon_settings(const LightRequest& request) {
  const double photons = request.photons.value_or(most_photons);
  algebra::require_within("photons", photons, 1, 1e12);
  shadow::PhotonSettings settings;
  settings.photons = static_cast<std::uint64_t>(photons);
  settings.seed = request.seed;
  settings.literal = request.solver == Solver::literal;
  settings.rays = request.by_hand.rays.value_or(settings.rays);
  settings.stepping.step_m = request.step_km * 1e3;
  settings.ring_width_m = request.ring_km * 1e3;
  return settings;
}

/// Refuses settings of a solver before it runs, also those of the solver that is not used.
void require_sound(const LightRequest& request) {
  photon_settings(request);
  require_knobs(request.by_hand);
  if (!plan::traces_photons(request.solver) && request.photon_files.asked_for())
    throw algebra::Error("parts of photons, kept and added ones need the solver photons");
  algebra::require_within("smoothing [km]", request.smoothing_km, 0, 2000);
}

std::optional<shadow::PhotonSums> added(const std::vector<std::filesystem::path>& paths) {
  std::optional<shadow::PhotonSums> all;
  for (const auto& path : paths) {
    auto sums = read_sums(path);
    try {
      all = all ? merged(std::move(*all), sums) : std::move(sums);
    } catch (const algebra::Error& error) {
      throw algebra::Error(fmt::format("{}: {}", path.string(), error.what()));
    }
  }
  return all;
}

/// Input of a solver: air, planes, wavelengths.
struct Rig {
  const atmosphere::Atmosphere& air;
  const shadow::Arrangement& arrangement;
  std::span<const double> wavelengths_nm;
};

/// Photons of the shard that is asked for, with the sums of files added; the sums are kept where a file is named.
shadow::RefractedLight light_of_photons(const PhotonFiles& files, const Rig& rig,
                                        shadow::PhotonSettings settings,
                                        const algebra::Progress& progress) {
  settings.key = files.key;
  if (files.shard)
    settings.blocks =
        shadow::shard(shadow::blocks_of(settings.photons), files.shard->part, files.shard->parts);
  const auto before = added(files.add);
  const auto sums = shadow::traced(rig.air, rig.arrangement, rig.wavelengths_nm, settings,
                                   before ? &*before : nullptr, progress);
  if (!files.keep.empty()) write_sums(files.keep, sums);
  return shadow::estimated(sums);
}

/// Traces photons until the tolerance is met, at most `most`; or as many as are asked for.
shadow::RefractedLight photons_of(const LightRequest& request, const Rig& rig,
                                  const std::optional<shadow::StoppingRule>& enough, double most,
                                  const algebra::Progress& progress) {
  auto settings = photon_settings(request);
  if (!rig.air.symmetric()) settings.sectors = shadow::sectors_around;
  if (!request.photons) {
    settings.enough = enough;
    settings.photons = static_cast<std::uint64_t>(most);
  }
  const auto light = light_of_photons(request.photon_files, rig, settings, progress);
  return shadow::smoothed(light, request.smoothing_km * 1e3);
}

}  // namespace

ScatteredLight scattered_light_of(const LightRequest& request) {
  const bool counted = request.air.column.danjon.has_value();
  const bool automatic = request.scattered_light == ScatteredLight::automatic;
  return counted && automatic ? ScatteredLight::off : request.scattered_light;
}

void require_eclipse(const almanac::Instant& when, const std::string& way_out,
                     almanac::Calendar calendar) {
  const auto convention = eclipse::ShadowConvention::danjon;
  if (eclipse::eclipse_at(when, convention)) return;
  throw algebra::Error(fmt::format(
      "no lunar eclipse at {}; the nearest is greatest at {}{}", almanac::utc_text(when, calendar),
      almanac::utc_text(eclipse::nearest_eclipse(when, convention).greatest, calendar), way_out));
}

shadow::Arrangement arrangement_of(const LightRequest& request, double sun_distance_m,
                                   std::vector<double> depths_m) {
  const bool usual = request.air.atmosphere != "paper";
  return {sun_distance_m, std::move(depths_m), request.limb_darkening.value_or(usual)};
}

shadow::RefractedLight refracted_light(const LightRequest& request,
                                       const atmosphere::Atmosphere& air,
                                       const shadow::Arrangement& arrangement,
                                       const LightGrid& grid, const algebra::Progress& progress) {
  require_sound(request);
  const auto& terms = request.by_hand.terms;
  auto light = [&] {
    if (terms && !terms->refracted)
      return shadow::darkness(arrangement, grid.wavelengths_nm, grid.axis_distances_m,
                              air.symmetric() ? 1 : grid.around);
    if (plan::traces_photons(request.solver)) {
      if (!request.photons)
        throw algebra::Error(
            "photons: none given, allowed 1 to 1e12; only light on a Moon has a tolerance that "
            "says how many");
      return photons_of(request, {air, arrangement, grid.wavelengths_nm}, {}, most_photons,
                        progress);
    }
    const double tolerance = std::min(request.wish.tolerance.value_or(1e-3), 1e-3);
    const auto work = plan::work_of_rays(tolerance, arrangement.limb_darkening, request.by_hand);
    return shadow::by_quadrature(
        air, arrangement, grid.wavelengths_nm, grid.axis_distances_m,
        {.rays = work.rays, .sun_terms = work.sun_terms, .sectors = {grid.around}}, progress);
  }();
  const bool left_out = terms && !terms->scattered_light;
  if (!left_out && scattered_light_of(request) != ScatteredLight::off)
    shadow::add_twilight(light, air);
  if (request.starlight) shadow::add_starlight(light);
  return light;
}

ShadowedMoon shadowed_moon(const LightRequest& request, const almanac::SkyState& sky) {
  const auto axis = eclipse::shadow_axis(sky);
  return {eclipse::place_in_shadow(axis, sky.moon_m), algebra::in_metres(axis.sun_distance),
          arrangement_of(request, algebra::in_metres(axis.sun_distance), {}).limb_darkening,
          atmosphere_of(request.air, sky)};
}

namespace {

/// Whether scattered light is left out that may be a twentieth of the error or more.
bool leaves_scattered_light(const plan::Plan& plan) {
  const auto& all = plan.left_out;
  const auto scattered = std::ranges::find(all, plan::Term::scattered_light, &plan::LeftOut::term);
  return scattered != all.end() && scattered->size > plan.error / 20;
}

/// Relative error of luminance found on the disc; with photons at least two standard errors.
///
/// Given  twilight  what the light has; none where it was left out
double found_error(const ShadowedMoon& moon, const Moonlight& light,
                   const std::optional<shadow::RefractedLight>& twilight) {
  const auto weights = at_wavelengths(luminance_weights(), light.plan.work.bands);
  const auto luminance = light.in_sums(weights, light.range);
  constexpr double between_places = 1.2;  // light errs by more than where it was looked at
  const double found = between_places * error_found(moon, light.plan.work, luminance,
                                                    {twilight, leaves_scattered_light(light.plan)});
  const auto distances = distances_over_the_disc(moon);
  return std::max(found, 2 * luminance.worst_relative_error(*light.refracted, weights,
                                                            distances.front(), distances.back()));
}

plan::Plan plan_of(const LightRequest& request, const ShadowedMoon& moon, const Purpose& purpose) {
  const auto scattered = scattered_light_of(request);
  auto scene = scene_of(moon, purpose);
  auto hand = request.by_hand;
  if (scattered == ScatteredLight::off) {
    scene.without_scattered = 0;
    if (hand.terms) hand.terms->scattered_light = false;
  }
  hand.scattered_light = scattered == ScatteredLight::on;
  hand.photons = request.photons;
  hand.solver = request.solver;
  if (request.solver == Solver::automatic && request.photons) hand.solver = Solver::table;
  return plan::plan_for(scene, request.wish, this_machine(), hand);
}

shadow::RefractedLight light_of_work(const LightRequest& request, const ShadowedMoon& moon,
                                     const plan::Plan& plan, const shadow::Arrangement& arrangement,
                                     const algebra::Progress& progress) {
  const auto waves = wavelengths_nm(plan.work.bands);
  const auto distances = distances_over_the_disc(moon);
  const auto air = air_for(plan.work, moon);
  if (!plan.work.refracted)
    return shadow::darkness(arrangement, waves, distances, air.symmetric() ? 1 : sectors_of_a_plan);
  if (plan.work.solver == plan::Solver::quadrature)
    return shadow::by_quadrature(air, arrangement, waves, distances,
                                 quadrature_for(plan.work, moon), progress);
  const auto weights = at_wavelengths(luminance_weights(), plan.work.bands);
  const auto row = weights.row(0);
  auto limited = request;
  limited.solver = plan.work.solver;
  if (request.wish.budget_s && !request.photons) limited.photons = plan.work.photons;
  // who asked for none does not wait until the darkest sector has enough of them
  const double most = wants_photons(request) ? most_photons : std::max(1e6, 16 * plan.work.photons);
  const shadow::StoppingRule enough{
      {row.begin(), row.end()}, plan.tolerance, distances.front(), distances.back()};
  return photons_of(limited, {air, arrangement, waves}, enough, most, progress);
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

plan::Plan planned_light(const LightRequest& request, const almanac::SkyState& sky,
                         const Purpose& purpose) {
  const auto moon = shadowed_moon(request, sky);
  require_sound(request);
  require_eclipse(sky.when);
  return plan_of(request, moon, purpose);
}

namespace {

shadow::Arrangement arrangement_of(const LightRequest& request, const ShadowedMoon& moon,
                                   const plan::Work& work) {
  return arrangement_of(request, moon.sun_distance_m, depths_of(moon, work.planes));
}

/// Light without the direct, and the twilight in it; none where it was left out.
struct ShadowLight {
  Moonlight light{};
  std::optional<shadow::RefractedLight> twilight{};
};

ShadowLight shadow_light_of(const LightRequest& request, const ShadowedMoon& moon,
                            const Purpose& purpose, const algebra::Progress& progress) {
  ShadowLight all;
  auto& light = all.light;
  light.plan = plan_of(request, moon, purpose);
  const auto& work = light.plan.work;
  light.refracted =
      light_of_work(request, moon, light.plan, arrangement_of(request, moon, work), progress);
  if (light.refracted->photons > 0)
    light.plan.work.photons = static_cast<double>(light.refracted->photons);
  if (work.scattered_light) {
    all.twilight =
        std::move(shadow::twilight_about(*light.refracted, std::span(&moon.air, 1)).front());
    shadow::add_between(*all.twilight, *light.refracted);
  }
  if (request.starlight) shadow::add_starlight(*light.refracted);
  light.range = {light.refracted->axis_distances_m.front(),
                 light.refracted->axis_distances_m.back(),
                 std::clamp(light.plan.tolerance / 10, 1e-5, 1e-3),
                 quadrature_for(work, moon).sectors.in(light.refracted->sectors)};
  return all;
}

void add_direct_light(const LightRequest& request, const ShadowedMoon& moon, Moonlight& light) {
  const auto& work = light.plan.work;
  light.direct.emplace(air_for(work, moon), arrangement_of(request, moon, work),
                       wavelengths_nm(work.bands));
}

/// Distance rounded to the metre, for processors round differently.
bool are_alike(const shadow::Arrangement& a, const shadow::Arrangement& b) {
  const auto alike = [](double x, double y) { return std::abs(x - y) < 1; };
  return a.limb_darkening == b.limb_darkening &&
         alike(a.sun_distance_m / 1e3, b.sun_distance_m / 1e3) &&
         std::ranges::equal(a.depths_m, b.depths_m, alike);
}

}  // namespace

bool complete(const LightRequest& request, const ShadowedMoon& moon, Moonlight& light) {
  const auto& work = light.plan.work;
  if (!are_alike(light.refracted->arrangement, arrangement_of(request, moon, work))) return false;
  add_direct_light(request, moon, light);
  return true;
}

Moonlight unshadowed_light(const LightRequest& request, const almanac::SkyState& sky) {
  shadowed_moon(request, sky);
  require_sound(request);
  return {};
}

Moonlight light_on_the_moon(const LightRequest& request, const almanac::SkyState& sky,
                            const Purpose& purpose, const algebra::Progress& progress) {
  const auto moon = shadowed_moon(request, sky);
  require_sound(request);
  require_eclipse(sky.when);
  return light_on_the_way(request, moon, purpose, progress);
}

bool wants_photons(const LightRequest& request) {
  return plan::traces_photons(request.solver) ||
         (request.solver == Solver::automatic && request.photons);
}

std::vector<almanac::SkyState> skies_between(const almanac::Instant& from,
                                             const almanac::Instant& to) {
  constexpr double apart_s = 180;
  const double seconds = almanac::seconds_between(from, to);
  const int intervals = std::max(1, static_cast<int>(std::ceil(seconds / apart_s)));
  std::vector<almanac::SkyState> skies;
  for (int i = 0; i <= intervals; ++i)
    skies.push_back(almanac::sky_at(almanac::later(from, seconds * i / intervals)));
  return skies;
}

ShadowedMoon moon_on_its_way(const LightRequest& request,
                             std::span<const almanac::SkyState> skies) {
  require_sound(request);
  ShadowedMoon moon;
  for (const auto& sky : skies) {
    auto here = shadowed_moon(request, sky);
    const bool deepest = moon.path.empty() || here.centre.axis_distance < moon.centre.axis_distance;
    auto path = std::move(moon.path);
    path.push_back(here.centre);
    if (deepest) moon = std::move(here);
    moon.path = std::move(path);
  }
  const auto deepest = std::ranges::min_element(
      moon.path, {}, [](const auto& place) { return algebra::in_metres(place.axis_distance); });
  require_eclipse(skies[static_cast<std::size_t>(deepest - moon.path.begin())].when);
  return moon;
}

Moonlight light_on_the_way(const LightRequest& request, const ShadowedMoon& moon,
                           const Purpose& purpose, const algebra::Progress& progress) {
  auto [light, twilight] = shadow_light_of(request, moon, purpose, progress);
  add_direct_light(request, moon, light);
  if (purpose.error_told) light.error_found = found_error(moon, light, twilight);
  if (light.refracted->photons > 0) light.plan.work.rays = photon_settings(request).rays;
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
  range.sectors = quadrature_for(light.plan.work, moon).sectors;
  return range;
}

}  // namespace coppermoon::uses
