// SPDX-License-Identifier: MIT
#include "uses/fit/nuisance_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/within.h"
#include "uses/fit/limb_weather.h"
#include "uses/picture/camera_colours.h"

namespace coppermoon::uses::nuisance_table_test {

/// Two bins of linear light that falls by e from 1000 to 2000 km.
Binned photograph() {
  FitScene scene;
  scene.bins = 2;
  scene.distances_km = {1000, 2000};
  scene.usual_values = algebra::Grid<double>(2, 3, 1.);
  scene.place_slopes = algebra::Grid<double>(2, 3, -1e-3);
  Binned binned{.scene = std::make_shared<const FitScene>(scene), .light = {}};
  auto& [values, errors, sky_errors, glow_errors, slopes] = binned.light;
  for (auto* grid : {&values, &errors, &sky_errors, &glow_errors})
    *grid = algebra::Grid<double>(2, 3, 0.01);
  for (std::size_t k = 0; k < 3; ++k) values(0, k) = std::exp(1), values(1, k) = 1;
  binned.errors.value_per_cd_m2 = 1;
  binned.errors.place_error_km = 5;
  return binned;
}

std::vector<Measurement> measurements_of(std::size_t photographs) {
  std::vector<Measurement> all;
  for (std::size_t p = 0; p < photographs; ++p)
    for (std::size_t b = 0; b < 2; ++b)
      for (std::size_t k = 0; k < 3; ++k) all.push_back({p, b, k, 0, 0, 0});
  return all;
}

Design design_of_two() {
  const std::vector photographs{photograph(), photograph()};
  const NightErrors night;
  return design_of(nuisances_of(photographs, night), measurements_of(2), 2);
}

TEST(NuisanceTable, HasNoParametersForWhatIsNotInQuestion) {
  const std::vector photographs{photograph()};
  const NightErrors night;
  const auto table = nuisances_of(photographs, night);
  for (const auto* name : {"tone curve", "saturation", "mixing", "filters", "weather"}) {
    const auto row = std::ranges::find(table, name, &Nuisance::name);
    ASSERT_NE(row, table.end()) << name;
    EXPECT_EQ(row->count, 0) << name;
  }
}

TEST(NuisanceTable, SharesTheNightsParametersAndGivesEachPhotographItsOwn) {
  const auto design = design_of_two();
  const auto exposure = design.first.at("exposure"), shutter = design.first.at("shutter");
  EXPECT_LT(exposure, design.first_own);
  EXPECT_GE(shutter, design.first_own);
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_EQ(design.matrix(i, exposure), 0.1);
    EXPECT_EQ(design.matrix(i, shutter), i < 6 ? 0.03 : 0);
    EXPECT_EQ(design.matrix(i, shutter + 1), i < 6 ? 0 : 0.03);
  }
}

/// A row of a table, by name.
const Nuisance& row_of(const std::vector<Nuisance>& table, std::string_view name) {
  const auto row = std::ranges::find(table, name, &Nuisance::name);
  EXPECT_NE(row, table.end()) << name;
  return *row;
}

/// Two bins of a camera's own JPEG in the umbra's reds, as bright as expected.
struct RedNight {
  explicit RedNight(const CameraColours& colours) {
    Binned one = photograph();
    one.colours = colours;
    one.errors.mixing_error = 0.03;
    one.errors.dark_error = 0.02;
    night.expected = algebra::Grid<double>(2, 3);
    for (std::size_t b = 0; b < 2; ++b) {
      const auto xyz = xyz_of_rec709(std::array{1., b == 0 ? 0.3 : 0.2, 0.1});
      std::ranges::copy(xyz, night.expected.row(b).begin());
      std::ranges::copy(written(colours, b), one.light.values.row(b).begin());
    }
    photographs = {one};
  }

  std::array<double, 3> written(const CameraColours& colours, std::size_t b) const {
    return as_written(night.expected.row(b), colours, night.mixing, least_of_brightest);
  }

  NightErrors night;
  std::vector<Binned> photographs;
};

constexpr double step = 1e-4;

/// Half a finite difference of logarithms between two lights over a step.
double slope_between(double after, double before) { return std::log(after / before) / (2 * step); }

TEST(NuisanceTable, MovesTheWhiteBalanceInTheChannelsOfTheCamera) {
  const auto colours = camera_colours("canon-eos-600d", {});
  const RedNight red(colours);
  const auto table = nuisances_of(red.photographs, red.night);
  const auto& row = row_of(table, "own white balance");
  for (const auto& measurement : measurements_of(1))
    for (std::size_t n = 0; n < 2; ++n) {
      auto more = colours, less = colours;
      const auto channel = static_cast<int>(2 * n);
      more.gains[channel] *= std::exp(step);
      less.gains[channel] *= std::exp(-step);
      const auto [p, b, k, logarithm, error, of_computation] = measurement;
      EXPECT_WITHIN(row.derivative(measurement, n),
                    slope_between(red.written(more, b)[k], red.written(less, b)[k]), 1e-6,
                    "the step squared, over light of a tenth")
          << b << k << n;
    }
  EXPECT_LT(row.derivative({0, 0, 1, 0, 0, 0}, 0), -0.05) << "red takes from green";
}

