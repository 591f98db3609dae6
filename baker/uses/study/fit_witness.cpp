// SPDX-License-Identifier: MIT
#include "uses/study/fit_witness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec3.hpp>
#include <numeric>

#include "algebra/error.h"
#include "colour/working_space.h"

namespace coppermoon::uses {
namespace {

/// Linear Rec.709 as renders have it: within its gamut.
std::array<double, 3> rec709_of(std::span<const double> xyz) {
  static const auto from_xyz = colour::channels_from_xyz(colour::WorkingSpace::linear_rec709);
  const auto rgb = from_xyz * glm::dvec3(xyz[0], xyz[1], xyz[2]);
  std::array<double, 3> channels{rgb.r, rgb.g, rgb.b};
  colour::into_gamut(colour::WorkingSpace::linear_rec709, channels);
  return channels;
}

/// The inverse of the Cholesky factor of a covariance.
algebra::Grid<double> whitening_of(algebra::Grid<double> covariance) {
  const std::size_t n = covariance.rows();
  auto& l = covariance;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = l(i, j);
      for (std::size_t k = 0; k < j; ++k) sum -= l(i, k) * l(j, k);
      l(i, j) = i == j ? std::sqrt(sum) : sum / l(j, j);
    }
  algebra::Grid<double> inverse(n, n);
  for (std::size_t j = 0; j < n; ++j) {
    inverse(j, j) = 1 / l(j, j);
    for (std::size_t i = j + 1; i < n; ++i) {
      double sum = 0;
      for (std::size_t k = j; k < i; ++k) sum -= l(i, k) * inverse(k, j);
      inverse(i, j) = sum / l(i, i);
    }
  }
  return inverse;
}

double squared(double x) { return x * x; }

/// Relative error of a value that the map of the Moon and the computation leave open.
double model_error(double value, double brightest) {
  constexpr double of_value = 0.003, of_brightest = 0.001;
  return std::hypot(of_value, of_brightest * brightest / value);
}

/// Logarithm of light that was seen, and whose it is.
struct Number {
  std::size_t bin, channel;
  double logarithm;
};

/// Numbers, and the matrix that makes their differences from any air's independent and of one size.
struct ComparedNumbers {
  std::vector<Number> numbers;
  algebra::Grid<double> whitening;

  double chi_squared(const algebra::Grid<double>& light_xyz) const {
    std::vector<double> apart;
    apart.reserve(numbers.size());
    std::array<double, 3> light{};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const auto& [bin, channel, logarithm] = numbers[i];
      if (i == 0 || bin != numbers[i - 1].bin) light = rec709_of(light_xyz.row(bin));
      apart.push_back(logarithm - std::log(std::max(light[channel], 1e-12)));
    }
    double sum = 0;
    for (std::size_t i = 0; i < apart.size(); ++i) {
      const auto row = whitening.row(i).first(i + 1);
      sum += squared(std::inner_product(row.begin(), row.end(), apart.begin(), 0.));
    }
    return sum;
  }
};

algebra::Grid<double> covariance_of(const std::vector<Number>& numbers,
                                    const std::vector<double>& own,
                                    const PhotometricErrors& errors) {
  constexpr double unknown = 10;
  const double exposure_error = errors.value_per_cd_m2 ? errors.exposure_error : unknown;
  algebra::Grid<double> covariance(numbers.size(), numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
    for (std::size_t j = 0; j < numbers.size(); ++j) {
      const bool coloured = numbers[i].channel == numbers[j].channel && numbers[i].channel != 1;
      covariance(i, j) = squared(exposure_error) + (i == j ? own[i] : 0) +
                         (coloured ? squared(errors.white_balance_error) : 0);
    }
  return covariance;
}

}  // namespace

Witness witness_of(const FitScene& scene, const BinnedPhotograph& photograph,
                   const PhotometricErrors& errors) {
  constexpr double too_noisy = 0.3, too_dark = 0.01;
  constexpr std::size_t least = 6;
  std::vector<Number> numbers;
  std::vector<double> own;
  for (std::size_t b = 0; b < scene.bins; ++b) {
    const auto values = photograph.values.row(b);
    const double brightest = *std::ranges::max_element(values);
    for (std::size_t k = 0; k < 3; ++k) {
      const double noise = photograph.errors(b, k) / values[k];
      if (values[k] <= 0 || noise > too_noisy || values[k] < too_dark * brightest) continue;
      numbers.push_back({b, k, std::log(values[k] / errors.value_per_cd_m2.value_or(1))});
      own.push_back(squared(noise) + squared(model_error(values[k], brightest)));
    }
  }
  if (numbers.size() < least)
    throw algebra::Error(fmt::format(
        "{} parts of the disc are neither clipped nor lost in noise, allowed {} or more",
        numbers.size(), least));
  const auto count = numbers.size();
  const ComparedNumbers comparison{numbers, whitening_of(covariance_of(numbers, own, errors))};
  return {
      &*scene.light,
      [comparison](const algebra::Grid<double>& light) { return comparison.chi_squared(light); },
      count};
}

}  // namespace coppermoon::uses
