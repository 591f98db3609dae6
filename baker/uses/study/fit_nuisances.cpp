// SPDX-License-Identifier: MIT
#include "uses/study/fit_nuisances.h"

#include <algorithm>
#include <cmath>
#include <iterator>
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
      if (i != j) l(j, i) = 0;
    }
  return l;
}

/// L⁻¹ b.
void solve_forward(const algebra::Grid<double>& l, std::span<double> b) {
  for (std::size_t i = 0; i < b.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) b[i] -= l(i, k) * b[k];
    b[i] /= l(i, i);
  }
}

std::vector<double> forward(const algebra::Grid<double>& l, std::vector<double> b) {
  solve_forward(l, b);
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

Nuisances::Nuisances(std::span<const algebra::Grid<double>> own, algebra::Grid<double> effects)
    : effects_(std::move(effects)), independent_(effects_.rows(), effects_.columns()) {
  std::ranges::transform(own, std::back_inserter(own_), cholesky);
  const std::size_t numbers = effects_.rows(), count = effects_.columns();
  std::vector<double> column(numbers);
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t i = 0; i < numbers; ++i) column[i] = effects_(i, k);
    column = independent(column);
    for (std::size_t i = 0; i < numbers; ++i) independent_(i, k) = column[i];
  }
  algebra::Grid<double> m(count, count);
  for (std::size_t k = 0; k < count; ++k) m(k, k) = 1;
  for (std::size_t i = 0; i < numbers; ++i)
    for (std::size_t k = 0; k < count; ++k)
      if (const double effect = independent_(i, k); effect != 0)
        for (std::size_t j = 0; j <= k; ++j) m(k, j) += effect * independent_(i, j);
  factor_ = cholesky(std::move(m));
}

std::vector<double> Nuisances::independent(std::span<const double> numbers) const {
  std::vector<double> result(numbers.begin(), numbers.end());
  auto from = result.begin();
  for (const auto& block : own_) {
    const auto to = from + static_cast<std::ptrdiff_t>(block.rows());
    solve_forward(block, {from, to});
    from = to;
  }
  return result;
}

Nuisances::Whitened Nuisances::whitened(std::span<const double> residuals) const {
  Whitened result{independent(residuals), {}};
  result.shared = forward(factor_, transposed_times(independent_, result.own));
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
  double squares = 0;
  std::size_t first = 0;
  for (const auto& block : own_) {
    for (const double own : transposed_times(block, weights.subspan(first, block.rows())))
      squares += own * own;
    first += block.rows();
  }
  for (const double shared : forward(factor_, transposed_times(effects_, weights)))
    squares += shared * shared;
  return std::sqrt(squares) / std::reduce(weights.begin(), weights.end());
}

double product(const Nuisances::Whitened& a, const Nuisances::Whitened& b) {
  return std::inner_product(a.own.begin(), a.own.end(), b.own.begin(), 0.) -
         std::inner_product(a.shared.begin(), a.shared.end(), b.shared.begin(), 0.);
}

}  // namespace coppermoon::uses
