// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "algebra/grid.h"

namespace coppermoon::uses {

/// Linear model whose nuisance parameters are marginalised. Residuals r depend on parameters u (such as the error of an
/// exposure, a colour, or a tone curve) through a design matrix A. The noise e of the residuals has covariance D:
///
///     r = A u + e        u ~ N(0, 1), e ~ N(0, D)        C = D + A Aᵀ
///
/// D is block-diagonal, so noise is correlated only within a block. C is not computed itself, because its inverse
/// follows from the Woodbury identity:
///
///     C⁻¹ = D⁻¹ − D⁻¹ A M⁻¹ Aᵀ D⁻¹        M = 1 + Aᵀ D⁻¹ A
class Nuisances {
 public:
  Nuisances() = default;
  /// Given  noise   blocks of D, in the order of the residuals, each positive definite or empty
  ///        design  A: (residual, parameter); if it has no columns, one parameter without effect is added
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

  /// Part of the residuals that `count` of the parameters explain, starting with parameter `first`.
  std::vector<double> explained(std::span<const double> residuals, std::size_t first,
                                std::size_t count) const;

  /// Residuals multiplied by the inverse covariance: C⁻¹ r.
  std::vector<double> weighed(std::span<const double> residuals) const;

  /// Standard error of a weighted mean of the residuals, due to noise and the posterior covariance of the parameters.
  double error_of_mean(std::span<const double> weights) const;

 private:
  std::vector<algebra::Grid<double>> noise_;  // blocks of K, the Cholesky factor of D
  algebra::Grid<double> design_;              // the design matrix A
  algebra::Grid<double> whitened_design_;     // the whitened design matrix K⁻¹ A
  algebra::Grid<double> factor_;              // the Cholesky factor L of M
};

/// Product aᵀ C⁻¹ b of two vectors of residuals, which are given in whitened form.
double product(const Nuisances::Whitened& a, const Nuisances::Whitened& b);

}  // namespace coppermoon::uses
