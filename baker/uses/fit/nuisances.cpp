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

Eigen::Map<Matrix> changeable(Grid<double>& grid) {
  return {grid.values().data(), matrix(grid).rows(), matrix(grid).cols()};
}

}  // namespace

Nuisances::Nuisances(std::span<const Grid<double>> noise, Grid<double> design)
    : noise_(noise.begin(), noise.end()),
      design_(std::move(design)),
      factor_(design_.rows(), design_.rows()) {
  auto covariance = changeable(factor_);
  covariance.triangularView<Eigen::Lower>() = matrix(design_) * matrix(design_).transpose();
  Eigen::Index from = 0;
  for (const auto& block : noise_) {
    const auto size = matrix(block).rows();
    covariance.block(from, from, size, size) += matrix(block);
    from += size;
  }
  const Eigen::LLT<Eigen::Ref<Matrix>> in_place(covariance);
}

void Nuisances::whiten(Grid<double>& columns) const {
  lower(factor_).solveInPlace(changeable(columns));
}

std::vector<double> Nuisances::drawn(std::span<const double> normal) const {
  const Eigen::VectorXd result = lower(factor_) * vector(normal);
  return {result.begin(), result.end()};
}

double Nuisances::log_determinant() const {
  return 2 * matrix(factor_).diagonal().array().log().sum();
}

std::vector<double> Nuisances::expected(std::span<const double> residuals) const {
  const auto by_weight = weighed(residuals);
  const Eigen::VectorXd result = matrix(design_).transpose() * vector(by_weight);
  return {result.begin(), result.end()};
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
  Eigen::VectorXd result = vector(residuals);
  lower(factor_).solveInPlace(result);
  lower(factor_).adjoint().solveInPlace(result);
  return {result.begin(), result.end()};
}

double Nuisances::error_of_mean(std::span<const double> weights) const {
  // D + A M⁻¹ Aᵀ = 2 D − D C⁻¹ D, with M = 1 + Aᵀ D⁻¹ A
  Eigen::VectorXd by_noise(std::ssize(weights));
  Eigen::Index from = 0;
  for (const auto& block : noise_) {
    const auto size = matrix(block).rows();
    by_noise.segment(from, size) = matrix(block) * vector(weights).segment(from, size);
    from += size;
  }
  const auto w = vector(weights);
  const double squares = 2 * w.dot(by_noise);
  lower(factor_).solveInPlace(by_noise);
  return std::sqrt(squares - by_noise.squaredNorm()) / w.sum();
}

}  // namespace coppermoon::uses
