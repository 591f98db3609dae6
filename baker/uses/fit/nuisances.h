// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "algebra/grid.h"

namespace coppermoon::uses {

/// Nuisance parameters of a linear model, marginalised. Residuals r depend on parameters u (an exposure, a
/// colour, a number of a tone curve) by a design matrix A, beside noise e of covariance D:
///
///     r = A u + e        u ~ N(0, 1), e ~ N(0, D)        C = D + A Aᵀ = G Gᵀ
///
/// D is block-diagonal: noise is correlated within a block.
class Nuisances {
 public:
  Nuisances() = default;
  /// Given  noise   blocks of D, in the order of the residuals, each positive definite or empty
  ///        design  A: (residual, parameter)
  Nuisances(std::span<const algebra::Grid<double>> noise, algebra::Grid<double> design);

  /// Replaces columns of residuals r by G⁻¹ r: rᵀ C⁻¹ s is the product of two whitened columns.
  ///
  /// Given  columns  (residual, column)
  void whiten(algebra::Grid<double>& columns) const;

  /// Residuals of covariance C: G z.
  ///
  /// Given  normal  z, independent, of mean 0 and variance 1
  std::vector<double> drawn(std::span<const double> normal) const;

  /// ln |C|.
  double log_determinant() const;

  /// Posterior mean of the parameters: Aᵀ C⁻¹ r.
  std::vector<double> expected(std::span<const double> residuals) const;

  /// Part of the residuals that the posterior mean u of the parameters explains: A u.
  std::vector<double> explained(std::span<const double> residuals) const;

  /// Part of the residuals that `count` parameters from the first on explain.
  std::vector<double> explained(std::span<const double> residuals, std::size_t first,
                                std::size_t count) const;

  /// C⁻¹ r.
  std::vector<double> weighed(std::span<const double> residuals) const;

  /// Standard error of a weighted mean, by the noise and the posterior covariance of the parameters.
  double error_of_mean(std::span<const double> weights) const;

 private:
  std::vector<algebra::Grid<double>> noise_;  // blocks of D
  algebra::Grid<double> design_;              // A
  algebra::Grid<double> factor_;              // G, lower triangle
};

}  // namespace coppermoon::uses
