// SPDX-License-Identifier: MIT
#include "photons/limb_darkening.h"

#include "algebra/quadrature.h"
#include "baker/atmosphere/published_table.h"
#include "support/testing.h"

namespace coppermoon::photons::limb_darkening_test {

using algebra::nanometres;

const std::vector<double> wavelengths{380, 420, 443, 500, 550, 600.5, 700, 780};

double over_centre(double nm, double mu) {
  return limb_darkening(nanometres(nm), mu) / limb_darkening(nanometres(nm), 1);
}

TEST(LimbDarkening, IsThatOfALaterPublishedTable) {
  const auto neckel = published_table("baker/photons/data/limb_darkening_neckel_2005.csv");
  const auto& nm = neckel["wavelength_nm"];
  for (std::size_t i = 0; i < nm.size(); ++i) {
    const double tolerance = nm[i] < 400 ? 0.013 : 0.01;
    for (int tenths = 1; tenths <= 9; ++tenths)
      EXPECT_WITHIN(over_centre(nm[i], tenths / 10.0), neckel["0." + std::to_string(tenths)][i],
                    tolerance, "a fit smooth in wavelength to the same observations")
          << nm[i] << " nm, " << tenths;
    EXPECT_WITHIN(1 / limb_darkening(nanometres(nm[i]), 1), neckel["mean_over_centre"][i],
                  tolerance, "the same")
        << nm[i] << " nm";
  }
}

// Neckel & Labs (1994) print at 559.95 nm these coefficients, and a mean of 0.8061 of the centre.
TEST(LimbDarkening, IsThePrintedPolynomialAtItsWavelengths) {
  EXPECT_WITHIN(1 / limb_darkening(nanometres(559.95), 1), 0.8061, 5e-5, "printed to 4 digits");
  EXPECT_WITHIN(over_centre(559.95, 0), 0.26892, 1e-7, "the printed sum is 1");
  const double half =
      0.26892 + 1.34319 / 2 - 1.58427 / 4 + 1.91271 / 8 - 1.31350 / 16 + 0.37295 / 32;
  EXPECT_WITHIN(over_centre(559.95, 0.5), half, 1e-7, "the printed sum is 1");
}

TEST(LimbDarkening, HasTheFiguresItsDocumentationStates) {
  EXPECT_WITHIN(limb_darkening(nanometres(550), 1), 1.246, 5e-4, "stated to 4 digits");
  EXPECT_WITHIN(limb_darkening(nanometres(550), 0), 0.33, 0.005, "stated to 2 digits");
}

// 2 ∫ I μ dμ over the disc.
TEST(LimbDarkening, HasTheMeanOne) {
  for (const double nm : wavelengths) {
    double sum = 0;
    for (const auto& node : algebra::gauss_legendre(8)) {
      const double mu = (1 + node.x) / 2;
      sum += node.weight * mu * limb_darkening(nanometres(nm), mu);
    }
    EXPECT_WITHIN(sum, 1.0, 1e-14, "rounding: the quadrature is exact for polynomials") << nm;
  }
}

TEST(LimbDarkening, FallsTowardsTheEdgeMoreInTheBlue) {
  for (const double nm : wavelengths)
    for (double mu = 0.05; mu <= 1; mu += 0.05)
      EXPECT_GT(over_centre(nm, mu), over_centre(nm, mu - 0.05));
  EXPECT_LT(over_centre(420, 0.4), over_centre(550, 0.4));
  EXPECT_LT(over_centre(550, 0.4), over_centre(700, 0.4));
}

TEST(LimbDarkening, RefusesArgumentsOutsideTheirRange) {
  EXPECT_THROW(limb_darkening(nanometres(379.9), 1), algebra::Error);
  EXPECT_THROW(limb_darkening(nanometres(780.1), 1), algebra::Error);
  EXPECT_THROW(limb_darkening(nanometres(550), -0.01), algebra::Error);
  EXPECT_THROW(limb_darkening(nanometres(550), 1.01), algebra::Error);
  EXPECT_THROW(limb_darkening(nanometres(550), std::numeric_limits<double>::quiet_NaN()),
               algebra::Error);
}

template <class Function>
double sum_over_layers(const DiscLayers& layers, std::size_t w, Function of_radius_squared) {
  double sum = 0;
  for (std::size_t i = 0; i < layers.radius.size(); ++i) {
    const double squared = layers.radius[i] * layers.radius[i];
    sum += layers.brightness(i, w) * of_radius_squared(squared);
  }
  return sum;
}

// ∫ ρ^2p I dA / π = 2 ∫ (1 − μ²)^p I μ dμ; a uniform disc of radius r has r^(2p + 2)/(p + 1).
TEST(DiscLayers, HaveTheMomentsOfTheDisc) {
  const auto layers = disc_layers(wavelengths, true);
  for (std::size_t w = 0; w < wavelengths.size(); ++w)
    for (int p = 0; p <= 2; ++p) {
      double disc = 0;
      for (const auto& node : algebra::gauss_legendre(12)) {
        const double mu = (1 + node.x) / 2;
        disc += node.weight * mu * std::pow(1 - mu * mu, p) *
                limb_darkening(nanometres(wavelengths[w]), mu);
      }
      const double stack = sum_over_layers(
          layers, w, [p](double squared) { return std::pow(squared, p + 1) / (p + 1); });
      EXPECT_WITHIN(stack, disc, 1e-14, "rounding: Gauss is exact for polynomials")
          << wavelengths[w] << " nm, moment " << p;
    }
}

// Light inside ρ: 2 ∫ from √(1 − ρ²) to 1 of I μ dμ.
double light_inside(double nm, double radius) {
  const double edge = std::sqrt(1 - radius * radius);
  double sum = 0;
  for (const auto& node : algebra::gauss_legendre(8)) {
    const double mu = (1 + edge) / 2 + (1 - edge) / 2 * node.x;
    sum += (1 - edge) * node.weight * mu * limb_darkening(nanometres(nm), mu);
  }
  return sum;
}

double worst_light_inside(const DiscLayers& layers, std::size_t w) {
  double worst = 0;
  for (double radius = 0; radius <= 1; radius += 0.01) {
    const double stack = sum_over_layers(
        layers, w, [&](double squared) { return std::min(squared, radius * radius); });
    worst = std::max(worst, std::abs(stack - light_inside(wavelengths[w], radius)));
  }
  return worst;
}

TEST(DiscLayers, HoldTheLightInsideAnyRadius) {
  const auto layers = disc_layers(wavelengths, true);
  for (std::size_t w = 0; w < wavelengths.size(); ++w)
    EXPECT_WITHIN(worst_light_inside(layers, w), 0.0, 3e-4, "as the header says")
        << wavelengths[w] << " nm";
}

TEST(DiscLayers, BeginWithTheWholeDiscAndShrink) {
  const auto layers = disc_layers(wavelengths, true);
  ASSERT_EQ(layers.radius.size(), 33u);
  ASSERT_EQ(layers.brightness.rows(), 33u);
  ASSERT_EQ(layers.brightness.columns(), wavelengths.size());
  EXPECT_EQ(layers.radius[0], 1);
  EXPECT_TRUE(std::is_sorted(layers.radius.rbegin(), layers.radius.rend()));
  for (std::size_t w = 0; w < wavelengths.size(); ++w)
    EXPECT_WITHIN(layers.brightness(0, w), limb_darkening(nanometres(wavelengths[w]), 0), 1e-15,
                  "rounding");
}

TEST(DiscLayers, OfAUniformDiscAreOne) {
  const auto layers = disc_layers(wavelengths, false);
  EXPECT_EQ(layers.radius, std::vector<double>{1});
  ASSERT_EQ(layers.brightness.rows(), 1u);
  ASSERT_EQ(layers.brightness.columns(), wavelengths.size());
  for (const double brightness : layers.brightness.values()) EXPECT_EQ(brightness, 1);
}

TEST(DiscLayers, RefuseWavelengthsOutsideTheirRange) {
  EXPECT_THROW(disc_layers(std::vector<double>{550, 790}, true), algebra::Error);
}

/// Largest error of the radiance over the mean, at any wavelength and angle.
double worst_of_terms(int count) {
  std::vector<double> grid;
  for (double nm = 380; nm <= 780; nm += 10) grid.push_back(nm);
  const auto terms = disc_terms(grid, true, count);
  double worst = 0;
  for (std::size_t w = 0; w < grid.size(); ++w)
    for (double mu = 0; mu <= 1; mu += 0.02) {
      double sum = 0;
      for (std::size_t k = 0; k < terms.functions.size(); ++k)
        sum += terms.brightness(k, w) * value(terms.functions[k], mu);
      worst = std::max(worst, std::abs(sum - limb_darkening(nanometres(grid[w]), mu)));
    }
  return worst;
}

TEST(DiscTerms, ReachTheAccuracyThatIsStated) {
  EXPECT_LT(worst_of_terms(2), 0.07);
  EXPECT_LT(worst_of_terms(3), 0.03);
  EXPECT_LT(worst_of_terms(4), 4e-3);
  EXPECT_LT(worst_of_terms(6), 1e-13);
}

TEST(DiscTerms, OfAUniformDiscAreOne) {
  const auto terms = disc_terms(wavelengths, false);
  ASSERT_EQ(terms.functions.size(), 1u);
  EXPECT_EQ(value(terms.functions[0], 0.3), 1);
  for (const double brightness : terms.brightness.values()) EXPECT_EQ(brightness, 1);
}

TEST(DiscTerms, KeepTheSunsLight) {
  const auto terms = disc_terms(wavelengths, true, 3);
  for (std::size_t w = 0; w < wavelengths.size(); ++w) {
    double sum = 0;
    for (const auto& node : algebra::gauss_legendre(8)) {
      const double mu = (1 + node.x) / 2;
      for (std::size_t k = 0; k < 3; ++k)
        sum += node.weight * mu * terms.brightness(k, w) * value(terms.functions[k], mu);
    }
    EXPECT_WITHIN(sum, 1, 1e-13, "rounding: what differs from the first term has no mean");
  }
}

TEST(DiscTerms, RefuseArgumentsOutsideTheirRange) {
  EXPECT_THROW(disc_terms(wavelengths, true, 0), algebra::Error);
  EXPECT_THROW(disc_terms(wavelengths, true, 7), algebra::Error);
  EXPECT_THROW(disc_terms(std::vector<double>{550, 790}, true), algebra::Error);
}

}  // namespace coppermoon::photons::limb_darkening_test
