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

/// Largest number of photons that are traced to reach a tolerance.
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

/// Refuses invalid settings before any solver runs, even those for solvers that are not used.
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

/// Input for a solver: air, planes, wavelengths and places.
struct Rig {
  atmosphere::Atmosphere air;
  shadow::Arrangement arrangement;
  std::vector<double> wavelengths_nm, axis_distances_m;
  shadow::QuadratureSettings settings;

  shadow::RefractedLight darkness() const {
    return shadow::darkness(arrangement, wavelengths_nm, axis_distances_m,
                            air.symmetric() ? 1 : settings.sectors.around);
  }
  shadow::RefractedLight by_quadrature(const algebra::Progress& progress) const {
    return shadow::by_quadrature(air, arrangement, wavelengths_nm, axis_distances_m, settings,
                                 progress);
  }
  shadow::DirectLight direct_light() const { return {air, arrangement, wavelengths_nm}; }
};

/// Traces the requested shard of photons, adds sums from files, writes the sums if requested, and estimates the light.
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

/// Computes light from as many photons as requested. If no number is requested, traces photons until `enough` is
/// satisfied, but at most `most` of them.
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

/// Whether the plan leaves out scattered light that may amount to more than a twentieth of the predicted error.
bool leaves_scattered_light(const plan::Plan& plan) {
  const auto& all = plan.left_out;
  const auto scattered = std::ranges::find(all, plan::Term::scattered_light, &plan::LeftOut::term);
  return scattered != all.end() && scattered->size > plan.error / 20;
}

