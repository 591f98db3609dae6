// SPDX-License-Identifier: MIT
#include "uses/fit/air_fit.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "almanac/instant.h"
#include "colour/working_space.h"
#include "eclipse/shadow_axis.h"
#include "support/within.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses {
namespace {

constexpr std::size_t bins = 4;

/// Light of places of the shadow in air without a month, from near the axis to the umbra's edge.
FittedLight light_of_the_shadow() {
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2018-07-27T20:40:00Z"));
  LitBins all{
      moonlight_weights(colour::channel_weights(colour::WorkingSpace::ciexyz_d65, band_edges_nm())),
      {},
      bins};
  auto place = eclipse::place_in_shadow(eclipse::shadow_axis(sky), sky.moon_m);
  for (std::size_t b = 0; b < bins; ++b) {
    place.axis_distance = algebra::kilometres(500 + 1200 * static_cast<double>(b));
    all.places.push_back({place, 1, b});
  }
  LightRequest request;
  request.air.atmosphere = "undated";
  return {request, Unknowns::amounts, std::span(&sky, 1), std::span(&all, 1)};
}

/// Widths of the intervals found where X, Y and Z of all places have a relative error.
std::array<double, 3> widths(const FittedLight& light, double error) {
  const auto truth = light.at({4e-6, 0.4, 300});
  const DataSet data{&light,
                     [&](const algebra::Grid<double>& found) {
                       double sum = 0;
                       for (std::size_t i = 0; i < truth.values().size(); ++i)
                         sum +=
                             std::pow(std::log(found.values()[i] / truth.values()[i]) / error, 2);
                       return GoodnessOfFit{sum};
                     },
                     3 * bins};
  const auto fit = fitted_air(std::span(&data, 1));
  std::array<double, 3> all{};
  for (std::size_t a = 0; a < 3; ++a)
    all[a] = fit.posterior.estimates[a].high - fit.posterior.estimates[a].low;
  return all;
}

TEST(AirFit, IntervalsAreNoWiderThanTheErrors) {
  const auto light = light_of_the_shadow();
  const auto wide = widths(light, 0.02), narrow = widths(light, 0.002);
  for (std::size_t a = 0; a < 3; ++a)
    EXPECT_WITHIN_RELATIVE(
        narrow[a], wide[a] / 10, 0.2,
        "steps of one deviation, between which the density is linear, widen by a "
        "tenth; light is not linear over the wide interval")
        << a;
}

}  // namespace
}  // namespace coppermoon::uses
