// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "algebra/grid.h"

namespace coppermoon::uses {

/// Marginalised nuisance parameters of a linear model. Residuals r depend on parameters u (an exposure, a
/// colour, a number of a tone curve) through a design matrix A, with noise e of covariance D:
///
///     r = A u + e        u ~ N(0, 1), e ~ N(0, D)        C = D + A Aᵀ
///
/// D is block-diagonal: noise is correlated within a block. By the Woodbury identity C is never formed:
///
///     C⁻¹ = D⁻¹ − D⁻¹ A M⁻¹ Aᵀ D⁻¹        M = 1 + Aᵀ D⁻¹ A
class Nuisances {
 public:
  Nuisances() = default;
  /// Given  noise   blocks of D, in the order of the residuals, each positive definite or empty
  ///        design  A: (residual, parameter); without columns, one parameter with no effect is used
  Nuisances(std::span<const algebra::Grid<double>> noise, algebra::Grid<double> design);

  /// Whitened residuals and parameters: with D = K Kᵀ and M = L Lᵀ, `noise` is K⁻¹ r and `parameters` is
  /// L⁻¹ Aᵀ D⁻¹ r.
  struct Whitened {
    std::vector<double> noise, parameters;
  };
  Whitened whitened(std::span<const double> residuals) const;

  /// Posterior mean of the parameters: M⁻¹ Aᵀ D⁻¹ r.
  std::vector<double> expected(std::span<const double> residuals) const;

  /// Part of the residuals that the posterior mean u of the parameters explains: A u.
  std::vector<double> explained(std::span<const double> residuals) const;

  /// Part of the residuals that `count` parameters explain, starting with number `first`.
  std::vector<double> explained(std::span<const double> residuals, std::size_t first,
                                std::size_t count) const;

  /// C⁻¹ r.
  std::vector<double> weighed(std::span<const double> residuals) const;

  /// Standard error of a weighted mean, from the noise and the posterior covariance of the parameters.
  double error_of_mean(std::span<const double> weights) const;

 private:
  std::vector<algebra::Grid<double>> noise_;  // blocks of K, lower triangles
  algebra::Grid<double> design_;              // A
  algebra::Grid<double> whitened_design_;     // K⁻¹ A
  algebra::Grid<double> factor_;              // L, lower triangle
};

/// aᵀ C⁻¹ b.
double product(const Nuisances::Whitened& a, const Nuisances::Whitened& b);

}  // namespace coppermoon::uses
