// SPDX-License-Identifier: MIT
#include "uses/night/night_light.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>

#include "atmosphere/sky_luminance.h"
#include "eclipse/shadow_axis.h"
#include "texture/bake.h"
#include "texture/resize.h"
#include "uses/light/moonlight.h"
#include "uses/light/photometer.h"
#include "uses/light/spectral_bands.h"
#include "uses/night/star_limit.h"

namespace coppermoon::uses {
namespace {

using almanac::Instant;

constexpr std::size_t rows = 180;
constexpr double between_skies_s = 240;
constexpr std::size_t V = 1;  // of the photometer's bands

/// Ground, light and meter that all moments share.
struct Survey {
  const MoonRequest& moon;
  Photometer meter;
  const algebra::Grid<float>& albedo;
  std::shared_ptr<const surface::Ground> ground;
  const Moonlight& light;
  shadow::Lookup shadowed, sunlit;

  texture::Image texture(const almanac::SkyState& sky) const {
    return texture::bake({albedo, sky, range_at(light, sky) ? shadowed : sunlit, ground.get()},
                         meter.channels, rows, moon.photometry);
  }
};

/// Luminance of a texel that is seen, and how much of the disc it is.
struct Patch {
  double luminance_cd_m2, area;
};

/// The disc by luminance, the darkest first.
std::vector<Patch> patches_of(const texture::Image& image, const almanac::SkyState& sky) {
  const double latitude = algebra::in_radians(sky.sub_earth.latitude),
               longitude = algebra::in_radians(sky.sub_earth.longitude);
  const std::size_t columns = 2 * rows, channels = image.values.size() / (rows * columns);
  std::vector<Patch> patches;
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < columns; ++c) {
      const double north = std::numbers::pi * (0.5 - (static_cast<double>(r) + 0.5) / rows),
                   east = std::numbers::pi * ((static_cast<double>(c) + 0.5) / rows - 1);
      const double cosine = std::sin(north) * std::sin(latitude) +
                            std::cos(north) * std::cos(latitude) * std::cos(east - longitude);
      if (cosine > 0.1)  // the limb's texels are seen edge on
        patches.push_back(
            {static_cast<double>(image.values[(r * columns + c) * channels + channels - 1]),
             cosine * std::cos(north)});
    }
  std::ranges::sort(patches, {}, &Patch::luminance_cd_m2);
  return patches;
}

/// Luminance that a share of an area does not reach.
double quantile(const std::vector<Patch>& patches, double share) {
  double area = 0, so_far = 0;
  for (const auto& patch : patches) area += patch.area;
  for (const auto& patch : patches)
    if ((so_far += patch.area) >= share * area) return patch.luminance_cd_m2;
  return patches.empty() ? 0 : patches.back().luminance_cd_m2;
}

/// The umbra's part of a disc that the Sun lights elsewhere: what is 500 times darker.
std::vector<Patch> in_shadow(const std::vector<Patch>& disc, double brightest) {
  std::vector<Patch> dark;
  for (const auto& patch : disc)
    if (patch.luminance_cd_m2 < brightest / 500) dark.push_back(patch);
  return dark;
}

/// Times at a camera's settings.
class Exposer {
 public:
  Exposer(const ViewRequest& view, const Development& development)
      : view_(view), development_(development) {
    development_.time = {ExposureTime::Rule::fixed, 1};
    const texture::Image nothing(1, 1, {"R", "G", "B"});
    const auto second =
        exposures_for(development_, nothing, colour::WorkingSpace::linear_rec709).shorter;
    per_second_ = scale_of(development_, second);
    f_number_ = second.f_number;
  }

  double f_number() const { return f_number_; }

  double time_s(double luminance_cd_m2, double level, const almanac::SkyState& sky) const {
    return level / (luminance_cd_m2 * transmittance(sky) * per_second_);
  }

 private:
  double transmittance(const almanac::SkyState& sky) const {
    if (!view_.observer || !view_.reddening) return 1;
    if (!moon_is_up(view_, sky)) return 1;
    const auto seen = view_of(view_, sky);
    return seen.sightline
               ? atmosphere::transmittance_above(seen.sightline->air, seen.sightline->altitude,
                                                 algebra::nanometres(555))
               : 1;
  }

