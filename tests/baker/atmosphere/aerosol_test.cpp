// SPDX-License-Identifier: MIT
#include "atmosphere/aerosol.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "algebra/error.h"
#include "baker/atmosphere/published_table.h"
#include "support/within.h"

namespace coppermoon::atmosphere {
namespace {

using algebra::nanometres;
using enum StratosphericAerosol;

const auto lowtran = published_table("baker/atmosphere/data/stratospheric_aerosol_lowtran7.csv");

struct Published {
  StratosphericAerosol aerosol;
  std::string name;
  double depth;
};

// Vertical optical depths from 11 to 70 km, means of the two seasons.
const std::vector<Published> published{{background, "background", 0.0072},
                                       {moderate, "moderate", 0.02685},
                                       {high, "high", 0.08425},
                                       {extreme, "extreme", 0.2567}};

double depth(StratosphericAerosol aerosol, double from_m, double to_m) {
  constexpr double step_m = 5;
  double sum = 0;
  for (double h = from_m + step_m / 2; h < to_m; h += step_m)
    sum += step_m * stratospheric_extinction_per_m(aerosol, h);
  return sum;
}

// Between two rows the logarithm is straight: ∫ = Δh (a − b)/ln(a/b).
double printed_depth(const std::string& column) {
  const auto &km = lowtran["altitude_km"], &a = lowtran[column];
  double sum = 0;
  for (std::size_t i = 0; i + 1 < km.size() && km[i] < 70; ++i) {
    const double ratio = a[i] / a[i + 1];
    sum += (km[i + 1] - km[i]) * (ratio == 1 ? a[i] : (a[i] - a[i + 1]) / std::log(ratio));
  }
  return sum;
}

TEST(StratosphericExtinction, IsTheMeanOfBothSeasonsAtEveryPrintedAltitude) {
  for (const auto& [aerosol, name, unused] : published)
    for (std::size_t i = 0; i < lowtran["altitude_km"].size(); ++i) {
      const double mean = (lowtran[name + "_s"][i] + lowtran[name + "_w"][i]) / 2 * 1e-3;
      const double km = lowtran["altitude_km"][i];
      EXPECT_WITHIN_RELATIVE(stratospheric_extinction_per_m(aerosol, km * 1e3), mean, 1e-6,
                             "tabulated to 7 digits")
          << name << ", " << km << " km";
    }
}

TEST(StratosphericExtinction, HasTheOpticalDepthsOfThePrintedProfiles) {
  for (const auto& [aerosol, name, stated] : published) {
    const double printed = (printed_depth(name + "_s") + printed_depth(name + "_w")) / 2;
    const double reached = depth(aerosol, 11e3, 70e3);
    EXPECT_WITHIN_RELATIVE(printed, stated, 0.004, "stated to 2, or to 4 digits") << name;
    EXPECT_WITHIN_RELATIVE(reached, printed, 0.015, "smooth, where two sharp peaks are added")
        << name;
  }
}

TEST(StratosphericExtinction, HasTheOpticalDepthsItsDocumentationStates) {
  EXPECT_WITHIN(depth(background, 11e3, 70e3), 0.0072, 5e-5, "stated to two digits");
  EXPECT_WITHIN(depth(moderate, 11e3, 70e3), 0.0269, 5e-5, "stated to three digits");
  EXPECT_WITHIN(depth(high, 11e3, 70e3), 0.0844, 5e-5, "stated to three digits");
  EXPECT_WITHIN(depth(extreme, 11e3, 70e3), 0.260, 5e-4, "stated to three digits");
  EXPECT_WITHIN(depth(background, 9e3, 100e3), 0.008, 5e-4, "stated to one digit");
  EXPECT_WITHIN(depth(moderate, 9e3, 100e3), 0.028, 5e-4, "stated to two digits");
  EXPECT_WITHIN(depth(high, 9e3, 100e3), 0.086, 5e-4, "stated to two digits");
  EXPECT_WITHIN(depth(extreme, 9e3, 100e3), 0.262, 5e-4, "stated to three digits");
}

TEST(StratosphericExtinction, FadesOutWhereTheTroposphereBegins) {
  for (const auto& row : published) {
    EXPECT_EQ(stratospheric_extinction_per_m(row.aerosol, 8.9e3), 0);
    EXPECT_EQ(stratospheric_extinction_per_m(row.aerosol, 9e3), 0);
    EXPECT_WITHIN_RELATIVE(stratospheric_extinction_per_m(row.aerosol, 10e3), 9.635e-7 / 2, 1e-9,
                           "half of the printed 9.635e-7, rounding");
    EXPECT_LT(stratospheric_extinction_per_m(row.aerosol, 9.01e3), 2e-10);
    EXPECT_EQ(stratospheric_extinction_per_m(row.aerosol, 100.1e3), 0);
  }
}

double slope(StratosphericAerosol aerosol, double altitude_m) {
  return (stratospheric_extinction_per_m(aerosol, altitude_m + 0.01) -
          stratospheric_extinction_per_m(aerosol, altitude_m - 0.01)) /
         0.02;
}

TEST(StratosphericExtinction, HasASlopeWithoutJumps) {
  for (const auto& row : published)
    for (double h = 9e3; h < 60e3; h += 500)
      EXPECT_WITHIN(slope(row.aerosol, h + 0.02), slope(row.aerosol, h - 0.02), 2e-11,
                    "1/1000 of the steepest slope, 3e-8 per metre; a kink would be of its order")
          << row.name << ", " << h << " m";
}

TEST(StratosphericExtinction, IsNothingWithoutAerosol) {
  for (double h = 0; h < 100e3; h += 777) EXPECT_EQ(stratospheric_extinction_per_m(none, h), 0);
}

// What the figures of LOWTRAN 7 give between 337.1 and 694.3 nm as Ångström exponents.
TEST(StratosphericSpectrum, HasTheSlopesOfThePrintedFigures) {
  const auto exponent = [](StratosphericAerosol aerosol, double from_nm, double to_nm) {
    return -std::log(stratospheric_spectrum(aerosol, nanometres(to_nm)) /
                     stratospheric_spectrum(aerosol, nanometres(from_nm))) /
           std::log(to_nm / from_nm);
  };
  EXPECT_WITHIN(exponent(background, 380, 550), 1.113, 5e-4, "ln 1.7246 / ln(550/337.1)");
  EXPECT_WITHIN(exponent(background, 550, 690), 1.521, 5e-4, "−ln 0.70156 / ln(694.3/550)");
  EXPECT_WITHIN(exponent(moderate, 380, 550), 0.338, 5e-4, "ln 1.18013 / ln(550/337.1)");
  EXPECT_WITHIN(exponent(high, 700, 780), 1.112, 5e-4, "ln(0.84873/0.53019) / ln(1060/694.3)");
  EXPECT_WITHIN(exponent(extreme, 550, 690), -0.127, 5e-4, "−ln 1.03013 / ln(694.3/550)");
}

TEST(StratosphericSpectrum, IsOneAt550NanometresAndThePrintedFigureAtItsNode) {
  for (const auto& row : published)
    EXPECT_WITHIN(stratospheric_spectrum(row.aerosol, nanometres(550)), 1.0, 1e-14, "rounding");
  EXPECT_EQ(stratospheric_spectrum(none, nanometres(400)), 1);
  const auto at_node = [](auto aerosol) {
    return stratospheric_spectrum(aerosol, nanometres(694.3));
  };
  EXPECT_WITHIN(at_node(background), 0.70156, 1e-12, "rounding");
  EXPECT_WITHIN(at_node(moderate), 0.84873, 1e-12, "rounding");
  EXPECT_WITHIN(at_node(high), 0.84873, 1e-12, "rounding");
  EXPECT_WITHIN(at_node(extreme), 1.03013, 1e-12, "rounding");
}

TEST(StratosphericSpectrum, RefusesWavelengthsOutsideItsRange) {
  EXPECT_THROW(stratospheric_spectrum(background, nanometres(379.99)), algebra::Error);
  EXPECT_THROW(stratospheric_spectrum(none, nanometres(780.01)), algebra::Error);
}

TEST(TroposphericProfile, IsAShareOfTheColumn) {
  double sum = 0;
  for (double h = 0.5; h < 100e3; h += 1) sum += tropospheric_profile_per_m(2e3, h);
  EXPECT_WITHIN(sum, 1.0, 1e-7, "midpoints of 1 m in a scale height of 2000 m: 1/24 of (1/2000)²");
}

// 23 km of visibility at 3 and 10 km: 0.0346 and 0.00114 per km in spring and summer, 0.0272 and
// 0.000787 in fall and winter.
TEST(TroposphericProfile, FallsAsThatOfLowtranDoes) {
  const double fall = tropospheric_profile_per_m(2e3, 3e3) / tropospheric_profile_per_m(2e3, 10e3);
  EXPECT_GT(fall, 0.0346 / 0.00114);
  EXPECT_LT(fall, 0.0272 / 0.000787);
}

// IPCC AR6 and GISS, as published: the months of the eruptions of 1258 (Samalas) and 1991 (Pinatubo), and
// of the quiet year 2003; 1912 (Katmai) stayed in the north.
TEST(StratosphericHistory, HasTheMonthsThatArePublished) {
  const auto at = [](double year, double latitude) {
    return stratospheric_optical_depth(year, algebra::degrees(latitude));
  };
  EXPECT_WITHIN_RELATIVE(at(1258.375, 0), 0.4953, 0.031, "points left out lie on the line to 3 %");
  EXPECT_WITHIN_RELATIVE((at(1992.04, 90) + at(1992.04, -90)) / 2, 0.12, 0.15,
                         "early 1992, published to 0.11 to 0.13");
  EXPECT_WITHIN_RELATIVE(at(2003.37, 0), 0.0049, 0.1, "mean of the year, months differ by 10 %");
  EXPECT_GT(at(1912.8, 50), 5 * at(1912.8, -50));
  EXPECT_EQ(at(2150, 0), 0.0067);
  EXPECT_EQ(at(-3000, 0), 0.00292);
  EXPECT_THROW(at(2000, 91), algebra::Error);
}

TEST(StratosphericLayer, HasItsOpticalDepthAboveTheTropopause) {
  for (const double depth : {0.003, 0.0072, 0.02, 0.1, 0.5})
    for (const double tropopause : {9e3, 16.4e3}) {
      const StratosphericLayer layer(depth, tropopause);
      double sum = 0, above = 0;
      for (double h = 5; h < 86e3; h += 10) {
        sum += 10 * layer.extinction_per_m(h);
        if (h > tropopause - 3e3) above += 10 * layer.extinction_per_m(h);
      }
      EXPECT_WITHIN_RELATIVE(sum, depth, 2e-3, "summed in steps of 250 m, here of 10 m") << depth;
      EXPECT_WITHIN_RELATIVE(above, sum, 1e-12, "it fades out within 3 km under the tropopause");
    }
  EXPECT_EQ(StratosphericLayer(0, 11e3).extinction_per_m(20e3), 0);
  EXPECT_THROW(StratosphericLayer(3, 11e3), algebra::Error);
}

// LOWTRAN's own optical depths and tropopause give its own profiles.
TEST(StratosphericLayer, IsLowtransWhereThatIsPrinted) {
  const StratosphericLayer high(0.0843, 11e3);
  for (const double h : {12e3, 17e3, 21e3, 30e3, 45e3})
    EXPECT_WITHIN_RELATIVE(high.extinction_per_m(h),
                           stratospheric_extinction_per_m(StratosphericAerosol::high, h), 0.03,
                           "2 % of it lies below 11 km")
        << h;
  EXPECT_EQ(high.nearest(), StratosphericAerosol::high);
  EXPECT_WITHIN(high.spectrum(nanometres(400)),
                stratospheric_spectrum(StratosphericAerosol::high, nanometres(400)), 1e-12,
                "rounding");
}

// Kent et al. (1998): 1e-4 and 7e-4 per km at 1.02 µm; 2.2 times that is 550 nm by Ångström's 1.3:
// (1020/550)^1.3 = 2.23.
TEST(FreeTroposphere, HasWhatSageSaw) {
  EXPECT_WITHIN_RELATIVE(free_troposphere_per_m(algebra::degrees(-70)), 2.23e-7, 0.02,
                         "2.2 for 2.23");
  EXPECT_WITHIN_RELATIVE(free_troposphere_per_m(algebra::degrees(70)), 7 * 2.23e-7, 0.02,
                         "2.2 for 2.23");
  EXPECT_EQ(free_troposphere_profile(11e3, 7e3), 1);
  EXPECT_EQ(free_troposphere_profile(11e3, 13e3), 0);
}

// 1.3 ln 2 = 0.90109, so 780 nm scatters 2^−1.3 of 390 nm.
TEST(TroposphericSpectrum, FollowsAngstromsLaw) {
  EXPECT_EQ(tropospheric_spectrum(nanometres(550)), 1);
  EXPECT_WITHIN(tropospheric_spectrum(nanometres(780)) / tropospheric_spectrum(nanometres(390)),
                std::exp(-0.9010913), 1e-7, "the exponent is rounded to 7 digits");
  EXPECT_THROW(tropospheric_spectrum(nanometres(379.99)), algebra::Error);
}

}  // namespace
}  // namespace coppermoon::atmosphere
