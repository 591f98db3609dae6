// SPDX-License-Identifier: MIT
#include "surface/ground.h"

#include "baker/surface/small_moon.h"
#include "support/testing.h"
#include "surface/albedo_map.h"

namespace ground_test {

using namespace coppermoon;
using algebra::degrees;
using algebra::nanometres;
using enum surface::Photometry;
using Map = algebra::Grid<float>;

double at(const Map& map, double latitude, double longitude) {
  return surface::sampled(map, {degrees(latitude), degrees(longitude)});
}

/// Mean over the disc of what a map adds to the light: another sum than the library's.
double disc_mean(const Map& map, const Map& albedo) {
  double light = 0, sum = 0;
  for (double x = -0.9975; x < 1; x += 0.005)
    for (double y = -0.9975; y < 1; y += 0.005) {
      if (x * x + y * y >= 1) continue;
      const double latitude = std::asin(y) * 180 / std::acos(-1.),
                   longitude = std::asin(x / std::sqrt(1 - y * y)) * 180 / std::acos(-1.);
      const double a = at(albedo, latitude, longitude);
      light += a;
      sum += a * at(map, latitude, longitude);
    }
  return sum / light;
}

TEST(Ground, LeavesTheDiscsColourAndSurgeAsTheyAre) {
  const auto albedo = surface::small_moon(256);
  const auto ground = surface::ground_under(albedo, lommel_seeliger_rolo);
  EXPECT_WITHIN(disc_mean(ground.colour, albedo), 0, 2e-4, "squares of the disc against cells");
  EXPECT_WITHIN(disc_mean(ground.surge, albedo), 0, 1e-3, "squares of the disc against cells");
}

/// McCord (1968), Color differences on the lunar surface: many of up to 10 % between 0.4 and 0.8 µm.
TEST(Ground, IsBlueWhereTitaniumIsAndRedWhereItIsNot) {
  const auto ground = surface::measured_ground();
  const double tranquillitatis = at(ground.colour, 8, 30), serenitatis = at(ground.colour, 27, 19);
  EXPECT_GT(tranquillitatis - serenitatis, 0.03);
  EXPECT_LT(tranquillitatis - serenitatis, 0.10);
  EXPECT_LT(at(ground.colour, 17, 59), at(ground.colour, 17, -59) + 0.03)
      << "Crisium in the east, titanium-rich Procellarum in the west";
  EXPECT_LT(at(ground.colour, 27, -52), at(ground.colour, 27, 52) - 0.03)
      << "the red plateau of Aristarchus is in the west";
}

TEST(Ground, HidesMoreShadowsWhereItIsDark) {
  const auto ground = surface::measured_ground();
  EXPECT_GT(at(ground.surge, 8, 30), at(ground.surge, -35, 15) + 0.4) << "mare and highland";
}

/// The mean of a harmonic function over a circle is that at its middle.
TEST(Ground, IsContinuedToThePolesWithoutASeam) {
  const auto ground = surface::measured_ground();
  for (const auto* map : {&ground.colour, &ground.surge}) {
    const std::size_t rows = map->rows(), first = rows / 9;  // latitude 70
    const auto mean = [&](std::size_t r) {
      double sum = 0;
      for (const float value : map->row(r)) sum += value;
      return sum / static_cast<double>(map->columns());
    };
    const auto rms = [&](std::size_t r, auto other) {
      double sum = 0;
      for (std::size_t c = 0; c < map->columns(); ++c) sum += std::pow((*map)(r, c) - other(c), 2);
      return std::sqrt(sum / static_cast<double>(map->columns()));
    };
    const auto step = [&](std::size_t r, std::size_t other) {
      return rms(r, [&](std::size_t c) { return (*map)(other, c); });
    };
    const auto spread = [&](std::size_t r) { return rms(r, [&](std::size_t) { return mean(r); }); };
    const std::size_t last = rows - 1 - first;
    for (std::size_t r = 0; r < first; ++r) {
      EXPECT_WITHIN(mean(r), mean(first), 1e-5, "floats");
      EXPECT_WITHIN(mean(rows - 1 - r), mean(last), 1e-5, "floats");
    }
    EXPECT_LT(step(first - 1, first), spread(first) / 2) << "no cut to a mean";
    EXPECT_LT(step(last + 1, last), spread(last) / 2) << "no cut to a mean";
    const auto [least, most] = std::ranges::minmax(map->row(0));
    EXPECT_LT(most - least, 0.02 * std::abs(mean(0))) << "one value at the pole";
  }
}

TEST(Ground, GoesAroundTheSeam) {
  const auto colour = surface::measured_ground().colour;
  double across = 0, beside = 0;
  for (std::size_t r = 20; r < 160; ++r) {
    across += std::abs(colour(r, 359) - colour(r, 0));
    beside += std::abs(colour(r, 90) - colour(r, 91));
  }
  EXPECT_LT(across, 2 * beside) << "neighbours like any others";
}

TEST(ColourSpectrum, IsOneLessInTheGreenThanInTheBlue) {
  EXPECT_WITHIN(surface::colour_spectrum(nanometres(415)), 1, 1e-4, "printed coefficients");
  EXPECT_EQ(surface::colour_spectrum(nanometres(566)), 0);
  EXPECT_WITHIN(surface::colour_spectrum(nanometres(643)), -0.3745, 1e-4, "four digits");
  EXPECT_WITHIN(surface::colour_spectrum(nanometres(380)), 1.282, 1e-3, "four digits");
  EXPECT_WITHIN(surface::colour_spectrum(nanometres(780)), -0.815, 1e-3, "three digits");
  EXPECT_THROW(surface::colour_spectrum(nanometres(379)), algebra::Error);
}

/// Hapke's shadow-hiding surge over a phase function p, with light scattered more than once.
double hapke(double amplitude, double phase_deg) {
  const double b = 1 / (1 + std::tan(phase_deg * std::acos(-1.) / 360) / 0.073);
  return 1 + amplitude * b + 0.158;
}

TEST(SurgeSlope, IsHowHapkesSurgeChangesWithItsAmplitude) {
  EXPECT_EQ(surface::surge_slope(lommel_seeliger_rolo, surface::full_moon_phase), 0);
  for (const double phase : {0.3, 0.95, 5., 60.}) {
    const auto ratio = [&](double amplitude) {
      return std::log(hapke(amplitude, phase) / hapke(amplitude, 1.5));
    };
    EXPECT_WITHIN(surface::surge_slope(lommel_seeliger_rolo, degrees(phase)),
                  (ratio(1.88) - ratio(1.86)) / 0.02, 1e-6, "a difference of 0.02");
  }
  EXPECT_WITHIN(surface::surge_slope(lommel_seeliger_rolo, degrees(0.95)), 0.0074, 1e-4, "docs");
  EXPECT_WITHIN(surface::surge_slope(lommel_seeliger_rolo, degrees(7)), -0.059, 1e-3, "docs");
  EXPECT_WITHIN(surface::surge_slope(lommel_seeliger_rolo, degrees(60)), -0.227, 1e-3, "docs");
  EXPECT_EQ(surface::surge_slope(yapo_cutler, degrees(60)), 0);
}

TEST(Ground, NeedsLight) {
  EXPECT_THROW(surface::ground_under(Map(8, 16, 0), lommel_seeliger_rolo), algebra::Error);
}

}  // namespace ground_test
