// SPDX-License-Identifier: MIT
#include "surface/albedo_map.h"

#include "support/testing.h"
#include "surface/photometry.h"

namespace albedo_map_test {

using namespace coppermoon;
using algebra::degrees;
using algebra::in_degrees;
using surface::sampled;
using enum surface::Photometry;
using Map = algebra::Grid<float>;

/// Each texel a value of its own.
Map numbered(std::size_t rows) {
  Map map(rows, 2 * rows);
  for (std::size_t i = 0; i < map.values().size(); ++i)
    map.values()[i] = static_cast<float>(i * i % 97);
  return map;
}

/// A map of a function of the place.
template <class Albedo>
Map drawn(std::size_t rows, Albedo albedo) {
  Map map(rows, 2 * rows);
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < 2 * rows; ++c)
      map(r, c) = static_cast<float>(albedo(surface::texel_centre(r, c, rows)));
  return map;
}

TEST(TexelCentre, NorthIsUpEastIsRightAndZeroInTheMiddle) {
  const auto first = surface::texel_centre(0, 0, 2);
  EXPECT_WITHIN(in_degrees(first.latitude), 45, 1e-12, "rows of 90 degrees");
  EXPECT_WITHIN(in_degrees(first.longitude), -135, 1e-12, "columns of 90 degrees");
  const auto last = surface::texel_centre(1, 3, 2);
  EXPECT_WITHIN(in_degrees(last.latitude), -45, 1e-12, "the same");
  EXPECT_WITHIN(in_degrees(last.longitude), 135, 1e-12, "the same");
}

TEST(Sampled, GivesATexelAtItsCentre) {
  const auto map = numbered(8);
  for (std::size_t r = 0; r < 8; ++r)
    for (std::size_t c = 0; c < 16; ++c)
      EXPECT_WITHIN(sampled(map, surface::texel_centre(r, c, 8)), map(r, c), 1e-10, "rounding");
}

TEST(Sampled, IsTheMeanHalfwayBetweenTexels) {
  const auto map = numbered(2);  // centres at latitudes 45, -45, longitudes -135, -45, 45, 135
  const double mean = (map(0, 1) + map(0, 2) + map(1, 1) + map(1, 2)) / 4.0;
  EXPECT_WITHIN(sampled(map, {degrees(0), degrees(0)}), mean, 1e-12, "bilinear");
}

TEST(Sampled, GoesAroundTheSeam) {
  const auto map = numbered(2);
  const double across = (map(0, 3) + map(0, 0)) / 2.0;
  for (const double longitude : {180.0, -180.0, 540.0})
    EXPECT_WITHIN(sampled(map, {degrees(45), degrees(longitude)}), across, 1e-12, longitude);
  const double quarter = 0.75 * map(0, 3) + 0.25 * map(0, 0);  // 22.5 degrees past the centre of 90
  EXPECT_WITHIN(sampled(map, {degrees(45), degrees(157.5)}), quarter, 1e-12, "bilinear");
  EXPECT_WITHIN(sampled(map, {degrees(45), degrees(157.5 - 360)}), quarter, 1e-12,
                "a turn earlier");
}

TEST(Sampled, HoldsTheLastRowAtThePoles) {
  const auto map = numbered(4);
  const auto centre = surface::texel_centre(0, 3, 4);
  for (const double latitude : {80.0, 90.0, 95.0})
    EXPECT_WITHIN(sampled(map, {degrees(latitude), centre.longitude}), map(0, 3), 1e-12, latitude);
  EXPECT_WITHIN(sampled(map, {degrees(-90), centre.longitude}), map(3, 3), 1e-12, "the south");
}

TEST(Sampled, NeedsAMap) { EXPECT_THROW(sampled(Map(), {}), algebra::Error); }

TEST(GeometricAlbedo, OfAUniformSphereIsTheDiscMean) {
  // 2 x the integral of mu f(mu): 0.92737, whatever the size of the map.
  for (const std::size_t rows : {1U, 3U, 16U, 200U})
    EXPECT_WITHIN_RELATIVE(surface::geometric_albedo(Map(rows, 2 * rows, 0.2F), yapo_cutler),
                           0.2 * 0.92737, 1e-3, "the docstring's accuracy");
}

TEST(GeometricAlbedo, OfAUniformSphereThatLooksFlatIsItsAlbedo) {
  for (const std::size_t rows : {1U, 3U, 16U, 200U})
    EXPECT_WITHIN_RELATIVE(
        surface::geometric_albedo(Map(rows, 2 * rows, 0.2F), lommel_seeliger_rolo), 0.2, 1e-6,
        "a mean of equal floats");
}