/// Relative error of luminance on the disc, measured by error_found. For photons it is at least two standard errors.
///
/// Given  twilight  scattered light that `light` includes; nullopt if it includes none
double found_error(const ShadowedMoon& moon, const Moonlight& light,
                   const std::optional<shadow::RefractedLight>& twilight) {
  const auto weights = at_wavelengths(luminance_weights(), light.plan.work.bands);
  const auto luminance = light.in_sums(weights, light.range);
  constexpr double between_places = 1.2;  // errors between the samples may be larger
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

Rig rig_of(const ShadowedMoon& moon, const plan::Work& work) {
  return {air_for(work, moon), arrangement_of(moon, depths_of(moon, work.planes)),
          wavelengths_nm(work.bands), distances_over_the_disc(moon), quadrature_for(work, moon)};
}

shadow::RefractedLight planned_refracted_light(const LightRequest& request, const plan::Plan& plan,
                                               const Rig& rig, const algebra::Progress& progress) {
  if (!plan.work.refracted) return rig.darkness();
  if (plan.work.solver == plan::Solver::quadrature) return rig.by_quadrature(progress);
  const auto weights = at_wavelengths(luminance_weights(), plan.work.bands);
  const auto row = weights.row(0);
  auto limited = request;
  limited.solver = plan.work.solver;
  if (request.wish.budget_s && !request.photons) limited.photons = plan.work.photons;
  // Unless photons are requested, tracing stops at this number of them, even if the darkest sector has too few.
  const double most = wants_photons(request) ? most_photons : std::max(1e6, 16 * plan.work.photons);
  const auto& distances = rig.axis_distances_m;
  const shadow::StoppingRule enough{
      {row.begin(), row.end()}, plan.tolerance, distances.front(), distances.back()};
  return photons_of(limited, rig, enough, most, progress);
}

/// Whether two arrangements of the Sun and of the planes behind the Earth agree. The Sun's distance may differ by up to
/// 1 km, and the depths of planes by up to 1 m, because processors round differently.
bool are_alike(const shadow::Arrangement& a, const shadow::Arrangement& b) {
  const auto alike = [](double x, double y) { return std::abs(x - y) < 1; };
  return a.limb_darkening == b.limb_darkening &&
         alike(a.sun_distance_m / 1e3, b.sun_distance_m / 1e3) &&
         std::ranges::equal(a.depths_m, b.depths_m, alike);
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

bool limb_darkening_of(const LightRequest& request) {
  return request.limb_darkening.value_or(request.air.atmosphere != "paper");
}

shadow::RefractedLight refracted_light(const LightRequest& request,
                                       const atmosphere::Atmosphere& air,
                                       const shadow::Arrangement& arrangement,
                                       const LightGrid& grid, const algebra::Progress& progress) {
  require_sound(request);
  const auto& terms = request.by_hand.terms;
  const auto& [waves, distances, around] = grid;
  Rig rig{air, arrangement, {waves.begin(), waves.end()}, {distances.begin(), distances.end()}, {}};
  rig.settings.sectors = {around};
  auto light = [&] {
    if (terms && !terms->refracted) return rig.darkness();
    if (plan::traces_photons(request.solver)) {
      if (!request.photons)
        throw algebra::Error(
            "photons: none given, allowed 1 to 1e12; only light on a Moon has a tolerance that "
            "says how many");
      return photons_of(request, rig, {}, most_photons, progress);
    }
    const double tolerance = std::min(request.wish.tolerance.value_or(1e-3), 1e-3);
    const auto work = plan::work_of_rays(tolerance, arrangement.limb_darkening, request.by_hand);
    rig.settings.rays = work.rays;
    rig.settings.sun_terms = work.sun_terms;
    return rig.by_quadrature(progress);
  }();
  const bool left_out = terms && !terms->scattered_light;
  if (!left_out && scattered_light_of(request) != ScatteredLight::off)
    shadow::add_twilight(light, air);
  if (request.starlight) shadow::add_starlight(light);
  return light;
}

ShadowedMoon shadowed_moon(const LightRequest& request, const almanac::SkyState& sky) {
  return {eclipse::moon_in_shadow(sky), algebra::in_metres(eclipse::shadow_axis(sky).sun_distance),
          limb_darkening_of(request), atmosphere_of(request.air, sky)};
}

shadow::Lookup Moonlight::in_sums(const shadow::ChannelWeights& weights,
                                  const shadow::LookupRange& within, shadow::LightPart part) const {
  if (!refracted) return shadow::Lookup(weights, part);
  return shadow::Lookup(*refracted, *direct, weights, within, part);
}

shadow::Lookup Moonlight::in_channels(const shadow::ChannelWeights& weights) const {
  return in_sums(at_wavelengths(weights, plan.work.bands), range);
}

bool complete(const ShadowedMoon& moon, Moonlight& light) {
  const auto rig = rig_of(moon, light.plan.work);
  if (!are_alike(light.refracted->arrangement, rig.arrangement)) return false;
  light.direct = rig.direct_light();
  return true;
}

Moonlight unshadowed_light(const LightRequest& request, const almanac::SkyState& sky) {
  require_sound(request);
  shadowed_moon(request, sky);
  return {};
}

Moonlight light_on_the_moon(const LightRequest& request, const almanac::SkyState& sky,
                            const Purpose& purpose, const algebra::Progress& progress) {
  return light_on_the_way(request, moon_on_its_way(request, {&sky, 1}), purpose, progress);
}

plan::Plan planned_light(const LightRequest& request, const almanac::SkyState& sky,
                         const Purpose& purpose) {
  return plan_of(request, moon_on_its_way(request, {&sky, 1}), purpose);
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
  std::vector<eclipse::ShadowPlace> path;
  for (const auto& sky : skies) path.push_back(eclipse::moon_in_shadow(sky));
  const auto deepest = std::ranges::min_element(
      path, {}, [](const auto& place) { return algebra::in_metres(place.axis_distance); });
  const auto& sky = skies[static_cast<std::size_t>(deepest - path.begin())];
  auto moon = shadowed_moon(request, sky);
  require_eclipse(sky.when);
  if (path.size() > 1) moon.path = std::move(path);
  return moon;
}

Moonlight light_on_the_way(const LightRequest& request, const ShadowedMoon& moon,
                           const Purpose& purpose, const algebra::Progress& progress) {
  Moonlight light;
  light.plan = plan_of(request, moon, purpose);
  auto& work = light.plan.work;
  const auto rig = rig_of(moon, work);
  auto& refracted =
      light.refracted.emplace(planned_refracted_light(request, light.plan, rig, progress));
  if (refracted.photons > 0) work.photons = static_cast<double>(refracted.photons);
  std::optional<shadow::RefractedLight> twilight;
  if (work.scattered_light) {
    twilight = std::move(shadow::twilight_about(refracted, std::span(&moon.air, 1)).front());
    shadow::add_between(*twilight, refracted);
  }
  if (request.starlight) shadow::add_starlight(refracted);
  light.range = {refracted.axis_distances_m.front(), refracted.axis_distances_m.back(),
                 std::clamp(light.plan.tolerance / 10, 1e-5, 1e-3),
                 rig.settings.sectors.in(refracted.sectors)};
  light.direct = rig.direct_light();
  if (purpose.error_told) light.error_found = found_error(moon, light, twilight);
  if (refracted.photons > 0) work.rays = photon_settings(request).rays;
  return light;
}

std::optional<shadow::LookupRange> range_at(const Moonlight& light, const almanac::SkyState& sky) {
  const ShadowedMoon moon{.centre = eclipse::moon_in_shadow(sky)};
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
