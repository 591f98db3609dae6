// SPDX-License-Identifier: MIT
#include "colour/cie_observer.h"

#include "support/testing.h"

namespace coppermoon::colour::cie_observer_test {

std::vector<double> edges(double from, double to, double step) {
  std::vector<double> all;
  for (int i = 0; from + i * step <= to + 1e-9; ++i) all.push_back(from + i * step);
  return all;
}

/// XYZ of a spectrum given at the middle of each band.
std::array<double, 3> xyz_of(const std::vector<double>& edges_nm,
                             const std::function<double(double)>& radiance) {
  const auto weights = xyz_weights(edges_nm);
  std::array<double, 3> xyz{};
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t band = 0; band < weights.columns(); ++band)
      xyz[row] += weights(row, band) * radiance((edges_nm[band] + edges_nm[band + 1]) / 2);
  return xyz;
}

double equal_energy(double) { return 1; }

// CIE 15: 1 nm sums of the colour matching functions, 360 to 830 nm.
constexpr std::array<double, 3> published_sums{106.865469, 106.856917, 106.892251};

TEST(CieObserver, IntegralsAreThePublishedSums) {
  const auto xyz = xyz_of(edges(360, 830, 1), equal_energy);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_WITHIN(
        xyz[i] / 683, published_sums[i], 3.1e-4,
        "the trapezoid halves the end values, the larger z_bar(360) = 6.061e-4, against the sum");
}

TEST(CieObserver, SeesEqualEnergyAsWhite) {
  const auto xyz = xyz_of(edges(380, 780, 2), equal_energy);
  const double sum = xyz[0] + xyz[1] + xyz[2];
  EXPECT_WITHIN(xyz[0] / sum, 1.0 / 3, 1e-4, "the CIE's own three sums differ by 3.3e-4");
  EXPECT_WITHIN(xyz[1] / sum, 1.0 / 3, 1e-4, "the CIE's own three sums differ by 3.3e-4");
}

TEST(CieObserver, SeesIlluminantAWhereTheCiePutsIt) {
  // CIE 15: S = (560/λ)^5 (exp(1.435e7 / (2848·560)) − 1) / (exp(1.435e7 / (2848 λ)) − 1), which
  // has x = 0.44758, y = 0.40745.
  const char* reason =
      "printed to 5 digits, of sums every 5 nm, 380 to 780 nm: 7e-6 from finer ones";
  const auto xyz = xyz_of(edges(360, 830, 1), [](double nm) {
    return std::pow(560 / nm, 5) / std::expm1(1.435e7 / (2848 * nm));
  });
  const double sum = xyz[0] + xyz[1] + xyz[2];
  EXPECT_WITHIN(xyz[0] / sum, 0.44758, 1.2e-5, reason);
  EXPECT_WITHIN(xyz[1] / sum, 0.40745, 1.2e-5, reason);
}

TEST(CieObserver, GivesGreenLight683LumensPerWatt) {
  const auto weights = xyz_weights(std::array{554.5, 555.5});
  EXPECT_WITHIN_RELATIVE(weights(1, 0), 683.0, 5e-5,
                         "mean over 1 nm about a peak that is flat to 6e-5 in 1 nm");
}

TEST(CieObserver, BandsOfAnyWidthAddUpToTheSame) {
  const auto fine = xyz_of(edges(380, 780, 1), equal_energy);
  const auto coarse = xyz_of({380, 431.7, 500.25, 612, 780}, equal_energy);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_WITHIN_RELATIVE(coarse[i], fine[i], 1e-12, "the same integral, summed in another order");
}

TEST(CieObserver, IsBlindOutsideItsTable) {
  const auto weights = xyz_weights(std::array{200.0, 360.0, 830.0, 2000.0});
  for (std::size_t row = 0; row < 3; ++row) {
    EXPECT_EQ(weights(row, 0), 0);
    EXPECT_GT(weights(row, 1), 0);
    EXPECT_EQ(weights(row, 2), 0);
  }
}

TEST(CieObserver, RefusesEdgesThatAreNoBands) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(xyz_weights(std::array{550.0}), algebra::Error);
  EXPECT_THROW(xyz_weights(std::array{550.0, 550.0}), algebra::Error);
  EXPECT_THROW(xyz_weights(std::array{550.0, 540.0}), algebra::Error);
  EXPECT_THROW(xyz_weights(std::array{550.0, infinity}), algebra::Error);
  EXPECT_THROW(xyz_weights(std::array{std::nan(""), 550.0}), algebra::Error);
}

}  // namespace coppermoon::colour::cie_observer_test
