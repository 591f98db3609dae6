// SPDX-License-Identifier: MIT
#include "uses/fit/nuisances.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace coppermoon::uses {
namespace {

using algebra::Grid;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

template <class Values>
auto vector(Values& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), std::ssize(values));
}

Eigen::Map<const Matrix> matrix(const Grid<double>& grid) {
  return {grid.values().data(), static_cast<Eigen::Index>(grid.rows()),
          static_cast<Eigen::Index>(grid.columns())};
}

auto lower(const Grid<double>& grid) { return matrix(grid).triangularView<Eigen::Lower>(); }

/// Cholesky factor L of a matrix L Lᵀ, in the lower triangle of the result. The rest of the result has no meaning.
Grid<double> cholesky(Grid<double> grid) {
  Eigen::Map<Matrix> whole(grid.values().data(), matrix(grid).rows(), matrix(grid).cols());
  const Eigen::LLT<Eigen::Ref<Matrix>> in_place(whole);
  return grid;
}

/// Multiplies each column by K⁻¹, where K is the Cholesky factor whose diagonal blocks are `noise`.
template <class Columns>
void whiten(std::span<const Grid<double>> noise, Columns columns) {
  Eigen::Index from = 0;
  for (const auto& block : noise) {
    const auto size = matrix(block).rows();
    lower(block).solveInPlace(columns.middleRows(from, size));
    from += size;
  }
}

}  // namespace

Nuisances::Nuisances(std::span<const Grid<double>> noise, Grid<double> design)
    : design_(design.columns() > 0 ? std::move(design) : Grid<double>(design.rows(), 1)),
      whitened_design_(design_) {
  for (const auto& block : noise)
    if (!block.empty()) noise_.push_back(cholesky(block));
  const auto a = matrix(design_);
  Eigen::Map<Matrix> whitened(whitened_design_.values().data(), a.rows(), a.cols());
  whiten(noise_, whitened);
  factor_ = Grid<double>(design_.columns(), design_.columns());
  Eigen::Map<Matrix>(factor_.values().data(), a.cols(), a.cols()) =
      Matrix::Identity(a.cols(), a.cols()) + whitened.transpose() * whitened;
  factor_ = cholesky(std::move(factor_));
}

Nuisances::Whitened Nuisances::whitened(std::span<const double> residuals) const {
  Whitened result{{residuals.begin(), residuals.end()}, std::vector<double>(factor_.rows())};
  Eigen::Map<Eigen::VectorXd> noise(result.noise.data(), std::ssize(result.noise)),
      parameters(result.parameters.data(), std::ssize(result.parameters));
  whiten(noise_, noise);
  parameters = matrix(whitened_design_).transpose() * noise;
  lower(factor_).solveInPlace(parameters);
  return result;
}

std::vector<double> Nuisances::expected(std::span<const double> residuals) const {
  auto result = whitened(residuals).parameters;
  lower(factor_).adjoint().solveInPlace(
      Eigen::Map<Eigen::VectorXd>(result.data(), std::ssize(result)));
  return result;
}

std::vector<double> Nuisances::explained(std::span<const double> residuals) const {
  return explained(residuals, 0, design_.columns());
}

std::vector<double> Nuisances::explained(std::span<const double> residuals, std::size_t first,
                                         std::size_t count) const {
  const auto mean = expected(residuals);
  const auto from = static_cast<Eigen::Index>(first), columns = static_cast<Eigen::Index>(count);
  const Eigen::VectorXd result =
      matrix(design_).middleCols(from, columns) * vector(mean).segment(from, columns);
  return {result.begin(), result.end()};
}

std::vector<double> Nuisances::weighed(std::span<const double> residuals) const {
  const auto known = explained(residuals);
  Eigen::VectorXd result = vector(residuals) - vector(known);
  whiten(noise_, Eigen::Ref<Eigen::VectorXd>(result));
  Eigen::Index from = 0;
  for (const auto& block : noise_) {
    const auto size = matrix(block).rows();
    lower(block).adjoint().solveInPlace(result.segment(from, size));
    from += size;
  }
  return {result.begin(), result.end()};
}

double Nuisances::error_of_mean(std::span<const double> weights) const {
  const auto w = vector(weights);
  const Eigen::VectorXd parameters = matrix(design_).transpose() * w;
  double squares = lower(factor_).solve(parameters).squaredNorm();
  Eigen::Index from = 0;
  for (const auto& block : noise_) {
    const auto size = matrix(block).rows();
    squares += (lower(block).adjoint() * w.segment(from, size)).squaredNorm();
    from += size;
  }
  return std::sqrt(squares) / w.sum();
}

double product(const Nuisances::Whitened& a, const Nuisances::Whitened& b) {
  return vector(a.noise).dot(vector(b.noise)) - vector(a.parameters).dot(vector(b.parameters));
}

}  // namespace coppermoon::uses
