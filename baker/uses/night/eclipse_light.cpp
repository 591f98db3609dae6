// SPDX-License-Identifier: MIT
#include "uses/night/eclipse_light.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "atmosphere/eye_contrast.h"
#include "colour/working_space.h"
#include "texture/resize.h"
#include "uses/light/photometer.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses {
namespace {

using almanac::Instant;

constexpr double brighter_than_any_sky = std::numeric_limits<double>::infinity();

algebra::Grid<float> small_albedo(MoonRequest moon, std::size_t rows) {
  moon.texture_width = 2 * rows;
  return texture::resized(normal_albedo(moon), rows);
}

Moonlight light_through(const eclipse::Eclipse& eclipse, const MoonRequest& moon,
                        const algebra::Progress& progress = {}) {
  const auto skies = skies_between(*eclipse.contacts.P1, *eclipse.contacts.P4);
  return light_on_the_way(moon.light, moon_on_its_way(moon.light, skies), {.error_told = false},
                          progress);
}

/// Spans of time within `whole` during which the sky has a property. The property is checked every 5 minutes, and the
/// ends of the spans are found to 10 s. Away from these ends, a fast lunar theory replaces the full one.
template <class Property>
std::vector<Span> spans_of(const Span& whole, const Property& holds) {
  using enum almanac::LunarTheory;
  constexpr double between_looks_s = 300;
  const double seconds = almanac::seconds_between(whole.first, whole.second);
  const auto at = [&](double s, almanac::LunarTheory theory) {
    return holds(almanac::sky_at(almanac::later(whole.first, s), theory));
  };
  std::vector<Span> spans;
  bool before = false;
  for (double s = 0; s < seconds + between_looks_s; s += between_looks_s) {
    double to = std::min(s, seconds), from = std::max(0., s - between_looks_s);
    bool now = at(to, s > 0 ? moon98 : elp_2000_82b);
    if (now != before && s > 0) now = at(to, elp_2000_82b);
    if (now != before && s > 0) {
      if (at(from, elp_2000_82b) != before) to = std::exchange(from, from - between_looks_s);
      while (to - from > 10) {
        const double middle = (from + to) / 2;
        (at(middle, elp_2000_82b) == before ? from : to) = middle;
      }
    }
    if (now && !before) spans.emplace_back(almanac::later(whole.first, to), whole.second);
    if (!now && before) spans.back().second = almanac::later(whole.first, from);
    before = now;
  }
  return spans;
}

/// Adds the moments at which the Moon is first and last seen.
void add_edges(Circumstances& night) {
  const auto near = [&](const Instant& when) {
    return std::ranges::any_of(night.moments, [&](const NightMoment& moment) {
      return (moment.name.starts_with("moon") || moment.name == "P1" || moment.name == "P4") &&
             std::abs(almanac::seconds_between(moment.when, when)) < 60;
    });
  };
  std::vector<NightMoment> edges;
  for (const auto& [first, last] : night.seen) {
    if (!near(first)) edges.push_back(moment_at(night.place, "first seen", almanac::sky_at(first)));
    if (!near(last)) edges.push_back(moment_at(night.place, "last seen", almanac::sky_at(last)));
  }
  night.moments.insert(night.moments.end(), edges.begin(), edges.end());
  std::ranges::stable_sort(night.moments, [](const auto& a, const auto& b) {
    return almanac::seconds_between(a.when, b.when) > 0;
  });
}

}  // namespace

EclipseLight::EclipseLight(const eclipse::Eclipse& eclipse, const MoonRequest& moon,
                           const algebra::Progress& progress)
    : EclipseLight(moon, small_albedo(moon, 180), light_through(eclipse, moon, progress)) {}

EclipseLight::EclipseLight(const MoonRequest& moon, algebra::Grid<float> albedo, Moonlight light)
    : moon_(moon),
      albedo_(std::move(albedo)),
      light_(std::move(light)),
      survey_(moon, albedo_, light_) {}

texture::Image EclipseLight::colours(const almanac::SkyState& sky,
                                     const std::optional<atmosphere::Sightline>& through) const {
  const auto response = colour::channel_weights(picture_space, band_edges_nm());
  return MoonSurvey(moon_, albedo_, light_,
                    {{"R", "G", "B"}, moonlight_weights(response, through), {}})
      .texture(sky);
}

MoonAndSky moon_and_sky(const DiscBrightness& above, const almanac::SkyState& sky,
                        const ViewRequest& view) {
  constexpr auto most_sensitive = algebra::nanometres(555);
  const auto& place = *view.observer;
  const auto air = air_over(place, view);
  const auto seen = almanac::view_from(place, sky);
  const auto apparent = apparent_place(place, sky);
  const double V = above.magnitudes[V_band],
               radius = std::asin(almanac::lunar_radius / seen.moon_distance),
               through = view.reddening ? atmosphere::transmittance_above(
                                              air, std::max(seen.altitude, algebra::degrees(-1)),
                                              most_sensitive)
                                        : 1;
  const ClearSky clear(place, sky, air, V);
  const auto direction = in_sky(apparent.altitude, apparent.azimuth);
  const double behind = clear.towards(direction).sum();
  return {V,
          above.mean_luminance_cd_m2,
          above.mean_luminance_cd_m2 * through,
          behind,
          clear.light(direction),
          clear.zenith_cd_m2(),
          atmosphere::contrast_threshold(behind, std::numbers::pi * radius * radius)};
}

Circumstances as_seen(Circumstances night, const BrightnessAt& brightness,
                      const ViewRequest& view) {
  night.seen.clear();
  for (const auto& up : night.up)
    for (const auto& span : spans_of(up, [&](const almanac::SkyState& sky) {
           const auto above = brightness(sky);
           return above.mean_luminance_cd_m2 == brighter_than_any_sky ||
                  moon_and_sky(above, sky, view).stands_out();
         }))
      night.seen.push_back(span);
  add_edges(night);
  return night;
}

Circumstances seen_circumstances(const eclipse::Eclipse& eclipse, const almanac::Observer& place) {
  const MoonRequest usual;
  static const auto usual_albedo = small_albedo(usual, 60);
  std::optional<EclipseLight> light;
  const auto brightness = [&](const almanac::SkyState& sky) -> DiscBrightness {
    const auto then = moment_at(place, {}, sky);
    const double moon_deg = algebra::in_degrees(then.moon.altitude),
                 sun_deg = algebra::in_degrees(then.sun_altitude);
    const auto& [U1, U4] = std::pair(eclipse.contacts.U1, eclipse.contacts.U4);
    const bool in_umbra = U1 && U4 && almanac::seconds_between(*U1, sky.when) > 0 &&
                          almanac::seconds_between(sky.when, *U4) > 0;
    if (in_umbra ? moon_deg > 5 && sun_deg < -12 : moon_deg > 3 && sun_deg < 0)
      return {{}, brighter_than_any_sky, 0.};
    MoonRequest moon;
    moon.light.wish.tolerance = 0.05;
    if (!light) light.emplace(moon, usual_albedo, light_through(eclipse, moon));
    return light->brightness(sky);
  };
  constexpr double longest_h = 3.5;  // longest time from P1 to greatest eclipse
  return as_seen(circumstances(eclipse, place, longest_h), brightness, {.observer = place});
}

}  // namespace coppermoon::uses
