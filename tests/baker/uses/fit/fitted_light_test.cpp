// SPDX-License-Identifier: MIT
#include "uses/fit/fitted_light.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "almanac/instant.h"
#include "colour/working_space.h"
#include "support/testing.h"
#include "uses/fit/fit_scene.h"
#include "uses/fit/lit_bins.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses::fitted_light_test {

/// Weights of what the ground's colour adds, for c = 1.
algebra::Grid<double> coloured(algebra::Grid<double> weights) {
  const auto centres_nm = band_centres_nm();
  for (std::size_t k = 0; k < weights.rows(); ++k)
    for (std::size_t b = 0; b < weights.columns(); ++b) weights(k, b) *= colour_at(centres_nm[b]);
  return weights;
}

/// Five places of the Moon's near side in the shadow, a bin each, and a sixth bin of both ends.
std::vector<LitPlace> five_places(const almanac::SkyState& sky) {
  std::vector<LitPlace> all;
  const auto axis = eclipse::shadow_axis(sky);
  const auto towards = glm::normalize(-sky.moon_m);
  const auto across = glm::normalize(glm::cross(towards, glm::dvec3(0.2, 0.3, 1)));
  for (int i = -2; i <= 2; ++i) {
    const double x = 0.42 * i;
    const auto at = sky.moon_m + 1.7374e6 * (std::sqrt(1 - x * x) * towards + x * across);
    all.push_back({eclipse::place_in_shadow(axis, at), 1. + i * 0.1,
                   static_cast<std::size_t>(i + 2), 0.05 * i});
  }
  all.push_back({all.front().place, 0.5, 5, all.front().colour});
  all.push_back({all[4].place, 1.5, 5, all[4].colour});
  return all;
}

TEST(FittedLight, IsThatOfTheSameAirFullyComputed) {
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2018-07-27T20:40:00Z"));
  const auto weights =
      moonlight_weights(colour::channel_weights(colour::WorkingSpace::ciexyz_d65, band_edges_nm()));
  const auto places = five_places(sky);
  LightRequest request;
  const LitBins bins{weights, places, 6};
  const FittedLight fitted(request, Unknowns::amounts, std::span(&sky, 1), std::span(&bins, 1));
  request.wish = {.tolerance = 0.001};
  for (const auto& [dust, cover, ozone] : std::array<std::array<double, 3>, 4>{
           {{1e-6, 0.3, 300}, {4.3e-6, 0.75, 180}, {1.2e-5, 0.1, 430}, {2.5e-7, 0.95, 250}}}) {
    request.air.column.dust_extinction_per_m = dust;
    request.air.column.cloud_cover = cover;
    request.air.column.ozone_du = ozone;
    const auto light = light_on_the_moon(request, sky);
    const auto exact = light.in_channels(weights), of_colour = light.in_channels(coloured(weights));
    const auto found = fitted.at({dust, cover, ozone});
    std::array<double, 3> values{}, ends{};
    for (std::size_t b = 0; b < 5; ++b) {
      std::array<double, 3> change{};
      exact.read(places[b].place, values);
      of_colour.read(places[b].place, change);
      for (std::size_t k = 0; k < 3; ++k) values[k] += places[b].colour * change[k];
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_WITHIN(found(b, k), values[k], (k < 2 ? 0.004 : 0.008) * values[k], "Accuracy")
            << dust << " " << cover << " " << ozone << ", bin " << b << ", channel " << k;
        if (b == 0) ends[k] += 0.25 * values[k];
        if (b == 4) ends[k] += 0.75 * values[k];
      }
    }
    EXPECT_WITHIN_RELATIVE(found(5, 1), ends[1], 0.004, "Accuracy");
  }
}

TEST(FittedLight, OfFactorsOnAMonthsAirIsThatAirFullyComputed) {
  // a quiet stratosphere, and one after Calbuco
  for (const char* moment : {"2018-07-27T20:40:00Z", "2015-09-28T02:50:00Z"}) {
    const auto sky = almanac::sky_at(almanac::instant_from_utc(moment));
    const auto weights = moonlight_weights(
        colour::channel_weights(colour::WorkingSpace::ciexyz_d65, band_edges_nm()));
    const auto places = five_places(sky);
    LightRequest request;
    const LitBins bins{weights, places, 6};
    const FittedLight fitted(request, Unknowns::factors, std::span(&sky, 1), std::span(&bins, 1));
    request.wish = {.tolerance = 0.001};
    for (const auto& numbers : std::array<AirNumbers, 6>{{{1, 1, 1},
                                                          {0.3, 0.4, 1.3},
                                                          {2.5, 1.6, 0.8},
                                                          {0.15, 2.5, 1.1},
                                                          {6, 0.15, 1},
                                                          {0.7, 0.08, 0.5}}}) {
      auto asked = request;
      asked.air = with_unknowns(asked.air, Unknowns::factors, numbers);
      const auto light = light_on_the_moon(asked, sky);
      const auto exact = light.in_channels(weights),
                 of_colour = light.in_channels(coloured(weights));
      const auto found = fitted.at(numbers);
      std::array<double, 3> values{}, change{};
      for (std::size_t b = 0; b < 5; ++b) {
        exact.read(places[b].place, values);
        of_colour.read(places[b].place, change);
        for (std::size_t k = 0; k < 3; ++k) values[k] += places[b].colour * change[k];
        for (std::size_t k = 0; k < 3; ++k)
          EXPECT_WITHIN_RELATIVE(found(b, k), values[k], 0.01, "Accuracy")
              << moment << ": " << numbers[0] << " " << numbers[1] << " " << numbers[2] << ", bin "
              << b << ", channel " << k;
      }
    }
  }
}

