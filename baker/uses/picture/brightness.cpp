// SPDX-License-Identifier: MIT
#include "uses/picture/brightness.h"

#include <cmath>

#include "almanac/instant.h"
#include "atmosphere/stratosphere.h"
#include "eclipse/contacts.h"
#include "texture/bake.h"
#include "texture/resize.h"
#include "uses/light/disc_brightness.h"
#include "uses/light/photometric_bands.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses {
namespace {

bool in_totality(const almanac::Instant& when) {
  const auto eclipse = eclipse::eclipse_at(when, eclipse::ShadowConvention::danjon);
  if (!eclipse || !eclipse->contacts.U2 || !eclipse->contacts.U3) return false;
  return almanac::seconds_between(*eclipse->contacts.U2, when) >= 0 &&
         almanac::seconds_between(when, *eclipse->contacts.U3) >= 0;
}

constexpr std::size_t texture_rows = 360;

/// A Moon's light and ground, to be seen in any channels.
struct Measurable {
  const MoonRequest& moon;
  const almanac::SkyState& sky;
  Moonlight light;
  algebra::Grid<float> albedo;
  std::shared_ptr<const surface::Ground> ground = ground_of(moon, albedo);

  texture::Image in(const Photometer& meter) const {
    const auto weights =
        ground ? reddest_and_bluest(meter.weights, band_centres_nm()) : meter.weights;
    return texture::bake({albedo, sky, light.in_channels(weights), ground.get()}, meter.channels,
                         texture_rows, moon.photometry);
  }
};

BrightnessSeen seen_of(const Measurable& moon, const texture::Image& above,
                       const almanac::Observer& observer,
                       const std::optional<atmosphere::Sightline>& sightline) {
  const auto from_m = almanac::view_from(observer, moon.sky).position_m;
  const auto meter = photometer(sightline);
  BrightnessSeen seen{apparent_place(observer, moon.sky),
                      measured(meter, sightline ? moon.in(meter) : above, moon.sky, from_m),
                      {}};
  const auto undimmed = measured(meter, above, moon.sky, from_m);
  for (std::size_t k = 0; k < undimmed.magnitudes.size(); ++k)
    seen.extinction_mag.push_back(seen.disc.magnitudes[k] - undimmed.magnitudes[k]);
  return seen;
}

}  // namespace

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
  const auto from = view_of(view, sky);
  const Measurable measurable{
      moon, sky,
      moon.unshadowed ? unshadowed_light(moon.light, sky)
                      : light_on_the_moon(moon.light, sky, {.error_told = false}, progress),
      texture::resized(normal_albedo(moon), texture_rows)};
  const auto meter = photometer();
  const auto texture = measurable.in(meter);
  MoonBrightness brightness{measured(meter, texture, sky), {}};
  if (!moon.unshadowed && in_totality(sky.when)) {
    brightness.danjon = danjon_estimate(brightness.disc.magnitudes[V_band]);
    brightness.V_error = totality_error_mag(moon.light.air, almanac::year_of(sky.when));
  }
  if (from.observer) brightness.seen = seen_of(measurable, texture, *from.observer, from.sightline);
  return brightness;
}

}  // namespace coppermoon::uses