TEST(NuisanceTable, BalancesRedPhotographsTowardsBlueTogether) {
  RedNight red(camera_colours("canon-eos-600d", {}));
  red.photographs[0].errors.white_balance_error = 0.3;
  const auto table = nuisances_of(red.photographs, red.night);
  const auto &all = row_of(table, "automatic balance"), &own = row_of(table, "own white balance");
  EXPECT_EQ(all.shared_by, SharedBy::night);
  const auto& values = red.photographs[0].light.values;
  const double redness = std::log((values(0, 0) + values(1, 0)) / (values(0, 2) + values(1, 2)));
  for (const auto& measurement : measurements_of(1)) {
    EXPECT_EQ(all.prior(measurement), 0.3);
    EXPECT_WITHIN(all.derivative(measurement, 0),
                  (own.derivative(measurement, 1) - own.derivative(measurement, 0)) / 2 * redness,
                  1e-12, "rounding");
  }
  red.photographs[0].errors.white_balance_shared = true;
  EXPECT_EQ(row_of(nuisances_of(red.photographs, red.night), "automatic balance")
                .prior(measurements_of(1).front()),
            0)
      << "a balance that was fixed, or is known as shot";
}

TEST(NuisanceTable, LiftsDarkChannelsByAShareOfTheBrightest) {
  const RedNight red(camera_colours("canon-eos-600d", {}));
  const auto table = nuisances_of(red.photographs, red.night);
  const auto &row = row_of(table, "dark channels"), &own = row_of(table, "own dark channels");
  EXPECT_EQ(row.shared_by, SharedBy::night);
  EXPECT_EQ(own.shared_by, SharedBy::photograph);
  EXPECT_EQ(row.count, 3);
  EXPECT_EQ(own.count, 3);
  for (const auto& measurement : measurements_of(1)) {
    const auto light = red.photographs[0].light.values.row(measurement.bin);
    const double lit = light[measurement.channel], lifted = step * light[0];
    EXPECT_EQ(row.prior(measurement), 0.02);
    EXPECT_EQ(own.prior(measurement), 0.01);
    for (std::size_t n = 0; n < 3; ++n) {
      EXPECT_WITHIN(row.derivative(measurement, n),
                    n == measurement.channel ? slope_between(lit + lifted, lit - lifted) : 0, 1e-4,
                    "the step squared over light of a tenth, cubed");
      EXPECT_EQ(own.derivative(measurement, n), row.derivative(measurement, n));
    }
  }
}

TEST(NuisanceTable, DimsByAerosolWhereItStandsOnTheLimb) {
  RedNight red(camera_colours("canon-eos-600d", {}));
  red.photographs[0].errors.weather_error = 0.2;
  auto scene = *red.photographs[0].scene;
  scene.sky = almanac::sky_at(almanac::instant_from_utc("2018-07-27T20:21:44Z"));
  scene.grounds = {{0, glm::dvec3(1, 0, 0), 1, 0, 0}, {1, glm::dvec3(0.8, 0.6, 0), 1, 0, 1}};
  red.photographs[0].scene = std::make_shared<const FitScene>(scene);
  red.night.dusty = red.night.expected;
  red.night.dusty_by = 0.5;
  for (std::size_t b = 0; b < 2; ++b)
    for (double& value : red.night.dusty.row(b)) value *= std::exp(-0.1);  // all light alike
  const auto table = nuisances_of(red.photographs, red.night);
  const auto& row = row_of(table, "aerosol");
  EXPECT_EQ(row.shared_by, SharedBy::night);
  ASSERT_EQ(row.count, weather_sectors);
  const auto limb = limb_of_bins(scene);
  for (const auto& measurement : measurements_of(1)) {
    EXPECT_WITHIN_RELATIVE(row.prior(measurement), 0.3, 1e-12, "1.5 of weather");
    for (std::size_t sector = 0; sector < weather_sectors; ++sector)
      EXPECT_WITHIN(row.derivative(measurement, sector), limb(measurement.bin, sector) * 0.1 / 0.5,
                    1e-9, "light falls by e^-0.1 over e^0.5 of aerosol, in the limb's part");
  }
}

TEST(NuisanceTable, MultipliesDerivativesByPriors) {
  const auto design = design_of_two();
  const auto sky = design.first.at("sky"), place = design.first.at("place");
  EXPECT_WITHIN_RELATIVE(design.matrix(1, sky + 1), 0.01 / std::exp(1), 1e-12, "error over light");
  EXPECT_EQ(design.matrix(1, sky), 0) << "sky of red, in green";
  EXPECT_WITHIN_RELATIVE(design.matrix(0, place), -5. / 1000, 1e-12, "e in 1000 km");
}

}  // namespace coppermoon::uses::nuisance_table_test