TEST(FittedLight, InANarrowRangeIsThatOfTheSameAirToAFewThousandths) {
  struct Case {
    const char *moment, *atmosphere;
    AirNumbers numbers;
  };
  // between the nodes of the whole range light is up to 0.6, 2 and 0.4 % off
  for (const auto& [moment, atmosphere, numbers] :
       {Case{"2018-07-27T20:40:00Z", "standard", {8.92, 1.88, 1.15}},
        Case{"2015-09-28T02:30:00Z", "calibrated", {4.86, 1.09, 1.44}},
        Case{"2010-12-21T08:00:00Z", "standard", {0.45, 2.13, 1.35}}}) {
    const auto sky = almanac::sky_at(almanac::instant_from_utc(moment));
    const auto weights = moonlight_weights(
        colour::channel_weights(colour::WorkingSpace::ciexyz_d65, band_edges_nm()));
    const auto places = five_places(sky);
    LightRequest request;
    request.air.atmosphere = atmosphere;
    const LitBins bins{weights, places, 6};
    AirRange range;
    for (std::size_t a = 0; a < range.size(); ++a) range[a] = {numbers[a] * 0.8, numbers[a] * 1.15};
    const FittedLight fitted(request, Unknowns::factors, std::span(&sky, 1), std::span(&bins, 1),
                             FittedAirs::fine, {}, range);
    EXPECT_EQ(fitted.range(), range);
    request.wish = {.tolerance = 0.001};
    request.by_hand.bands = 40;  // as fits have
    request.air = with_unknowns(request.air, Unknowns::factors, numbers);
    const auto light = light_on_the_moon(request, sky);
    const auto exact = light.in_channels(weights), of_colour = light.in_channels(coloured(weights));
    const auto found = fitted.at(numbers);
    std::array<double, 3> values{}, change{};
    for (std::size_t b = 0; b < 5; ++b) {
      exact.read(places[b].place, values);
      of_colour.read(places[b].place, change);
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_WITHIN_RELATIVE(found(b, k), values[k] + places[b].colour * change[k], 0.003,
                               "Accuracy")
            << moment << ", bin " << b << ", channel " << k;
    }
  }
}

TEST(FittedLight, OfAFewPlacesIsThatOfAllGroundInABin) {
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2018-07-27T20:40:00Z"));
  MoonRequest moon;
  moon.albedo_map = "built-in";
  const auto scene = fit_scene(moon, groundwork_of(moon, std::span(&sky, 1)), {}, sky);
  const auto bins = lit_bins(scene, sky);
  const FittedLight fitted(moon.light, Unknowns::amounts, std::span(&sky, 1), std::span(&bins, 1));
  moon.light.wish = {.tolerance = 0.002};
  auto& column = moon.light.air.column;
  column.dust_extinction_per_m = 1.6e-6;
  column.cloud_cover = 0.74;
  column.ozone_du = 320;
  const auto light = light_on_the_moon(moon.light, sky);
  const auto exact = light.in_channels(scene.weights),
             of_colour = light.in_channels(coloured(scene.weights));
  const auto axis = eclipse::shadow_axis(sky);
  algebra::Grid<double> sums(scene.bins, 2);
  std::array<double, 3> values{}, change{};
  for (const auto& ground : scene.grounds) {
    const auto place = eclipse::place_of_ground(axis, sky, ground.ground);
    exact.read(place, values);
    of_colour.read(place, change);
    sums(ground.bin, 0) += ground.sunlit * (values[1] + ground.colour * change[1]);
    sums(ground.bin, 1) += ground.sunlit;
  }
  const auto found =
      fitted.at({*column.dust_extinction_per_m, *column.cloud_cover, *column.ozone_du});
  for (std::size_t b = 0; b < scene.bins; ++b)
    EXPECT_WITHIN_RELATIVE(found(b, 1), sums(b, 0) / sums(b, 1), 0.003,
                           "0.1 % of the few places, 0.2 % of the reference")
        << "bin " << b;
}

}  // namespace coppermoon::uses::fitted_light_test
