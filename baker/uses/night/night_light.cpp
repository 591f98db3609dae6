// SPDX-License-Identifier: MIT
#include "uses/night/night_light.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "algebra/error.h"
#include "eclipse/shadow_axis.h"
#include "texture/resize.h"
#include "uses/light/photometric_bands.h"
#include "uses/night/star_limit.h"
#include "uses/picture/brightness.h"
#include "uses/picture/clear_sky.h"
#include "uses/picture/moon_survey.h"

namespace coppermoon::uses {
namespace {

using almanac::Instant;

constexpr std::size_t rows = 180;  ///< of the texture that exposures are measured on
constexpr double between_skies_s = 240;

/// Share of the lit disc that may be brighter than its level of exposure, and that level over saturation.
constexpr double brighter_share = 0.01, lit_level = 0.8;
/// Level of the umbra's median luminance over saturation.
constexpr double umbra_level = 0.18;
/// Luminance of the lit disc over that at which the umbra begins.
constexpr double umbra_contrast = 500;
/// Share of the disc's texels that the umbra must take, to be exposed by itself.
constexpr double least_umbra_share = 0.02;
/// Cosine of the emission angle; texels nearer to the limb are seen edge on.
constexpr double least_cosine = 0.1;
/// Between a contact and the exposure just before or after it.
constexpr double beside_contact_s = 60;

/// A texel that is seen, and its relative area on the disc.
struct Patch {
  double luminance_cd_m2, area;
};

/// The disc in order of luminance, the darkest first.
std::vector<Patch> patches_of(const texture::Image& image, const almanac::SkyState& sky) {
  const auto to_earth = almanac::selenographic_direction(sky.sub_earth);
  const std::size_t columns = 2 * rows, channels = image.values.size() / (rows * columns);
  std::vector<Patch> patches;
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < columns; ++c) {
      const double north = std::numbers::pi * (0.5 - (static_cast<double>(r) + 0.5) / rows),
                   east = std::numbers::pi * ((static_cast<double>(c) + 0.5) / rows - 1);
      const double cosine = glm::dot(
          to_earth,
          almanac::selenographic_direction({algebra::radians(north), algebra::radians(east)}));
      if (cosine > least_cosine)
        patches.push_back(
            {static_cast<double>(image.values[(r * columns + c) * channels + channels - 1]),
             cosine * std::cos(north)});
    }
  std::ranges::sort(patches, {}, &Patch::luminance_cd_m2);
  return patches;
}

/// Luminance below which a share of the area lies.
double quantile(const std::vector<Patch>& patches, double share) {
  double area = 0, so_far = 0;
  for (const auto& patch : patches) area += patch.area;
  for (const auto& patch : patches)
    if ((so_far += patch.area) >= share * area) return patch.luminance_cd_m2;
  return patches.empty() ? 0 : patches.back().luminance_cd_m2;
}

/// The disc's part in the umbra.
std::vector<Patch> in_umbra(const std::vector<Patch>& disc, double brightest) {
  std::vector<Patch> dark;
  for (const auto& patch : disc)
    if (patch.luminance_cd_m2 < brightest / umbra_contrast) dark.push_back(patch);
  return dark;
}

/// Exposure times at a camera's f-number and speed.
class Exposer {
 public:
  Exposer(const ViewRequest& view, const Development& development, double longest_s)
      : view_(view), development_(development), longest_s_(longest_s) {
    development_.time = {ExposureTime::Rule::fixed, 1};
    const texture::Image nothing(1, 1, {"R", "G", "B"});
    const auto second =
        exposures_for(development_, nothing, colour::WorkingSpace::linear_rec709).shorter;
    per_second_ = scale_of(development_, second);
    f_number_ = second.f_number;
  }

  double f_number() const { return f_number_; }

  /// None where it would be longer than the longest.
  std::optional<double> time_s(double luminance_cd_m2, double level,
                               const almanac::SkyState& sky) const {
    const double time = level / (luminance_cd_m2 * transmittance(sky) * per_second_);
    return time <= longest_s_ ? std::optional(time) : std::nullopt;
  }

 private:
  /// Transmittance of the air above the observer, where the eye is most sensitive; 1 of a Moon below the horizon.
  double transmittance(const almanac::SkyState& sky) const {
    constexpr auto most_sensitive = algebra::nanometres(555);
    if (!view_.observer || !view_.reddening || !moon_is_up(view_, sky)) return 1;
    const auto seen = view_of(view_, sky);
    return seen.sightline ? atmosphere::transmittance_above(
                                seen.sightline->air, seen.sightline->altitude, most_sensitive)
                          : 1;
  }

