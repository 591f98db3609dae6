// SPDX-License-Identifier: MIT
#include "uses/picture/brightness.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "algebra/error.h"
#include "almanac/instant.h"
#include "atmosphere/stratosphere.h"
#include "eclipse/contacts.h"
#include "texture/bake.h"
#include "texture/resize.h"
#include "uses/light/photometer.h"
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

/// Bakes the Moon's texture with the channels of a photometer: the photometric bands, and luminance.
texture::Image texture_in(const Photometer& meter, const LitMoon& moon, std::size_t rows) {
  const auto weights = of_ground(moon.ground.get(), meter.weights, band_centres_nm());
  const auto light =
      moon.within
          ? moon.light->in_sums(at_wavelengths(weights, moon.light->plan.work.bands), *moon.within)
          : shadow::Lookup(weights);
  return texture::bake({*moon.albedo, moon.sky, light, moon.ground.get()}, meter.channels, rows,
                       moon.request.photometry);
}

/// A Moon that is ready to be measured. Its albedo map is resized to the number of rows that the textures will have.
LitMoon measurable(const MoonRequest& request, const almanac::SkyState& sky, Moonlight light,
                   std::size_t rows) {
  const auto albedo =
      std::make_shared<const algebra::Grid<float>>(texture::resized(normal_albedo(request), rows));
  const auto kept = std::make_shared<const Moonlight>(std::move(light));
  return {request, sky, albedo, ground_of(request, *albedo), kept, kept->range};
}

BrightnessSeen seen_of(const LitMoon& moon, const ViewRequest& view, const texture::Image& above,
                       std::span<const double> magnitudes) {
  const auto& sky = moon.sky;
  const auto from = view_of(view, sky);
  const auto& observer = *from.observer;
  const auto from_m = almanac::view_from(observer, sky).position_m;
  const auto meter = photometer(from.sightline);
  const auto place = apparent_place(observer, sky);
  const ClearSky clear(observer, sky, air_over(observer, view), magnitudes[V_band]);
  BrightnessSeen seen{
      observer,
      place,
      measured(meter, from.sightline ? texture_in(meter, moon, moon.albedo->rows()) : above, sky,
               from_m),
      {},
      clear.towards(in_sky(place.altitude, place.azimuth)).sum()};
  const auto undimmed = measured(meter, above, sky, from_m);
  std::ranges::transform(seen.disc.magnitudes, undimmed.magnitudes,
                         std::back_inserter(seen.extinction_mag), std::minus());
  return seen;
}

MoonBrightness brightness_of(const LitMoon& moon, const ViewRequest& view) {
  const auto& sky = moon.sky;
  const auto meter = photometer();
  const auto texture = texture_in(meter, moon, moon.albedo->rows());
  MoonBrightness brightness{sky.when, measured(meter, texture, sky), {}};
  const auto& magnitudes = brightness.disc.magnitudes;
  if (!moon.request.unshadowed && in_totality(sky.when)) {
    brightness.danjon = danjon_estimate(magnitudes[V_band]);
    brightness.V_error = totality_error_mag(moon.request.light.air, almanac::year_of(sky.when));
  }
  if (view.observer && moon_is_up(view, sky))
    brightness.seen = seen_of(moon, view, texture, magnitudes);
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
  return measured(meter, texture_in(meter, moon, rows), moon.sky).magnitudes;
}

MoonBrightness brightness_of(const MoonRequest& moon, const almanac::SkyState& sky,
                             const ViewRequest& view, const algebra::Progress& progress) {
  constexpr std::size_t rows = 360;
  view_of(view, sky);  // throws before the long computation if the Moon is not up
  return brightness_of(
      measurable(moon, sky,
                 moon.unshadowed
                     ? unshadowed_light(moon.light, sky)
                     : light_on_the_moon(moon.light, sky, {.error_told = false}, progress),
                 rows),
      view);
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
  if (view.observer) air_over(*view.observer, view);  // throws if any air quantity is out of range
  const auto skies = skies_between(moments.front(), moments.back());
  const auto over_all =
      measurable(moon, skies.front(),
                 moon.unshadowed ? unshadowed_light(moon.light, skies.front())
                                 : light_on_the_way(moon.light, moon_on_its_way(moon.light, skies),
                                                    {.error_told = false}, progress),
                 rows);
  LightCurve curve;
  curve.moments.resize(moments.size());
  tbb::parallel_for(std::size_t{0}, moments.size(), [&](std::size_t i) {
    auto here = over_all;
    here.sky = almanac::sky_at(moments[i]);
    if (!moon.unshadowed) here.within = range_at(*here.light, here.sky);
    curve.moments[i] = {brightness_of(here, view), view.observer.has_value(), {}};
  });
  curve.columns = result::columns_of(curve.moments);
  return curve;
}

MoonSurvey::MoonSurvey(const MoonRequest& moon, const algebra::Grid<float>& albedo,
                       const Moonlight& light, Photometer meter)
    : photometry_(moon.photometry),
      meter_(std::move(meter)),
      albedo_(albedo),
      ground_(ground_of(moon, albedo)),
      light_(light),
      weights_(of_ground(ground_.get(), meter_.weights, band_centres_nm())),
      shadowed_(light.in_channels(weights_)),
      sunlit_(weights_) {}

texture::Image MoonSurvey::texture(const almanac::SkyState& sky) const {
  return texture::bake({albedo_, sky, range_at(light_, sky) ? shadowed_ : sunlit_, ground_.get()},
                       meter_.channels, albedo_.rows(), photometry_);
}

DiscBrightness MoonSurvey::brightness(const almanac::SkyState& sky) const {
  return measured(meter_, texture(sky), sky);
}

}  // namespace coppermoon::uses
