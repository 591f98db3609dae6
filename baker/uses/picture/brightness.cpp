// SPDX-License-Identifier: MIT
#include "uses/picture/brightness.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <cmath>

#include "algebra/error.h"
#include "almanac/instant.h"
#include "atmosphere/stratosphere.h"
#include "eclipse/contacts.h"
#include "texture/bake.h"
#include "texture/resize.h"
#include "uses/light/disc_brightness.h"
#include "uses/light/photometric_bands.h"
#include "uses/light/spectral_bands.h"
#include "uses/picture/clear_sky.h"

namespace coppermoon::uses {
namespace {

bool in_totality(const almanac::Instant& when) {
  const auto eclipse = eclipse::eclipse_at(when, eclipse::ShadowConvention::danjon);
  if (!eclipse || !eclipse->contacts.U2 || !eclipse->contacts.U3) return false;
  return almanac::seconds_between(*eclipse->contacts.U2, when) >= 0 &&
         almanac::seconds_between(when, *eclipse->contacts.U3) >= 0;
}

constexpr std::size_t texture_rows = 360;

/// A Moon's light and ground, to be seen in any channels at its moments.
struct Measurable {
  const MoonRequest& moon;
  const ViewRequest& view;
  Moonlight light;
  algebra::Grid<float> albedo;
  bool on_its_way = false;  ///< the light is that of a whole eclipse
  std::shared_ptr<const surface::Ground> ground = ground_of(moon, albedo);

  texture::Image in(const Photometer& meter, const almanac::SkyState& sky) const {
    const auto weights =
        ground ? reddest_and_bluest(meter.weights, band_centres_nm()) : meter.weights;
    const auto lookup = [&] {
      if (!on_its_way) return light.in_channels(weights);
      const auto within = range_at(light, sky);
      return within ? light.in_sums(at_wavelengths(weights, light.plan.work.bands), *within)
                    : shadow::Lookup(weights);
    };
    return texture::bake({albedo, sky, lookup(), ground.get()}, meter.channels, albedo.rows(),
                         moon.photometry);
  }

  MoonBrightness at(const almanac::SkyState& sky) const;
};

BrightnessSeen seen_of(const Measurable& moon, const texture::Image& above,
                       const almanac::SkyState& sky, const MoonBrightness& brightness) {
  const auto from = view_of(moon.view, sky);
  const auto& observer = *from.observer;
  const auto from_m = almanac::view_from(observer, sky).position_m;
  const auto meter = photometer(from.sightline);
  const auto place = apparent_place(observer, sky);
  const ClearSky clear(observer, sky, air_over(observer, moon.view),
                       brightness.disc.magnitudes[V_band]);
  BrightnessSeen seen{observer,
                      place,
                      measured(meter, from.sightline ? moon.in(meter, sky) : above, sky, from_m),
                      {},
                      clear.towards(in_sky(place.altitude, place.azimuth)).sum()};
  const auto undimmed = measured(meter, above, sky, from_m);
  for (std::size_t k = 0; k < undimmed.magnitudes.size(); ++k)
    seen.extinction_mag.push_back(seen.disc.magnitudes[k] - undimmed.magnitudes[k]);
  return seen;
}

MoonBrightness Measurable::at(const almanac::SkyState& sky) const {
  const auto meter = photometer();
  const auto texture = in(meter, sky);
  MoonBrightness brightness{sky.when, measured(meter, texture, sky), {}};
  if (!moon.unshadowed && in_totality(sky.when)) {
    brightness.danjon = danjon_estimate(brightness.disc.magnitudes[V_band]);
    brightness.V_error = totality_error_mag(moon.light.air, almanac::year_of(sky.when));
  }
  if (view.observer && moon_is_up(view, sky))
    brightness.seen = seen_of(*this, texture, sky, brightness);
  return brightness;
}

}  // namespace

double level_illuminance_lx(const BrightnessSeen& seen) {
  return seen.disc.illuminance_lx * std::max(0., std::sin(algebra::in_radians(seen.moon.altitude)));
}

std::optional<double> totality_error_mag(const Air& air, double year) {
  const bool dated = air.atmosphere == "standard" || air.atmosphere == "calibrated";
  if (!dated || air != Air{.atmosphere = air.atmosphere}) return {};
  constexpr double of_weather = 0.23, for_optical_depth = 50;
  return std::hypot(of_weather, for_optical_depth * atmosphere::stratospheric_depth_error(year));
}

std::vector<double> magnitudes_above(const LitMoon& moon) {
  constexpr std::size_t rows = 180;
  const auto meter = photometer();
  const auto weights =
      moon.ground ? reddest_and_bluest(meter.weights, band_centres_nm()) : meter.weights;
  const auto light =
      moon.within
          ? moon.light->in_sums(at_wavelengths(weights, moon.light->plan.work.bands), *moon.within)
          : shadow::Lookup(weights);
  const auto texture = texture::bake({*moon.albedo, moon.sky, light, moon.ground.get()},
                                     meter.channels, rows, moon.request.photometry);
  return measured(meter, texture, moon.sky).magnitudes;
}

MoonBrightness brightness_of(const MoonRequest& moon, const almanac::SkyState& sky,
                             const ViewRequest& view, const algebra::Progress& progress) {
  view_of(view, sky);  // refuses a Moon below the horizon, before the work
  const Measurable measurable{
      moon, view,
      moon.unshadowed ? unshadowed_light(moon.light, sky)
                      : light_on_the_moon(moon.light, sky, {.error_told = false}, progress),
      texture::resized(normal_albedo(moon), texture_rows)};
  return measurable.at(sky);
}

std::vector<almanac::Instant> moments_between(const almanac::Instant& from,
                                              const almanac::Instant& to, double step_min) {
  algebra::require_within("step [min]", step_min, 0.01, 1440);
  const double seconds = almanac::seconds_between(from, to);
  algebra::require_within("time from the first moment to the last [s]", seconds, 0, 86400);
  std::vector<almanac::Instant> moments;
  for (int i = 0; 60 * step_min * i <= seconds + 1e-3; ++i)
    moments.push_back(almanac::later(from, 60 * step_min * i));
  return moments;
}

LightCurve light_curve(const MoonRequest& moon, const std::vector<almanac::Instant>& moments,
                       const ViewRequest& view, const algebra::Progress& progress) {
  constexpr std::size_t rows = 180;
  if (view.observer) air_over(*view.observer, view);  // refuses an air that is not sound
  const auto skies = skies_between(moments.front(), moments.back());
  const Measurable measurable{moon, view,
                              moon.unshadowed
                                  ? unshadowed_light(moon.light, skies.front())
                                  : light_on_the_way(moon.light, moon_on_its_way(moon.light, skies),
                                                     {.error_told = false}, progress),
                              texture::resized(normal_albedo(moon), rows), !moon.unshadowed};
  LightCurve curve;
  curve.moments.resize(moments.size());
  tbb::parallel_for(std::size_t{0}, moments.size(), [&](std::size_t i) {
    curve.moments[i] = {measurable.at(almanac::sky_at(moments[i])), view.observer.has_value(), {}};
  });
  curve.columns = result::columns_of(curve.moments);
  return curve;
}

}  // namespace coppermoon::uses