  ViewRequest view_;
  Development development_;
  double longest_s_, per_second_ = 1, f_number_ = 1;
};

PhaseExposure exposure_of(const MoonSurvey& survey, const Exposer& exposer,
                          const std::string& phase, const Instant& when) {
  const auto sky = almanac::sky_at(when);
  const auto disc = patches_of(survey.texture(sky), sky);
  const double brightest = quantile(disc, 1 - brighter_share);
  PhaseExposure exposure{phase, when, exposer.time_s(brightest, lit_level, sky)};
  exposure.too_dark = !exposure.lit_s;
  const auto dark = in_umbra(disc, brightest);
  if (static_cast<double>(dark.size()) > least_umbra_share * static_cast<double>(disc.size())) {
    exposure.shadow_s = exposer.time_s(quantile(dark, 0.5), umbra_level, sky);
    exposure.too_dark |= !exposure.shadow_s;
  }
  return exposure;
}

NightLight light_at(const MoonSurvey& survey, const NightMoment& moment,
                    const almanac::Observer& place, const atmosphere::ObserverAir& air) {
  const auto sky = almanac::sky_at(moment.when);
  const auto disc = survey.brightness(sky);
  const double V = disc.magnitudes[V_band],
               star = faintest_star(ClearSky(place, sky, air, V).zenith_cd_m2());
  return {moment.name, moment.when, V, disc.mean_luminance_cd_m2,
          star > 0 ? std::optional(star) : std::nullopt};
}

/// Share of the Moon's diameter in the umbra, by the axis distance since U1.
double immersed(const Instant& u1, const Instant& when) {
  const auto distance_m = [](const Instant& then) {
    const auto sky = almanac::sky_at(then);
    return algebra::in_metres(
        eclipse::place_in_shadow(eclipse::shadow_axis(sky), sky.moon_m).axis_distance);
  };
  return (distance_m(u1) - distance_m(when)) / (2 * algebra::in_metres(almanac::lunar_radius));
}

/// Moment between U1 and the greatest phase at which a share of the Moon's diameter is in the umbra, to a second.
Instant moment_of_share(const eclipse::Eclipse& eclipse, double share) {
  const auto& u1 = *eclipse.contacts.U1;
  double from = 0, to = almanac::seconds_between(u1, eclipse.greatest);
  while (to - from > 1) {
    const double middle = (from + to) / 2;
    (immersed(u1, almanac::later(u1, middle)) < share ? from : to) = middle;
  }
  return almanac::later(u1, to);
}

/// Phases, each with its own exposure, and their moments.
std::vector<std::pair<std::string, Instant>> phases_of(const eclipse::Eclipse& eclipse) {
  const auto& c = eclipse.contacts;
  std::vector<std::pair<std::string, Instant>> phases{
      {"full Moon, before P1", almanac::later(*c.P1, -beside_contact_s)}};
  if (!c.U1) {
    phases.emplace_back("greatest, in the penumbra", eclipse.greatest);
    return phases;
  }
  phases.emplace_back("penumbral, just before U1", almanac::later(*c.U1, -beside_contact_s));
  for (const auto& [name, share] : {std::pair{"partial, a quarter", 0.25},
                                    {"partial, half", 0.5},
                                    {"partial, three quarters", 0.75},
                                    {"partial, 95 %", 0.95}})
    if (share < eclipse.umbral_magnitude)
      phases.emplace_back(name, moment_of_share(eclipse, share));
  if (c.U2) phases.emplace_back("totality, just after U2", almanac::later(*c.U2, beside_contact_s));
  phases.emplace_back(c.U2 ? "middle of totality" : "greatest, in the umbra", eclipse.greatest);
  return phases;
}

std::vector<almanac::SkyState> skies_from(const eclipse::Eclipse& eclipse) {
  const double seconds = almanac::seconds_between(*eclipse.contacts.P1, *eclipse.contacts.P4);
  std::vector<almanac::SkyState> skies;
  for (double s = 0; s <= seconds; s += between_skies_s)
    skies.push_back(almanac::sky_at(almanac::later(*eclipse.contacts.P1, s)));
  return skies;
}

/// Progress of a part: passes its fractions 0 to 1 on as `from` to `to`.
algebra::Progress part_of(const algebra::Progress& whole, double from, double to) {
  if (!whole) return {};
  return [whole, from, to](double fraction) { whole(std::lerp(from, to, fraction)); };
}

/// Exposures of the middle of totality at L = 4 to 0.
std::vector<PhaseExposure> danjon_exposures(const Instant& greatest, const MoonRequest& moon,
                                            const algebra::Grid<float>& albedo,
                                            const Exposer& exposer,
                                            const algebra::Progress& progress) {
  constexpr std::size_t steps = 5;
  const auto sky = almanac::sky_at(greatest);
  std::vector<MoonRequest> requests(steps, moon);
  std::vector<ShadowedMoon> moons;
  for (std::size_t i = 0; i < steps; ++i) {
    requests[i].light.air.column.danjon = static_cast<int>(steps - 1 - i);
    moons.push_back(shadowed_moon(requests[i].light, sky));
  }
  std::vector<PhaseExposure> exposures(steps);
  std::atomic<int> done = 0;
  tbb::parallel_for(
      std::size_t{0}, steps,
      [&](std::size_t i) {
        const auto light = light_on_the_way(requests[i].light, moons[i], {.error_told = false});
        exposures[i] =
            exposure_of(MoonSurvey(requests[i], albedo, light), exposer,
                        fmt::format("middle of totality, L = {}", steps - 1 - i), greatest);
        if (progress) progress(static_cast<double>(++done) / steps);
      },
      tbb::simple_partitioner());
  return exposures;
}

}  // namespace

