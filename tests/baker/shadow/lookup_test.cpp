// SPDX-License-Identifier: MIT
#include "shadow/lookup.h"

#include "algebra/interpolation.h"
#include "shadow/by_quadrature.h"
#include "shadow/lookup_table.h"
#include "support/testing.h"

namespace coppermoon::shadow::lookup_test {

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

TEST(Lookup, FollowsLinesFromTheLimbFromPlaneToPlane) {
  // Two planes a lunar radius apart: at half way straight down the depth errs by 2e-3 of so steep a
  // fall, along the lines by what two limbs and the spreading of light leave.
  const std::vector<double> waves{550};
  const Arrangement two{1.479e11, {3.812e8, 3.829e8}};
  std::vector<double> nodes;
  for (double d = 2e6; d < 5e6; d += 10e3) nodes.push_back(d);
  const Lookup lookup(by_quadrature({}, two, waves, nodes), DirectLight({}, two, waves),
                      one_channel(1), {.from_m = 2.1e6, .to_m = 4.5e6, .tolerance = 1e-5});
  for (const double at_m : {2.5e6, 3e6, 3.5e6, 4e6, 4.3e6}) {
    const double depth = 3.8205e8;
    const std::vector<double> here{at_m};
    const auto exact = by_quadrature({}, {two.sun_distance_m, {depth}}, waves, here);
    EXPECT_WITHIN_RELATIVE(read(lookup, place(at_m, depth)), exact.ratio[0](0, 0), 2e-4,
                           "measured: 1e-4 at most; straight down the depth it is 1e-3")
        << at_m;
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
  EXPECT_WITHIN(lookup.worst_relative_error(light, weights, 0, 1e6), 0.03 * 5 / 2.75, 1e-14,
                "errors of 3 and 4 add to 5");
  light.errors_correlated = true;
  EXPECT_WITHIN(lookup.worst_relative_error(light, weights, 0, 1e6), 0.03 * 7 / 2.75, 1e-14,
                "of the same photons, to 7");
}

TEST(Lookup, PartsAddUpToAllOfTheLight) {
  const std::vector<double> waves{550}, places{0, 2e6, 4e6, 6e6, 8e6};
  const double depth = 3.8e8;
  const auto refracted =
      by_quadrature({}, {around_the_moon.sun_distance_m, {depth}}, waves, places);
  const auto part = [&](LightPart which) {
    return Lookup(refracted, direct({550}), one_channel(1, 7), {}, which);
  };
  const auto all = part(LightPart::all), bent = part(LightPart::refracted),
             straight = part(LightPart::direct);
  for (const double at_m : {0., 3e6, 4.6e6, 6e6, 7.9e6})
    EXPECT_WITHIN_RELATIVE(
        read(bent, place(at_m, depth)) + read(straight, place(at_m, depth)),
        read(all, place(at_m, depth)), 3e-4,
        "straight lines between nodes, to 1e-4 of the light in each of the three");
  EXPECT_EQ(read(straight, place(0, depth)), 0) << "no sunlight passes clear into the umbra";
  EXPECT_GT(read(bent, place(0, depth)), 0);
  EXPECT_EQ(read(bent, place(1e7, depth)), 0) << "beyond the penumbra all light is direct";
  EXPECT_EQ(read(straight, place(1e7, depth)), 7);
}

TEST(Lookup, HasTheDirectLightOfEachPositionAngle) {
  const atmosphere::Atmosphere flat{.earth = atmosphere::ellipsoid(0)};
  const std::vector<double> waves{550}, places{4e6, 5e6};
  const Arrangement plane{1.479e11, {3.82e8}};
  const DirectLight clear(flat, plane, waves);
  const auto dark = darkness(plane, waves, places, sectors_around);
  const Lookup lookup(dark, clear, one_channel(1), {.from_m = 4e6, .to_m = 5e6});
  const double quarter = std::numbers::pi / 2;
  std::array<double, 4> direct;
  for (std::size_t i = 0; i < direct.size(); ++i) {
    const double turn = static_cast<double>(i) * quarter;
    clear.ratios(4.8e6, turn, 3.82e8, {&direct[i], 1});
    EXPECT_WITHIN_RELATIVE(read(lookup, place(4.8e6, 3.82e8, turn)), direct[i], 2e-3,
                           "straight lines over 10 km");
  }
  EXPECT_GT(direct[0], 1.1 * direct[1]) << "over the poles more of the Sun is clear";
}

TEST(Lookup, TurnsWithThePositionAngle) {
  RefractedLight light{around_the_moon, {500}, {0, 1e6, 2e6}, 4, {}, {}};
  for (int plane = 0; plane < 3; ++plane)
    for (int sector = 0; sector < 4; ++sector) {
      light.ratio.emplace_back(3, 1, 0.125 * sector);  // whole in single precision
      light.standard_error.emplace_back(3, 1);
    }
  const Lookup lookup(light, direct({500}), one_channel(1));
  const double quarter = std::numbers::pi / 2;
  EXPECT_WITHIN(read(lookup, place(5e5, 3.82e8, quarter)), 0.125, 1e-14,
                "the middle of sector 1, to the east");
  EXPECT_WITHIN(read(lookup, place(5e5, 3.82e8, 1.5 * quarter)), 0.1875, 1e-14,
                "half way to sector 2, on a line");
  EXPECT_WITHIN(read(lookup, place(5e5, 3.82e8, 3.5 * quarter)), 0.1875, 1e-14,
                "half way from sector 3 to 0: (9 (0 + 3) - (1 + 2)) / 16 of 0.125");
}

TEST(Lookup, RunsOnCubicsAroundTheAxis) {
  constexpr std::size_t sectors = 24;
  const auto wave = [](double turn) { return 2 + std::cos(2 * turn) + 0.5 * std::sin(turn); };
  const double a_sector = 2 * std::numbers::pi / sectors;
  RefractedLight light{around_the_moon, {500}, {0, 1e6, 2e6}, sectors, {}, {}};
  for (std::size_t grid = 0; grid < 3 * sectors; ++grid)
    light.ratio.emplace_back(3, 1, wave(a_sector * static_cast<double>(grid % sectors)));
  const Lookup lookup(light, direct({500}), one_channel(1));
  for (double turn = 0; turn < 2 * std::numbers::pi; turn += 0.01)
    EXPECT_WITHIN(
        read(lookup, place(5e5, 3.82e8, turn)), wave(turn), 2e-3,
        "3/128 of a sector's fourth power, times 16.5: 1.8e-3; straight lines err by 0.04")
        << turn;
}

TEST(Lookup, OfOneBrightSectorIsNeverDarkerThanBlack) {
  constexpr std::size_t sectors = 24;
  RefractedLight light{around_the_moon, {500}, {0, 1e6, 2e6}, sectors, {}, {}};
  for (std::size_t grid = 0; grid < 3 * sectors; ++grid)
    light.ratio.emplace_back(3, 1, grid % sectors == 5 ? 0.5 : 0);
  const Lookup lookup(light, direct({500}), one_channel(1));
  for (double turn = 0; turn < 2 * std::numbers::pi; turn += 0.01)
    EXPECT_GE(read(lookup, place(5e5, 3.82e8, turn)), 0) << turn;
}

/// Light of one wavelength on one plane, the same around the axis.
RefractedLight light_of(const std::function<double(double)>& ratio, double spacing_m,
                        std::size_t places) {
  RefractedLight light{{1.479e11, {3.82e8}}, {550}, {}, 1, {}, {}};
  algebra::Grid<double> values(places, 1);
  for (std::size_t i = 0; i < places; ++i) {
    light.axis_distances_m.push_back(spacing_m * static_cast<double>(i));
    values(i, 0) = ratio(light.axis_distances_m.back());
  }
  light.ratio.assign(1, values);
  light.standard_error.assign(1, algebra::Grid<double>(places, 1));
  return light;
}

TEST(Lookup, FollowsACubicOfTheLogarithmBetweenPlaces) {
  const auto steep = [](double m) { return 1e-3 * std::exp(std::pow(m / 1e6 - 1.5, 3)); };
  auto light = light_of(steep, 250e3, 13);
  light.photons = 1;
  const Lookup lookup(light, direct({550}), one_channel(1));
  for (const double at_m : {10e3, 333e3, 1.4567e6, 2.7182e6, 2.99e6})
    EXPECT_WITHIN_RELATIVE(read(lookup, place(at_m, 3.82e8)), steep(at_m), 1e-4,
                           "the tolerance of the straight lines between nodes");
}

TEST(Lookup, FollowsACubicWhereLightIsNotKnownWell) {
  const auto cubic = [](double m) { return 1e-3 * (1 + std::pow(m / 1e6 - 1.5, 3)) + 5e-3; };
  auto light = light_of(cubic, 250e3, 13);
  light.photons = 1;
  for (std::size_t i = 0; i < 13; ++i) light.standard_error[0](i, 0) = 0.4 * light.ratio[0](i, 0);
  const Lookup lookup(light, direct({550}), one_channel(1));
  for (const double at_m : {10e3, 333e3, 1.4567e6, 2.7182e6, 2.99e6})
    EXPECT_WITHIN_RELATIVE(read(lookup, place(at_m, 3.82e8)), cubic(at_m), 1e-4,
                           "the tolerance of the straight lines between nodes");
}

double read(const BetweenPlaces& light, std::size_t sector, double at_m) {
  double value = NAN;
  light.read(0, sector, at_m, {&value, 1});
  return value;
}

TEST(BetweenPlaces, FollowsLightThatFallsByEInTwoSpacings) {
  const auto falling = [](double m) { return 1e-2 * std::exp(-m / 100e3); };
  auto light = light_of(falling, 50e3, 60);
  light.photons = 1;
  const BetweenPlaces known(light);
  for (double at_m = 0; at_m < 2.95e6; at_m += 7e3)
    EXPECT_WITHIN_RELATIVE(read(known, 0, at_m), falling(at_m), 1e-12, "a line of the logarithm");
  for (std::size_t i = 0; i < 60; ++i) light.standard_error[0](i, 0) = 0.4 * light.ratio[0](i, 0);
  const BetweenPlaces noisy(light);
  for (double at_m = 50e3; at_m < 2.9e6; at_m += 7e3)
    EXPECT_WITHIN_RELATIVE(read(noisy, 0, at_m), falling(at_m), 2e-3,
                           "3/128 (h/L)⁴ = 1.5e-3, and what follows; a hundredth of the noise");
}

TEST(BetweenPlaces, AreNeverFarAboveTheirNeighbours) {
  const std::vector<double> values{1, 1e-3, 1, 1, 1e-40, 1, 0, 1, 1};
  const auto ragged = [&](double m) { return values[static_cast<std::size_t>(m / 50e3 + 0.5)]; };
  auto light = light_of(ragged, 50e3, values.size());
  light.photons = 1;
  const BetweenPlaces between(light);
  for (double at_m = 0; at_m < 400e3; at_m += 1e3) {
    EXPECT_GE(read(between, 0, at_m), 0) << at_m;
    EXPECT_LE(read(between, 0, at_m), 2.4) << "e^(7/8), the cubic's largest overshoot: " << at_m;
  }
}

TEST(BetweenPlaces, OfRingsGoOnBeyondTheAxisInTheOppositeSector) {
  // rings of 200 km, two sectors; a logarithm that is a slope plus a parabola on a line through both
  RefractedLight light{{1.479e11, {3.82e8}}, {550}, {}, 2, {}, {}};
  const auto on_line = [](double m) { return 1e-3 * std::exp(m / 1e6 + m * m / 1e12); };
  light.ratio.assign(2, algebra::Grid<double>(9, 1));
  light.standard_error.assign(2, algebra::Grid<double>(9, 1));
  for (std::size_t i = 0; i < 9; ++i) {
    light.axis_distances_m.push_back((static_cast<double>(i) + 0.5) * 200e3);
    light.ratio[0](i, 0) = on_line(light.axis_distances_m[i]);
    light.ratio[1](i, 0) = on_line(-light.axis_distances_m[i]);
  }
  EXPECT_WITHIN_RELATIVE(read(BetweenPlaces(light), 0, 0), light.ratio[0](0, 0), 1e-14,
                         "held before places that are no rings");
  light.photons = 1;
  const BetweenPlaces between(light);
  for (const double at_m : {0., 30e3, 100e3, 170e3, 444e3}) {
    EXPECT_WITHIN_RELATIVE(read(between, 0, at_m), on_line(at_m), 1e-12, "a cubic's own");
    EXPECT_WITHIN_RELATIVE(read(between, 1, at_m), on_line(-at_m), 1e-12, "a cubic's own");
  }
  EXPECT_WITHIN_RELATIVE(read(between, 0, 1.79e6), light.ratio[0](8, 0), 1e-14,
                         "held to the ring's end");
  EXPECT_EQ(read(between, 0, 1.81e6), 0);
}

TEST(Lookup, KeepsTheToleranceAskedFor) {
  const auto falling = [](double m) { return 1e-2 * std::exp(-m / 300e3); };
  const auto light = light_of(falling, 25e3, 121);
  for (const double tolerance : {1e-3, 1e-4, 1e-5}) {
    const Lookup lookup(light, direct({550}), one_channel(1), {.tolerance = tolerance});
    for (double at_m = 1e3; at_m < 2.9e6; at_m += 7e3)
      EXPECT_WITHIN_RELATIVE(read(lookup, place(at_m, 3.82e8)), falling(at_m), tolerance + 2e-6,
                             "the cubics of 25 km add 1e-6");
  }
}

TEST(Lookup, KeepsTheToleranceWhereDirectLightBegins) {
  // the paper's air, with dust: of a dim umbra, and bent light ends as sharply as direct light begins
  const atmosphere::Atmosphere dusty{.column = {.dust_extinction_per_m = 4.7e-6}};
  const Arrangement plane{1.479e11, {3.82e8}};
  const std::vector<double> waves{550};
  const double edge_m =
      (6.378e6 + 42e3) * (1 + 3.82e8 / 1.479e11) - projected_solar_radius_m(plane, 3.82e8);
  std::vector<double> known, between;
  for (double m = -150.4e3; m <= 150e3; m += 1e3) known.push_back(edge_m + m);
  for (double m = -30e3; m <= 30e3; m += 250) between.push_back(edge_m + m);
  const DirectLight clear(dusty, plane, waves);
  const auto exact = by_quadrature(dusty, plane, waves, between, {.rays = 2000});
  const auto bent = by_quadrature(dusty, plane, waves, known, {.rays = 2000});
  for (const double tolerance : {1e-3, 1e-4}) {
    const Lookup lookup(bent, clear, one_channel(1),
                        {.from_m = known.front(), .to_m = known.back(), .tolerance = tolerance});
    for (std::size_t i = 0; i < between.size(); ++i) {
      double direct = NAN;
      clear.ratios(between[i], 0, 3.82e8, {&direct, 1});
      EXPECT_WITHIN_RELATIVE(read(lookup, place(between[i], 3.82e8)), exact.ratio[0](i, 0) + direct,
                             1.5 * tolerance, "three nodes seldom stand where lines are worst")
          << tolerance << ", " << between[i] - edge_m;
    }
  }
}

TEST(Lookup, IsNeverDarkerThanBlack) {
  const auto noisy = [](double m) { return std::fmod(m / 50e3, 5) == 2 ? 1e-3 : 0; };
  const Lookup lookup(light_of(noisy, 50e3, 40), direct({550}), one_channel(1));
  for (double at_m = 0; at_m < 1.9e6; at_m += 1.3e3)
    EXPECT_GE(read(lookup, place(at_m, 3.82e8)), 0) << at_m;
}

TEST(Lookup, HoldsItsEndsOutsideItsRange) {
  const auto falling = [](double m) { return 1e-2 * std::exp(-m / 300e3); };
  const Lookup lookup(light_of(falling, 25e3, 121), direct({550}), one_channel(1),
                      {.from_m = 1e6, .to_m = 2e6});
  EXPECT_WITHIN_RELATIVE(read(lookup, place(0, 3.82e8)), falling(1e6), 1e-5, "a node");
  EXPECT_WITHIN_RELATIVE(read(lookup, place(1.5e6, 3.82e8)), falling(1.5e6), 1e-4, "tolerance");
  EXPECT_WITHIN_RELATIVE(read(lookup, place(3e6, 3.82e8)), falling(2e6), 0.04,
                         "the last node is less than 10 km beyond");
  EXPECT_EQ(read(lookup, place(1e7, 3.82e8)), 1) << "sunlight";
}

/// Ratios that are straight between planes, 2, 3 and 4, by sector times (8 + s)/128: whole in single
/// precision.
RefractedLight light_by_sector(std::size_t sectors) {
  RefractedLight light{around_the_moon, {500, 600}, {0, 1e6, 2e6, 3e6}, sectors, {}, {}};
  for (std::size_t plane = 0; plane < 3; ++plane)
    for (std::size_t s = 0; s < sectors; ++s) {
      light.ratio.emplace_back(
          4, 2, (8 + static_cast<double>(s)) / 128 * (2 + static_cast<double>(plane)));
      light.standard_error.emplace_back(4, 2);
    }
  return light;
}

/// A cubic through whole numbers that count 24 sectors, and begin anew.
double around_the_axis(double turn) {
  const std::array<double, 4> nodes{-1, 0, 1, 2};
  const double before = std::floor(turn);
  const auto shares = algebra::on_polynomial(std::span(nodes), turn - before);
  double value = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    value += shares[i] * std::fmod(before + nodes[i] + 24, 24);
  return value;
}

TEST(Lookup, ReadsManyPlacesByTheClosedForm) {
  constexpr std::size_t sectors = 24, count = 151, channels = 5;
  ChannelWeights weights(channels, 2, 1);
  for (std::size_t c = 0; c < channels; ++c) weights(c, 0) = static_cast<double>(c);
  const Lookup lookup(light_by_sector(sectors), direct({500, 600}), weights);
  std::vector<double> east, north, depth, values(count * channels);
  for (std::size_t i = 0; i < count; ++i) {
    const double turn = 0.7 * static_cast<double>(i), r = 1e4 * static_cast<double>(i);
    east.push_back(r * std::sin(turn));
    north.push_back(r * std::cos(turn));
    depth.push_back(3.810e8 + 1.5e4 * static_cast<double>(i));
  }
  lookup.read({east, north, depth}, values);
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = std::atan2(east[i], north[i]), whole = 2 * std::numbers::pi;
    const double turn = (angle < 0 ? angle + whole : angle) / whole * sectors;
    const double s = around_the_axis(turn);
    const auto& planes = around_the_moon.depths_m;
    const double in_depth = 2 +
                            std::clamp((depth[i] - planes[0]) / (planes[1] - planes[0]), 0., 1.) +
                            std::clamp((depth[i] - planes[1]) / (planes[2] - planes[1]), 0., 1.);
    for (std::size_t c = 0; c < channels; ++c)
      EXPECT_WITHIN_RELATIVE(values[i * channels + c],
                             static_cast<double>(c + 1) * (8 + s) / 128 * in_depth, 1e-12,
                             "linear in depth, cubic in angle: rounding alone");
  }
}

/// A cell whole, one in four, one in two.
TEST(LookupTable, ReadsStraightLinesBetweenUnevenNodes) {
  const std::array parts{1., 4., 2.};
  LookupTable table;
  table.channels = 1;
  table.depths_m = {3.8e8};
  table.sunlight.assign(channel_padding, 9);
  table.middle_depth_m = 3.8e8;
  table.nodes = uneven_nodes(1e6, 8e3, parts);
  table.end_m = 1e7;
  const std::vector<double> nodes_m{1e6,     1.008e6, 1.01e6, 1.012e6,
                                    1.014e6, 1.016e6, 1.02e6, 1.024e6};
  EXPECT_EQ(table.nodes.at_m, nodes_m);
  table.values = algebra::Grid<float>(nodes_m.size(), channel_padding);
  for (std::size_t i = 0; i < nodes_m.size(); ++i)
    table.values(i, 0) = static_cast<float>(i * i);  // whole in single precision
  std::vector<double> east, none, depth;
  for (double at = 0.99e6; at < 1.03e6; at += 250) {
    east.push_back(at);
    none.push_back(0);
    depth.push_back(3.8e8);
  }
  std::vector<double> values(east.size());
  read(table, {east, none, depth}, values);
  std::vector<double> squares;
  for (std::size_t i = 0; i < nodes_m.size(); ++i) squares.push_back(static_cast<double>(i * i));
  for (std::size_t i = 0; i < east.size(); ++i)
    EXPECT_WITHIN(values[i], algebra::interpolated(nodes_m, squares, east[i]), 1e-9,
                  "straight lines; rounding of a distance in metres")
        << east[i];
}

/// Light that is dark up to an edge: nodes are a tenth as far apart there, and only there.
TEST(Lookup, KeepsItsToleranceOnBothSidesOfAnEdge) {
  const auto ratio = [](double at_m) { return 1 + 1e-3 * std::exp((at_m - 1e6) / 40e3); };
  const auto light = light_of(ratio, 10e3, 140);
  const Lookup lookup(light, direct({550}), one_channel(1), {.to_m = 1.3e6, .tolerance = 1e-4});
  for (double at = 1e5; at < 1.28e6; at += 3.7e3)
    EXPECT_WITHIN_RELATIVE(read(lookup, place(at, 3.82e8)), ratio(at), 1.2e-4,
                           "the tolerance, and a cubic of 10 km")
        << at;
}

TEST(Lookup, HoldsTheSectorsAskedForAlone) {
  constexpr std::size_t sectors = 24;
  const auto light = light_by_sector(sectors);
  const auto lookup = [&](std::size_t first, std::size_t count) {
    return Lookup(light, direct({500, 600}), {3, 2, 1},
                  {.to_m = 3e6, .sectors = {sectors, first, count}});
  };
  const auto all = lookup(0, sectors);
  const auto value = [](const Lookup& of, double sector) {
    std::array<double, 3> three{};
    const double turn = 2 * std::numbers::pi * std::fmod(sector, sectors) / sectors;
    of.read(place(1.234e6, 3.817e8, turn), three);
    EXPECT_EQ(three[0], three[2]);
    return three[1];
  };
  for (const std::size_t first : {0, 5, 20, 23}) {  // of six, which may go on past the north
    const auto some = lookup(first, 6);
    const auto begin = static_cast<double>(first);
    for (const double after : {1., 1.25, 2., 3.5, 3.999, 4.})
      EXPECT_WITHIN_RELATIVE(value(some, begin + after), value(all, begin + after), 1e-12,
                             "an angle is rounded to either side of its sector");
    EXPECT_WITHIN_RELATIVE(value(some, begin + 5.5),
                           (9 * value(all, begin + 5) - value(all, begin + 4)) / 16, 1e-12,
                           "half way into the dark");
    for (const double after : {7.001, 12.5, 21.99}) EXPECT_EQ(value(some, begin + after), 0);
  }
}

}  // namespace coppermoon::shadow::lookup_test
