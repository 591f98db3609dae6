// SPDX-License-Identifier: MIT
#include "uses/fit/nuisance_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/within.h"

namespace coppermoon::uses {
namespace {

/// Two bins of linear light that falls by e from 1000 to 2000 km.
Binned photograph() {
  FitScene scene;
  scene.bins = 2;
  scene.distances_km = {1000, 2000};
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

TEST(NuisanceTable, MultipliesDerivativesByPriors) {
  const auto design = design_of_two();
  const auto sky = design.first.at("sky"), place = design.first.at("place");
  EXPECT_WITHIN_RELATIVE(design.matrix(1, sky + 1), 0.01 / std::exp(1), 1e-12, "error over light");
  EXPECT_EQ(design.matrix(1, sky), 0) << "sky of red, in green";
  EXPECT_WITHIN_RELATIVE(design.matrix(0, place), -5. / 1000, 1e-12, "e in 1000 km");
}

}  // namespace
}  // namespace coppermoon::uses