NightLights night_lights(const Circumstances& night, const MoonRequest& moon,
                         const ViewRequest& view, const Development& development, bool danjon,
                         const algebra::Progress& progress) {
  auto small = moon;
  small.texture_width = 2 * rows;
  const auto albedo = texture::resized(normal_albedo(small), rows);
  const auto skies = skies_from(night.eclipse);
  const bool steps = danjon && night.eclipse.contacts.U2;
  const double done = steps ? 0.25 : 1;
  const auto light = light_on_the_way(moon.light, moon_on_its_way(moon.light, skies),
                                      {.error_told = false}, part_of(progress, 0, done));
  const MoonSurvey survey(moon, albedo, light);
  const auto& contacts = night.eclipse.contacts;
  const Exposer exposer(view, development, almanac::seconds_between(*contacts.P1, *contacts.P4));
  NightLights lights{.f_number = exposer.f_number(), .iso = development.iso};
  if (night.eclipse.contacts.U2)
    lights.V_error = totality_error_mag(moon.light.air, almanac::year_of(night.eclipse.greatest));
  const auto air = air_over(night.place, view);
  for (const auto& moment : night.moments)
    if (!moment.name.starts_with("moon"))
      lights.moments.push_back(light_at(survey, moment, night.place, air));
  for (const auto& [phase, when] : phases_of(night.eclipse))
    lights.exposures.push_back(exposure_of(survey, exposer, phase, when));
  if (!steps) return lights;
  for (auto& exposure :
       danjon_exposures(night.eclipse.greatest, moon, albedo, exposer, part_of(progress, done, 1)))
    lights.exposures.push_back(std::move(exposure));
  return lights;
}

double camera_time_s(double seconds) {
  static constexpr double parts[] = {8000, 6400, 5000, 4000, 3200, 2500, 2000, 1600, 1250,
                                     1000, 800,  640,  500,  400,  320,  250,  200,  160,
                                     125,  100,  80,   60,   50,   40,   30,   25,   20,
                                     15,   13,   10,   8,    6,    5,    4},
                          whole[] = {0.3, 0.4, 0.5, 0.6, 0.8, 1,  1.3, 1.6, 2,  2.5, 3.2,
                                     4,   5,   6,   8,   10,  13, 15,  20,  25, 30};
  if (seconds > 34) return seconds;
  double best = whole[0];
  const auto try_time = [&](double time) {
    if (std::abs(std::log(time / seconds)) < std::abs(std::log(best / seconds))) best = time;
  };
  for (const double part : parts) try_time(1 / part);
  for (const double time : whole) try_time(time);
  return best;
}

double trailing_time_s(const Circumstances& night, double focal_length_mm, double trail_um) {
  algebra::require_within("focal length [mm]", focal_length_mm, 1, 1e6);
  constexpr double seconds = 60;
  const auto toward_moon = [&](const Instant& when) {
    const auto moon = apparent_place(night.place, almanac::sky_at(when));
    return in_sky(moon.altitude, moon.azimuth);
  };
  const auto& greatest = night.eclipse.greatest;
  const double turned =
      glm::distance(toward_moon(greatest), toward_moon(almanac::later(greatest, seconds)));
  return trail_um * 1e-3 / (focal_length_mm * turned / seconds);
}

}  // namespace coppermoon::uses