TEST(GeometricAlbedo, SeesTheNearSideOnly) {
  const auto near_side =
      drawn(180, [](const auto& at) { return std::abs(in_degrees(at.longitude)) < 90; });
  EXPECT_WITHIN_RELATIVE(surface::geometric_albedo(near_side, yapo_cutler), 0.92737, 1e-3,
                         "the docstring's accuracy: the far side is black");
}

TEST(GeometricAlbedo, WeighsPlacesByTheirShareOfTheDisc) {
  // A polar cap north of 30 degrees is seen edge-on: the integral over the disc, by a fine polar
  // grid.
  const auto cap = drawn(360, [](const auto& at) { return in_degrees(at.latitude) > 30; });
  double sum = 0;
  const int n = 1000;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double y = -1 + 2 * (i + 0.5) / n, z = -1 + 2 * (j + 0.5) / n;
      if (z <= 0.5 || y * y + z * z >= 1) continue;
      sum += surface::radiance_factor_at_full_moon(surface::Photometry::yapo_cutler,
                                                   std::sqrt(1 - y * y - z * z));
    }
  const double expected = sum * 4 / (n * n) / std::numbers::pi;
  EXPECT_WITHIN_RELATIVE(surface::geometric_albedo(cap, yapo_cutler), expected, 4e-3,
                         "the reference's own steps at the circle and the cap's edge");
}

TEST(Normalised, HasTheGeometricAlbedoAsked) {
  const auto map =
      surface::normalised_to_geometric_albedo(numbered(64), lommel_seeliger_rolo, 0.137);
  EXPECT_WITHIN_RELATIVE(surface::geometric_albedo(map, lommel_seeliger_rolo), 0.137, 1e-6,
                         "floats' rounding");
}

TEST(Normalised, KeepsTheContrast) {
  const auto map = surface::normalised_to_geometric_albedo(numbered(8), yapo_cutler);
  const auto raw = numbered(8);
  EXPECT_WITHIN_RELATIVE(map(3, 4) / map(2, 9), raw(3, 4) / raw(2, 9), 1e-6, "floats' rounding");
}

TEST(Normalised, RefusesWhatCannotBe) {
  EXPECT_THROW(surface::normalised_to_geometric_albedo(numbered(8), yapo_cutler, 0),
               algebra::Error);
  EXPECT_THROW(surface::normalised_to_geometric_albedo(numbered(8), yapo_cutler, NAN),
               algebra::Error);
  EXPECT_THROW(surface::normalised_to_geometric_albedo(Map(8, 15, 0.1F), yapo_cutler),
               algebra::Error);
  EXPECT_THROW(surface::normalised_to_geometric_albedo(Map(8, 16, 0.0F), yapo_cutler),
               algebra::Error);
  EXPECT_THROW(surface::normalised_to_geometric_albedo(Map(8, 16, NAN), yapo_cutler),
               algebra::Error);
  EXPECT_THROW(surface::normalised_to_geometric_albedo(Map(), yapo_cutler), algebra::Error);
}

TEST(WithPolarContrast, GivesBackWhatFadesTowardsThePoles) {
  // as if a map of contrast 0.2 in the logarithm had faded as docs say
  const auto wave = [](const almanac::SelenographicPoint& at) {
    return 0.2 * std::sin(3 * algebra::in_radians(at.longitude));
  };
  const auto fade = [](double latitude) {
    return 1 - 0.63 * std::clamp((std::abs(latitude) - 64) / 6, 0., 1.);
  };
  const auto faded = drawn(
      90, [&](const auto& at) { return 0.1 * std::exp(fade(in_degrees(at.latitude)) * wave(at)); });
  const auto mended = surface::with_polar_contrast(faded);
  for (std::size_t r = 0; r < 90; ++r)
    for (std::size_t c = 0; c < 180; ++c) {
      const auto at = surface::texel_centre(r, c, 90);
      EXPECT_WITHIN_RELATIVE(mended(r, c), 0.1 * std::exp(wave(at)), 0.02,
                             "the row's mean is above that of its logarithm, by a half of 0.02");
      if (std::abs(in_degrees(at.latitude)) < 64) {
        EXPECT_EQ(mended(r, c), faded(r, c));
      }
    }
  EXPECT_EQ(surface::with_polar_contrast(Map(4, 8, 0))(0, 0), 0) << "black stays black";
}

}  // namespace albedo_map_test
