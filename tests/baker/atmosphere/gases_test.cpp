// SPDX-License-Identifier: MIT
#include "atmosphere/gases.h"

#include "atmosphere/density.h"
#include "support/testing.h"

namespace coppermoon::atmosphere::gases_test {

using algebra::nanometres;

// Greenblatt et al. (1990), J. Geophys. Res. 95, 18577, at 296 K: peak [1e-46 cm⁵] and width [nm] of each
// band; its area is their product, here the sum over the band in steps of 1 nm.
TEST(OxygenPairs, HaveTheBandsOfAnotherMeasurement) {
  struct Band {
    double centre_nm, peak, width_nm;
  };
  for (const auto& [centre, peak, width] : {Band{577.2, 11.0, 11.6}, Band{630.0, 7.2, 13.8}}) {
    double area = 0;
    for (double nm = centre - 25; nm <= centre + 25; nm += 1)
      area += oxygen_pair_cross_section_m5(nanometres(nm)) * 1e56;
    EXPECT_WITHIN_RELATIVE(area, 1.2 * peak * width, 0.2,
                           "a band of that width has 1.06 (Gauss) to 1.57 (Lorentz) of the product")
        << centre;
  }
  EXPECT_EQ(oxygen_pair_cross_section_m5(nanometres(700)), 0);
  EXPECT_THROW(oxygen_pair_cross_section_m5(nanometres(379)), algebra::Error);
}

// IUPAC (2003), Mérienne et al. (1995), at 298 K.
TEST(NitrogenDioxide, HasTheCrossSectionOfAnotherMeasurement) {
  EXPECT_WITHIN_RELATIVE(nitrogen_dioxide_cross_section_m2(nanometres(380)), 5.924e-23, 0.02,
                         "JPL and IUPAC agree to 1.6 % there");
  EXPECT_THROW(nitrogen_dioxide_cross_section_m2(nanometres(781)), algebra::Error);
}

// The AFGL profile's own column over the US standard atmosphere is 5.6e15 cm⁻².
TEST(NitrogenDioxide, HasTheColumnOfItsProfile) {
  double column = 0;
  for (double h = 25; h < 86e3; h += 50) column += 50 * nitrogen_dioxide_per_m3(h);
  EXPECT_WITHIN_RELATIVE(column, 5.6e19, 0.1, "of middle latitudes in summer");
}

/// Integral of a profile along a straight ray over a sphere of 6371 km [m].
template <typename Profile>
double along_limb(double tangent_height_m, Profile profile) {
  constexpr double radius_m = 6371e3, step_m = 1e3, end_m = 1000e3;
  double sum = 0;
  for (double s = step_m / 2; s < end_m; s += step_m)
    sum += 2 * step_m * profile(std::hypot(radius_m + tangent_height_m, s) - radius_m);
  return sum;
}

/// Light that a band takes, as the width of a black band [nm].
template <typename Extinction>
double width_nm(double from_nm, double to_nm, double path_m, Extinction extinction_per_m) {
  double sum = 0;
  for (double nm = from_nm; nm <= to_nm; nm += 1)
    sum += 1 - std::exp(-path_m * extinction_per_m(nanometres(nm)));
  return sum;
}

/// Tangent height and the widths of bands there [nm].
template <std::size_t bands>
struct Limb {
  double km;
  std::array<double, bands> widths_nm;
};

// Widths: band model of LOWTRAN 7 every 5 cm⁻¹, along rays through the US standard atmosphere of AFGL-TR-86-0110.
TEST(OxygenBands, TakeTheLightOfABandModelAlongTheLimb) {
  for (const auto& [km, widths] :
       {Limb<3>{5, {0.522, 3.253, 8.385}}, Limb<3>{10, {0.260, 1.897, 6.669}},
        Limb<3>{15, {0.113, 0.911, 4.302}}, Limb<3>{20, {0.049, 0.407, 2.300}}}) {
    const double path_m = along_limb(km * 1e3, density_ratio_us_1976);
    const auto width = [&](double from, double to) {
      return width_nm(from, to, path_m, oxygen_bands_per_m);
    };
    EXPECT_WITHIN_RELATIVE(width(610, 650), widths[0], 0.15, "powers 0.5 and 0.5641") << km;
    EXPECT_WITHIN_RELATIVE(width(670, 715), widths[1], 0.15, "powers 0.5 and 0.5641") << km;
    EXPECT_WITHIN_RELATIVE(width(740, 780), widths[2], 0.35, "the band is black at 10 km") << km;
  }
  EXPECT_EQ(oxygen_bands_per_m(nanometres(600)), 0);
  EXPECT_THROW(oxygen_bands_per_m(nanometres(781)), algebra::Error);
}

TEST(WaterVapour, TakesTheLightOfABandModelAlongTheLimb) {
  for (const auto& [km, widths] :
       {Limb<2>{2, {6.256, 25.314}}, Limb<2>{5, {2.185, 11.010}}, Limb<2>{8, {0.559, 3.249}}}) {
    const double path_m = along_limb(km * 1e3, water_vapour_profile);
    const auto width = [&](double from, double to) {
      return width_nm(from, to, path_m,
                      [](algebra::Wavelength at) { return water_vapour_per_m(1, at); });
    };
    EXPECT_WITHIN_RELATIVE(width(555, 615), widths[0], 0.15, "profile, and means over 20 nm") << km;
    EXPECT_WITHIN_RELATIVE(width(673, 765), widths[1], 0.15, "profile, and means over 20 nm") << km;
  }
  EXPECT_WITHIN_RELATIVE(water_vapour_per_m(4, nanometres(650)),
                         std::pow(4, 0.62) * water_vapour_per_m(1, nanometres(650)), 1e-12,
                         "growth with the amount");
  EXPECT_EQ(water_vapour_per_m(1, nanometres(550)), 0);
}

// Bird & Riordan (1986), J. Climate Appl. Meteor. 25, 87: another band model, with air along the ray by its pressure;
// bands 40 nm wide at the foot, as its few wavelengths have them.
TEST(OxygenBands, TakeAboutWhatAnotherBandModelSays) {
  for (const auto& [km, nm] : {std::pair{5., 8.41}, {8., 6.65}, {10., 5.44}})
    EXPECT_WITHIN_RELATIVE(
        width_nm(740, 780, along_limb(km * 1e3, density_ratio_us_1976), oxygen_bands_per_m), nm,
        0.35, "our own accuracy, where the band saturates")
        << km;
}

TEST(WaterVapour, IsThatOfTheModelAtmospheres) {
  constexpr double mid_january = 2001 + 15 / 365.25;
  EXPECT_WITHIN_RELATIVE(seasonal_water(algebra::degrees(0), 2001.4), 2.395, 1e-3, "tropics");
  EXPECT_WITHIN_RELATIVE(seasonal_water(algebra::degrees(75), mid_january), 0.308, 1e-3, "winter");
  EXPECT_WITHIN_RELATIVE(seasonal_water(algebra::degrees(-45), mid_january), 1.593, 1e-3, "summer");
}

}  // namespace coppermoon::atmosphere::gases_test
