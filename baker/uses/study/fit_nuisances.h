// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "algebra/grid.h"

namespace coppermoon::uses {

/// What else than the light sought made numbers what they are: each of some nuisances (an exposure, a
/// colour, a number of a tone curve) is 0 ± 1 and counts in each number as much as a matrix says, beside
/// the numbers' own errors.
///
///     r = A u + e        u ~ N(0, 1), e ~ N(0, D)        C = D + A Aᵀ
///
/// They are marginalised: C is never made, but D⁻¹ − D⁻¹ A M⁻¹ Aᵀ D⁻¹ with M = 1 + Aᵀ D⁻¹ A. Own errors of
/// numbers that stand side by side may go together: D is of blocks.
class Nuisances {
 public:
  Nuisances() = default;
  /// Given  own      blocks of D, in the order of the numbers, each positive definite
  ///        effects  (number, nuisance): A
  Nuisances(std::span<const algebra::Grid<double>> own, algebra::Grid<double> effects);

  /// Residuals with D⁻¹ and M⁻¹ applied by halves: products of two of them are those with C⁻¹.
  struct Whitened {
    std::vector<double> own, shared;
  };
  Whitened whitened(std::span<const double> residuals) const;

  /// The nuisances' expectations with these residuals.
  std::vector<double> expected(std::span<const double> residuals) const;

  /// What of the residuals the nuisances' expectations explain.
  std::vector<double> explained(std::span<const double> residuals) const;

  /// Standard error of a weighted mean of the numbers: their own, and of what the nuisances add.
  double error_of_mean(std::span<const double> weights) const;

 private:
  /// K⁻¹ x.
  std::vector<double> independent(std::span<const double> numbers) const;

  std::vector<algebra::Grid<double>> own_;  // blocks of K, lower triangular: D = K Kᵀ
  algebra::Grid<double> effects_;           // A
  algebra::Grid<double> independent_;       // K⁻¹ A
  algebra::Grid<double> factor_;            // of M = L Lᵀ
};

/// aᵀ C⁻¹ b.
double product(const Nuisances::Whitened& a, const Nuisances::Whitened& b);

}  // namespace coppermoon::uses
