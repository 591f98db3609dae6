// SPDX-License-Identifier: MIT
#include "atmosphere/stratosphere.h"

#include "baker/atmosphere/published_table.h"
#include "support/testing.h"

namespace coppermoon::atmosphere::stratosphere_test {

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

// IPCC AR6 and GISS, as published: the months of the eruptions of 1258 (Samalas) and 1991 (Pinatubo), and
// of the quiet year 2003; 1912 (Katmai) stayed in the north.
TEST(StratosphericHistory, HasTheMonthsThatArePublished) {
  const auto at = [](double year, double latitude) {
    return stratospheric_optical_depth(year, algebra::degrees(latitude));
  };
  EXPECT_WITHIN_RELATIVE(at(1258.375, 0), 0.4953, 0.031, "points left out lie on the line to 3 %");
  double mean = 0;  // over parts of equal area
  for (const double sine : {-0.75, -0.25, 0.25, 0.75})
    mean += at(1992.04, algebra::in_degrees(algebra::radians(std::asin(sine)))) / 4;
  EXPECT_WITHIN_RELATIVE(mean, 0.1094, 0.06, "GloSSAC's January; bands of 30° by straight lines");
  EXPECT_GT(at(1912.8, 50), 5 * at(1912.8, -50));
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

const auto bands = published_table("baker/atmosphere/data/stratospheric_bands_checks.csv");
constexpr std::array<double, 6> middles{-75, -45, -15, 15, 45, 75};
const std::array<std::string, 6> names{"90S-60S", "60S-30S", "30S-0",
                                       "0-30N",   "30N-60N", "60N-90N"};

double depth_of_band(std::size_t row, std::size_t band) {
  return stratospheric_optical_depth(bands["year"][row], algebra::degrees(middles[band]));
}

// GloSSAC's bands at 1020 nm, as bright at 550 nm as its global mean of the month.
TEST(StratosphericBands, AreThoseOfGlossacWhereTheyAreMeasured) {
  for (std::size_t row = 0; row < bands["year"].size(); ++row)
    for (std::size_t band = 0; band < names.size(); ++band)
      if (bands["year"][row] < 2017) {
        EXPECT_WITHIN_RELATIVE(depth_of_band(row, band), bands[names[band]][row], 0.03,
                               "GloSSAC's global mean is rounded to 1e-4, 2 % of it")
            << bands["year"][row] << " " << names[band];
      }
}

// The same model run by another hand, whose background has no season; Hunga's bands are judgement.
TEST(StratosphericBands, AreNearAnotherRunOfTheModelFromThenOn) {
  double squares = 0, count = 0;
  for (std::size_t row = 0; row < bands["year"].size(); ++row)
    for (std::size_t band = 0; band < names.size(); ++band)
      if (bands["year"][row] > 2017) {
        const double ratio = std::log(depth_of_band(row, band) / bands[names[band]][row]);
        EXPECT_WITHIN(ratio, 0, 0.35, "30 % is what either claims of a band");
        squares += ratio * ratio;
        ++count;
      }
  EXPECT_WITHIN(std::sqrt(squares / count), 0, 0.15,
                "20 % of a band, less of two alike; 0.12 measured");
}

TEST(StratosphericBands, HaveTheGlobalMeanOfTheMonth) {
  for (std::size_t row = 0; row < bands["year"].size(); ++row) {
    double mean = 0;
    constexpr std::array<double, 6> areas{0.067, 0.183, 0.25, 0.25, 0.183, 0.067};
    for (std::size_t band = 0; band < names.size(); ++band)
      mean += areas[band] * depth_of_band(row, band);
    EXPECT_WITHIN_RELATIVE(mean, bands["global"][row], 0.03,
                           "rounded to 1e-4; 80° to the poles left out")
        << bands["year"][row];
  }
}

// Of Hunga: 35° S to 20° N until June 2022, between 22 and 28 km, particles of 0.4 µm.
TEST(StratosphericBands, HaveHungaWhereItWasSeen) {
  const auto layer = StratosphericLayer::of_month(2022.37, algebra::degrees(-15), 16e3);
  double high = 0;
  for (double h = 20.5e3; h < 29e3; h += 10) high += 10 * layer.extinction_per_m(h);
  EXPECT_GT(high, 0.6 * layer.optical_depth());
  EXPECT_GT(
      layer.optical_depth(),
      2.5 * StratosphericLayer::of_month(2022.37, algebra::degrees(45), 11e3).optical_depth());
  EXPECT_WITHIN(layer.spectrum(nanometres(694.3)), 1, 0.15,
                "nearly grey from 550 to 750 nm; a fifth of it is of quiet years, with 0.73");
  EXPECT_WITHIN(StratosphericLayer::of_month(2021.37, algebra::degrees(-15), 16e3)
                    .spectrum(nanometres(694.3)),
                0.73, 0.03, "LOWTRAN's background has 0.70, its aged volcanic aerosol 0.85");
}

TEST(StratosphericBands, HaveAMonthsLayerAboveTheTropopause) {
  for (const double year : {1979.5, 1992.1, 2003.2, 2022.4, 2040.})
    for (const double latitude : {-90., -40., 0., 29., 60.})
      for (const double tropopause : {8e3, 12e3, 17e3}) {
        const auto layer =
            StratosphericLayer::of_month(year, algebra::degrees(latitude), tropopause);
        double sum = 0, below = 0;
        for (double h = 5; h < 86e3; h += 10) {
          const double extinction = layer.extinction_per_m(h);
          EXPECT_GE(extinction, 0);
          sum += 10 * extinction;
          if (h < tropopause - 2e3) below += 10 * extinction;
        }
        EXPECT_WITHIN_RELATIVE(sum, layer.optical_depth(), 2e-3,
                               "summed in steps of 250 m, here of 10 m")
            << year << " " << latitude << " " << tropopause;
        EXPECT_EQ(layer.optical_depth(),
                  stratospheric_optical_depth(year, algebra::degrees(latitude)));
        EXPECT_WITHIN(below, 0, 1e-3 * sum,
                      "it fades out within 2 km under the tropopause; splines");
      }
}

TEST(StratosphericBands, KeepTheirProfileAtAnotherOpticalDepth) {
  const auto layer = StratosphericLayer::of_month(2018.5, algebra::degrees(50), 11e3),
             twice = layer.with_optical_depth(2 * layer.optical_depth());
  for (const double h : {12e3, 17e3, 25e3})
    EXPECT_WITHIN_RELATIVE(twice.extinction_per_m(h), 2 * layer.extinction_per_m(h), 1e-12,
                           "rounding");
  EXPECT_GT(twice.spectrum(nanometres(700)), layer.spectrum(nanometres(700)));
  EXPECT_EQ(layer.with_optical_depth(0).extinction_per_m(20e3), 0);
  EXPECT_THROW(layer.with_optical_depth(3), algebra::Error);
}

// GloSSAC's two wavelengths: particles of Pinatubo were large, those of a quiet year are small.
TEST(StratosphericExponent, FallsAfterGreatEruptions) {
  EXPECT_WITHIN(stratospheric_exponent(2007.5, algebra::degrees(0)), 1.7, 0.3,
                "a quiet year, as it is claimed");
  EXPECT_LT(stratospheric_exponent(1992.5, algebra::degrees(0)), 0.5);
  EXPECT_THROW(stratospheric_exponent(1970, algebra::degrees(0)), algebra::Error);
}

TEST(StratosphericDepthError, IsThatOfItsEra) {
  EXPECT_WITHIN_RELATIVE(stratospheric_depth_error(2015.74), 0.1 * 0.0097, 0.04,
                         "global mean, rounded to 1e-4");
  EXPECT_WITHIN_RELATIVE(stratospheric_depth_error(2022.375), 0.25 * 0.0154, 0.04,
                         "global mean, rounded to 1e-4");
  EXPECT_WITHIN_RELATIVE(stratospheric_depth_error(1258.375), 0.4 * 0.4953, 0.031,
                         "points left out lie on the line to 3 %");
  EXPECT_EQ(stratospheric_depth_error(2050), 0.003);
}

}  // namespace coppermoon::atmosphere::stratosphere_test
