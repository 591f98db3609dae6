// SPDX-License-Identifier: MIT
#include "photons/march_air.h"

#include "support/testing.h"

namespace coppermoon::photons {
namespace {

constexpr double radius_m = 6.378e6;

const atmosphere::Column full{.density = atmosphere::Density::us_1976,
                              .ozone_du = 345,
                              .ozone_path = atmosphere::OzonePath::bent,
                              .dust_extinction_per_m = 1e-6,
                              .tropospheric_optical_depth = 0.07,
                              .stratosphere = atmosphere::StratosphericAerosol::background};

/// What a table holds at an altitude: the density ratio, its slope along altitude, other profiles.
struct Held {
  double density, slope_per_m;
  std::vector<double> others;
};

template <class T>
Held held(const MarchAir<T>& air, double altitude_m) {
  const double q = reduced_height_m(altitude_m, radius_m);
  std::size_t layer = 0;
  while (q >= air.upper_m[layer]) ++layer;
  const double place = q * air.cells_per_m + air.cells_below_ground + static_cast<double>(layer);
  const double f = place - std::floor(place);
  const auto* c = &air.cells[static_cast<std::size_t>(place) * air.terms()];
  Held at{c[0] + f * (c[1] + f * (c[2] + f * c[3])),
          (c[1] + f * (2 * c[2] + f * 3 * c[3])) * air.cells_per_m * (1 + altitude_m / radius_m),
          {}};
  for (std::size_t k = 0; k < air.others.size(); ++k)
    at.others.push_back(c[4 + 2 * k] + f * c[5 + 2 * k]);
  return at;
}

template <class T>
void expect_the_column(double density_error, double slope_error) {
  const auto air = march_air<T>(full, radius_m);
  for (double h = -1500; h < 85.9e3; h += 13.7) {
    const auto at = held(air, h);
    const auto density = atmosphere::density_ratio(full, h);
    EXPECT_WITHIN_RELATIVE(at.density, density.value, density_error, "as the header says") << h;
    EXPECT_WITHIN_RELATIVE(at.slope_per_m, density.slope_per_m, slope_error, "as the header says")
        << h;
  }
}

TEST(MarchAir, HasTheDensityOfTheColumnAndItsSlope) { expect_the_column<double>(1e-9, 1e-7); }

TEST(MarchAir, HasThemAsFloatsToo) { expect_the_column<float>(3e-6, 3e-6); }

TEST(MarchAir, KeepsBothSidesOfABreakApart) {
  const auto air = march_air<double>(full, radius_m);
  for (const double h : atmosphere::breaks_m(full))
    for (const double beside : {h - 1e-3, h + 1e-3}) {
      if (beside > 85.9e3) continue;
      EXPECT_WITHIN_RELATIVE(held(air, beside).slope_per_m,
                             atmosphere::density_ratio(full, beside).slope_per_m, 1e-6,
                             "1 mm; a slope smoothed over a cell would be off by 0.1")
          << beside;
      EXPECT_EQ(held(air, beside).others[1], beside > 15e3 && beside < 20e3) << beside;
    }
}

TEST(MarchAir, HasTheOtherProfilesToTheCurvatureOfACell) {
  const auto air = march_air<double>(full, radius_m);
  ASSERT_EQ(air.others,
            (std::vector<std::size_t>{atmosphere::ozone, atmosphere::dust_layer,
                                      atmosphere::troposphere, atmosphere::stratosphere}));
  for (double h = 3; h < 60e3; h += 17.3) {
    const auto profiles = atmosphere::profiles(full, h);
    for (std::size_t k = 0; k < air.others.size(); ++k)
      EXPECT_WITHIN(held(air, h).others[k], profiles[air.others[k]],
                    1e-3 * profiles[air.others[k]] + 3e-10,
                    "50 m of aerosol that fades in over 2 km")
          << k << " at " << h;
  }
}

TEST(MarchAir, HoldsOnlyWhatTheColumnHas) {
  EXPECT_TRUE(march_air<double>({}, radius_m).others.empty());
  EXPECT_TRUE(march_air<double>({.density = atmosphere::Density::none}, radius_m).cells.empty());
}

TEST(ReducedHeight, IsHalfTheSquareOfTheRadiusOverTheEarths) {
  for (const double h : {-1000.0, 0.0, 1.0, 11e3, 86e3}) {
    const double q = reduced_height_m(h, radius_m), r = radius_m + h;
    EXPECT_WITHIN(q, (r * r - radius_m * radius_m) / (2 * radius_m), 1e-8, "rounding of r²");
    EXPECT_WITHIN(altitude_of_reduced_m(q, radius_m), h, 1e-10, "rounding");
  }
}

}  // namespace
}  // namespace coppermoon::photons
