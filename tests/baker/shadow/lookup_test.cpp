// SPDX-License-Identifier: MIT
#include "shadow/lookup.h"

#include <cmath>
#include <numbers>

#include "shadow/by_quadrature.h"
#include "support/within.h"

namespace coppermoon::shadow {
namespace {

const Arrangement around_the_moon{1.479e11, {3.812e8, 3.821e8, 3.829e8}};

DirectLight direct(std::vector<double> waves) { return {{}, around_the_moon, waves}; }

eclipse::ShadowPlace place(double axis_distance_m, double depth_m, double turn = 0) {
  return {algebra::metres(axis_distance_m), algebra::radians(turn), algebra::metres(depth_m)};
}

double read(const Lookup& lookup, const eclipse::ShadowPlace& at) {
  double value = NAN;
  lookup.read(at, {&value, 1});
  return value;
}

ChannelWeights one_channel(std::size_t waves, double weight = 1) { return {1, waves, weight}; }

TEST(Lookup, IsTheQuadraturePlusDirectLightBetweenItsNodes) {
  const std::vector<double> waves{550};
  std::vector<double> nodes;
  for (double d = 0; d < 8.6e6; d += 25e3) nodes.push_back(d);
  const Lookup lookup(by_quadrature({}, around_the_moon, waves, nodes), direct(waves),
                      one_channel(1));
  for (const double at_m : {3e3, 1.2341e6, 3.333e6, 4.404e6, 5.0127e6, 7.77e6}) {
    const double depth = 3.8177e8;  // between planes
    const std::vector<double> here{at_m};
    const auto exact = by_quadrature({}, {around_the_moon.sun_distance_m, {depth}}, waves, here);
    const double total = exact.ratio[0](0, 0) + 1 -
                         covered_part(at_m, depth, around_the_moon.sun_distance_m, 6.42e6);
    EXPECT_WITHIN_RELATIVE(
        read(lookup, place(at_m, depth)), total, 2e-3,
        "straight lines over 25 km, 10 km and 900 km of depth; worst at the umbra's rim");
  }
}

TEST(Lookup, BeyondThePenumbraAndOnTheSunsSideIsSunlight) {
  const RefractedLight none{around_the_moon,
                            {550},
                            {0, 1e5},
                            1,
                            {3, algebra::Grid<double>(2, 1)},
                            {3, algebra::Grid<double>(2, 1)}};
  const Lookup lookup(none, direct({550}), one_channel(1, 7));
  EXPECT_EQ(read(lookup, place(1e7, 3.82e8)), 7);
  EXPECT_EQ(read(lookup, place(0, -3.82e8)), 7);
  EXPECT_EQ(read(lookup, place(1e6, 3.82e8)), 0);
  EXPECT_EQ(read(Lookup(one_channel(3, 2)), place(0, 3.82e8)), 6);
}

TEST(Lookup, SumsWavelengthsWithTheChannelsWeights) {
  RefractedLight light{around_the_moon, {500, 600}, {0, 1e6, 2e6}, 1, {}, {}};
  algebra::Grid<double> ratio(3, 2, 0.25);
  for (std::size_t d = 0; d < 3; ++d) ratio(d, 1) = 0.5;
  light.ratio.assign(3, ratio);
  light.standard_error.assign(3, algebra::Grid<double>(3, 2, 0.03));
  ChannelWeights weights(1, 2, 3);
  weights(0, 1) = 4;
  const Lookup lookup(light, direct({500, 600}), weights);
  EXPECT_WITHIN(read(lookup, place(5e5, 3.82e8)), 3 * 0.25 + 4 * 0.5, 1e-14, "closed form");
  EXPECT_WITHIN(lookup.worst_relative_error(0, 0, 1e6), 0.03 * 5 / 2.75, 1e-14,
                "errors of 3 and 4 add to 5");
  light.errors_add = true;
  EXPECT_WITHIN(Lookup(light, direct({500, 600}), weights).worst_relative_error(0, 0, 1e6),
                0.03 * 7 / 2.75, 1e-14, "of the same photons, to 7");
}

TEST(Lookup, TurnsWithThePositionAngle) {
  RefractedLight light{around_the_moon, {500}, {0, 1e6, 2e6}, 4, {}, {}};
  for (int plane = 0; plane < 3; ++plane)
    for (int sector = 0; sector < 4; ++sector) {
      light.ratio.emplace_back(3, 1, 0.1 * sector);
      light.standard_error.emplace_back(3, 1);
    }
  const Lookup lookup(light, direct({500}), one_channel(1));
  const double quarter = std::numbers::pi / 2;
  EXPECT_WITHIN(read(lookup, place(5e5, 3.82e8, quarter)), 0.1, 1e-14,
                "the middle of sector 1, to the east");
  EXPECT_WITHIN(read(lookup, place(5e5, 3.82e8, 1.5 * quarter)), 0.15, 1e-14,
                "half way to sector 2");
  EXPECT_WITHIN(read(lookup, place(5e5, 3.82e8, 3.5 * quarter)), 0.15, 1e-14,
                "half way from sector 3 to 0");
}

}  // namespace
}  // namespace coppermoon::shadow
