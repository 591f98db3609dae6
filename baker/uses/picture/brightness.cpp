// SPDX-License-Identifier: MIT
#include "uses/picture/brightness.h"

#include "almanac/instant.h"
#include "eclipse/contacts.h"
#include "texture/bake.h"
#include "uses/light/disc_brightness.h"

namespace coppermoon::uses {
namespace {

bool in_totality(const almanac::Instant& when) {
  const auto eclipse = eclipse::eclipse_at(when, eclipse::ShadowConvention::danjon);
  if (!eclipse || !eclipse->contacts.U2 || !eclipse->contacts.U3) return false;
  return almanac::seconds_between(*eclipse->contacts.U2, when) >= 0 &&
         almanac::seconds_between(when, *eclipse->contacts.U3) >= 0;
}

}  // namespace

MoonBrightness brightness_of(const MoonRequest& moon, const almanac::SkyState& sky,
                             const algebra::Progress& progress) {
  constexpr std::size_t rows = 360;
  const auto meter = photometer();
  const auto light = (moon.unshadowed ? unshadowed_light(moon.light, sky)
                                      : light_on_the_moon(moon.light, sky, {}, progress))
                         .in_channels(meter.weights);
  const auto texture =
      texture::bake({normal_albedo(moon), sky, light}, meter.channels, rows, moon.photometry);
  MoonBrightness brightness{measured(meter, texture, sky), {}};
  constexpr std::size_t V = 1;  // of the photometer's bands
  if (!moon.unshadowed && in_totality(sky.when))
    brightness.danjon = danjon_estimate(brightness.disc.magnitudes[V]);
  return brightness;
}

}  // namespace coppermoon::uses