  ViewRequest view_;
  Development development_;
  double per_second_ = 1, f_number_ = 1;
};

PhaseExposure exposure_of(const Survey& survey, const Exposer& exposer, const std::string& phase,
                          const Instant& when) {
  const auto sky = almanac::sky_at(when);
  const auto disc = patches_of(survey.texture(sky), sky);
  const double brightest = quantile(disc, 0.99);
  PhaseExposure exposure{phase, when, {}, {}};
  if (brightest > 0) exposure.lit_s = exposer.time_s(brightest, 0.8, sky);
  const auto dark = in_shadow(disc, brightest);
  if (dark.size() > disc.size() / 50)
    if (const double middle = quantile(dark, 0.5); middle > 0)
      exposure.shadow_s = exposer.time_s(middle, 0.18, sky);
  return exposure;
}

/// The Sun's altitude at a place.
algebra::Angle sun_altitude(const almanac::Observer& place, const almanac::SkyState& sky) {
  const auto view = almanac::view_from(place, sky);
  const auto to_sun = glm::normalize(sky.sun_m - view.position_m);
  return algebra::radians(std::asin(glm::dot(to_sun, view.zenith)));
}

/// The sky over a place at the zenith: its own, and the Moon's light in it.
double sky_over(const almanac::Observer& place, const almanac::SkyState& sky, double magnitude) {
  constexpr auto brightest_twilight = algebra::degrees(5);
  const auto sun = sun_altitude(place, sky);
  const auto moon = almanac::view_from(place, sky).altitude;
  return atmosphere::sky_luminance_cd_m2(algebra::in_degrees(sun) > 5 ? brightest_twilight : sun) +
         moonlit_sky_cd_m2(magnitude, moon);
}

NightLight light_at(const Survey& survey, const NightMoment& moment,
                    const almanac::Observer& place) {
  const auto sky = almanac::sky_at(moment.when);
  const auto disc = measured(survey.meter, survey.texture(sky), sky);
  return {moment.name, moment.when, disc.magnitudes[V], disc.mean_luminance_cd_m2,
          faintest_star(sky_over(place, sky, disc.magnitudes[V]))};
}

/// Share of the Moon's diameter in the umbra, from U1 on.
double immersed(const Instant& u1, const Instant& when) {
  const auto distance_m = [](const Instant& then) {
    const auto sky = almanac::sky_at(then);
    return algebra::in_metres(
        eclipse::place_in_shadow(eclipse::shadow_axis(sky), sky.moon_m).axis_distance);
  };
  return (distance_m(u1) - distance_m(when)) / (2 * algebra::in_metres(almanac::lunar_radius));
}

/// When that share is in the umbra, between U1 and the greatest phase.
Instant moment_of_share(const eclipse::Eclipse& eclipse, double share) {
  const auto& u1 = *eclipse.contacts.U1;
  double from = 0, to = almanac::seconds_between(u1, eclipse.greatest);
  while (to - from > 1) {
    const double middle = (from + to) / 2;
    (immersed(u1, almanac::later(u1, middle)) < share ? from : to) = middle;
  }
  return almanac::later(u1, to);
}

/// Phases that are exposed each in its way, with their moments.
std::vector<std::pair<std::string, Instant>> phases_of(const eclipse::Eclipse& eclipse) {
  const auto& c = eclipse.contacts;
  std::vector<std::pair<std::string, Instant>> phases{
      {"full Moon, before P1", almanac::later(*c.P1, -60)}};
  if (!c.U1) {
    phases.emplace_back("greatest, in the penumbra", eclipse.greatest);
    return phases;
  }
  phases.emplace_back("penumbral, just before U1", almanac::later(*c.U1, -60));
  for (const auto& [name, share] : {std::pair{"partial, a quarter", 0.25},
                                    {"partial, half", 0.5},
                                    {"partial, three quarters", 0.75},
                                    {"partial, 95 %", 0.95}})
    if (share < eclipse.umbral_magnitude)
      phases.emplace_back(name, moment_of_share(eclipse, share));
  if (c.U2) phases.emplace_back("totality, just after U2", almanac::later(*c.U2, 60));
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

/// Progress of one part of a whole: its fractions 0 to 1 are passed on as `from` to `to`.
algebra::Progress part_of(const algebra::Progress& whole, double from, double to) {
  if (!whole) return {};
  return [whole, from, to](double fraction) { whole(std::lerp(from, to, fraction)); };
}

/// What a whole eclipse is lit by, or its greatest phase.
Survey survey_of(const MoonRequest& moon, const algebra::Grid<float>& albedo,
                 const Moonlight& light) {
  const auto meter = photometer();
  const auto ground = ground_of(moon, albedo);
  const auto weights =
      ground ? reddest_and_bluest(meter.weights, band_centres_nm()) : meter.weights;
  return {moon, meter, albedo, ground, light, light.in_channels(weights), shadow::Lookup(weights)};
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
  double done = steps ? 0.25 : 1;
  const auto light = light_on_the_way(moon.light, moon_on_its_way(moon.light, skies), {},
                                      part_of(progress, 0, done));
  const auto survey = survey_of(moon, albedo, light);
  const Exposer exposer(view, development);
  NightLights lights{.f_number = exposer.f_number(), .iso = development.iso};
  for (const auto& moment : night.moments)
    if (!moment.name.starts_with("moon"))
      lights.moments.push_back(light_at(survey, moment, night.place));
  for (const auto& [phase, when] : phases_of(night.eclipse))
    lights.exposures.push_back(exposure_of(survey, exposer, phase, when));
  if (!steps) return lights;
  const auto sky = almanac::sky_at(night.eclipse.greatest);
  for (const int l : {4, 3, 2, 1, 0}) {
    auto other = moon;
    other.light.air.column.danjon = l;
    const auto its_light =
        light_on_the_moon(other.light, sky, {}, part_of(progress, done, done + 0.15));
    done += 0.15;
    if (progress) progress(done);
    lights.exposures.push_back(exposure_of(survey_of(other, albedo, its_light), exposer,
                                           fmt::format("middle of totality, L = {}", l),
                                           night.eclipse.greatest));
  }
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

}  // namespace coppermoon::uses
