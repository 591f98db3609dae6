// SPDX-License-Identifier: MIT
#include "uses/fit/nuisances.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include "support/testing.h"

namespace coppermoon::uses::nuisances_test {

/// Three residuals, of which the first two share an error of 0.15; two nuisance parameters.
const std::array noise_errors{0.1, 0.2, 0.05};
constexpr double shared_error = 0.15;
const std::array<std::array<double, 2>, 3> design{{{1, 0}, {1, 0.3}, {1, -0.4}}};
const std::vector<double> residuals{0.4, 0.7, -0.1};

double noise(std::size_t i, std::size_t j) {
  return (i == j ? noise_errors[i] * noise_errors[i] : 0) +
         (i < 2 && j < 2 ? shared_error * shared_error : 0);
}

/// Noise covariance of the first two residuals.
algebra::Grid<double> first_block() {
  algebra::Grid<double> block(2, 2);
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j) block(i, j) = noise(i, j);
  return block;
}

Nuisances nuisances() {
  algebra::Grid<double> a(3, 2);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 2; ++k) a(i, k) = design[i][k];
  algebra::Grid<double> last(1, 1);
  last(0, 0) = noise(2, 2);
  return {std::array{first_block(), last}, a};
}

/// Covariance C of the residuals.
glm::dmat3 covariance() {
  glm::dmat3 c(0);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      c[static_cast<int>(i)][static_cast<int>(j)] =
          design[i][0] * design[j][0] + design[i][1] * design[j][1] + noise(i, j);
  return c;
}

TEST(Nuisances, WeighResidualsByTheInverseOfTheirCovariance) {
  const auto seen = nuisances().whitened(residuals);
  const glm::dvec3 r(residuals[0], residuals[1], residuals[2]);
  EXPECT_WITHIN_RELATIVE(product(seen, seen), glm::dot(r, glm::inverse(covariance()) * r), 1e-9,
                         "the Woodbury identity, in doubles");
}

TEST(Nuisances, AreExpectedAsTheirCovarianceWithTheResidualsSays) {
  const glm::dvec3 r(residuals[0], residuals[1], residuals[2]);
  const auto weighted = glm::inverse(covariance()) * r;
  const auto expected = nuisances().expected(residuals);
  for (std::size_t k = 0; k < 2; ++k) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += design[i][k] * weighted[static_cast<int>(i)];
    EXPECT_WITHIN_RELATIVE(expected[k], sum, 1e-9, "E(u | r) = Aᵀ C⁻¹ r");
  }
}

TEST(Nuisances, ExplainWhatTheyExpect) {
  const auto expected = nuisances().expected(residuals);
  const auto explained = nuisances().explained(residuals);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_WITHIN(explained[i], design[i][0] * expected[0] + design[i][1] * expected[1], 1e-12,
                  "A u");
}

TEST(Nuisances, ExplainByOneOfThemAlone) {
  const auto expected = nuisances().expected(residuals);
  const auto explained = nuisances().explained(residuals, 1, 1);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_WITHIN(explained[i], design[i][1] * expected[1], 1e-12, "the second column of A u");
}

TEST(Nuisances, WeighResidualsOneByOne) {
  const auto weighed = nuisances().weighed(residuals);
  const auto expected =
      glm::inverse(covariance()) * glm::dvec3(residuals[0], residuals[1], residuals[2]);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_WITHIN_RELATIVE(weighed[i], expected[static_cast<int>(i)], 1e-9, "C⁻¹ r, in doubles");
}

TEST(Nuisances, LeaveTheErrorOfAMeanThatIsBetterThanTheirOwnPriorSays) {
  const std::vector<double> one{1, 0, 0};
  // a residual has its noise, and the posterior errors of both parameters, given all three
  const double error = nuisances().error_of_mean(one), itself = std::sqrt(noise(0, 0));
  EXPECT_GT(error, itself);
  EXPECT_LT(error, std::hypot(itself, 1));
}

TEST(Nuisances, AreNotChangedByAnEmptyBlock) {
  algebra::Grid<double> uniform(2, 1, 0.3);
  const Nuisances without(std::array{first_block()}, uniform),
      with(std::array{algebra::Grid<double>(), first_block(), algebra::Grid<double>()}, uniform);
  const std::vector<double> two{0.4, 0.7};
  EXPECT_EQ(with.expected(two), without.expected(two));
  EXPECT_EQ(with.error_of_mean(two), without.error_of_mean(two));
}

TEST(Nuisances, LeaveASharedErrorToAMean) {
  const Nuisances of_none(std::array{first_block()}, algebra::Grid<double>(2, 0));
  EXPECT_WITHIN_RELATIVE(of_none.error_of_mean(std::vector<double>{1, 1}),
                         std::hypot(0.1 / 2, 0.2 / 2, shared_error), 1e-12, "in doubles");
}

}  // namespace coppermoon::uses::nuisances_test
