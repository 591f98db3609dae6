// SPDX-License-Identifier: MIT
#include "uses/study/fit_nuisances.h"

#include <cmath>
#include <numeric>

namespace coppermoon::uses {
namespace {

/// Lower triangle L of a matrix that is L Lᵀ.
algebra::Grid<double> cholesky(algebra::Grid<double> l) {
  const std::size_t n = l.rows();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = l(i, j);
      for (std::size_t k = 0; k < j; ++k) sum -= l(i, k) * l(j, k);
      l(i, j) = i == j ? std::sqrt(sum) : sum / l(j, j);
    }
  return l;
}

/// L⁻¹ b.
std::vector<double> forward(const algebra::Grid<double>& l, std::vector<double> b) {
  for (std::size_t i = 0; i < b.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) b[i] -= l(i, k) * b[k];
    b[i] /= l(i, i);
  }
  return b;
}

/// L⁻ᵀ b.
std::vector<double> backward(const algebra::Grid<double>& l, std::vector<double> b) {
  for (std::size_t i = b.size(); i-- > 0;) {
    for (std::size_t k = i + 1; k < b.size(); ++k) b[i] -= l(k, i) * b[k];
    b[i] /= l(i, i);
  }
  return b;
}

/// Aᵀ x.
std::vector<double> transposed_times(const algebra::Grid<double>& a, std::span<const double> x) {
  std::vector<double> sums(a.columns());
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += a(i, k) * x[i];
  return sums;
}

}  // namespace

Nuisances::Nuisances(std::span<const double> own_errors, algebra::Grid<double> effects)
    : own_errors_(own_errors.begin(), own_errors.end()), effects_(std::move(effects)) {
  const std::size_t count = effects_.columns();
  algebra::Grid<double> m(count, count);
  for (std::size_t k = 0; k < count; ++k) m(k, k) = 1;
  for (std::size_t i = 0; i < own_errors_.size(); ++i) {
    const double weight = 1 / (own_errors_[i] * own_errors_[i]);
    for (std::size_t k = 0; k < count; ++k)
      if (const double effect = weight * effects_(i, k); effect != 0)
        for (std::size_t j = 0; j <= k; ++j) m(k, j) += effect * effects_(i, j);
  }
  factor_ = cholesky(std::move(m));
}

Nuisances::Whitened Nuisances::whitened(std::span<const double> residuals) const {
  Whitened result;
  std::vector<double> weighted(residuals.size());
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    result.own.push_back(residuals[i] / own_errors_[i]);
    weighted[i] = result.own[i] / own_errors_[i];
  }
  result.shared = forward(factor_, transposed_times(effects_, weighted));
  return result;
}

std::vector<double> Nuisances::expected(std::span<const double> residuals) const {
  return backward(factor_, whitened(residuals).shared);
}

std::vector<double> Nuisances::explained(std::span<const double> residuals) const {
  const auto found = expected(residuals);
  std::vector<double> result(residuals.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    const auto row = effects_.row(i);
    result[i] = std::inner_product(row.begin(), row.end(), found.begin(), 0.);
  }
  return result;
}

double Nuisances::error_of_mean(std::span<const double> weights) const {
  double squares = 0, sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    squares += std::pow(weights[i] * own_errors_[i], 2);
    sum += weights[i];
  }
  for (const double shared : forward(factor_, transposed_times(effects_, weights)))
    squares += shared * shared;
  return std::sqrt(squares) / sum;
}

double product(const Nuisances::Whitened& a, const Nuisances::Whitened& b) {
  return std::inner_product(a.own.begin(), a.own.end(), b.own.begin(), 0.) -
         std::inner_product(a.shared.begin(), a.shared.end(), b.shared.begin(), 0.);
}

}  // namespace coppermoon::uses
