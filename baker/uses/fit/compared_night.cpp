// SPDX-License-Identifier: MIT
#include "uses/fit/compared_night.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "algebra/error.h"

namespace coppermoon::uses {
namespace {

/// Relative error of light due to a tone curve's error between the levels at which the curve is defined.
///
/// Source  measured curves of five cameras, in which the error is 0.003, less than the value used here
constexpr double between_tents = 0.005;

/// Relative error of light due to second-order effects of weather, which the linear nuisances do not cover.
double second_order_of_weather(double weather_error) { return weather_error * weather_error; }

/// Relative error of computed light in one channel, due to the interpolation in FittedLight and the limited number of
/// wavelengths and rays. The figures include the same error of photographs that this program itself rendered.
double error_of_computation(double value, double brightest) {
  constexpr double of_value = 0.001, of_brightest = 0.0002;
  return std::hypot(of_value, of_brightest * brightest / value);
}

/// Correlation between errors of computed light in two bins, in one channel. It falls with distance between the bins.
double correlation_of_computation(double distance_km) {
  constexpr double alike_km = 500;
  return std::exp(-distance_km / alike_km);
}

/// Covariance (bin, bin) of the errors that the Moon's map causes in one channel. The map has an independent error of
/// 1.2 % in each square of 200 km, and its errors are averaged over a bin.
algebra::Grid<double> covariances_of_map(const FitScene& scene) {
  constexpr double error = 0.012, place_px = 200 / fit_pixel_km;
  constexpr auto across = static_cast<std::size_t>(fit_side_px / place_px) + 1;
  const auto place = [](std::size_t px) {
    return static_cast<std::size_t>(static_cast<double>(px) / place_px);
  };
  algebra::Grid<double> shares(scene.bins, across * across);
  for (const auto& ground : scene.grounds)
    shares(ground.bin, place(ground.pixel / fit_side_px) * across +
                           place(ground.pixel % fit_side_px)) += ground.sunlit;
  for (std::size_t b = 0; b < scene.bins; ++b) {
    const auto row = shares.row(b);
    const double all = std::reduce(row.begin(), row.end());
    for (double& share : row) share *= all > 0 ? error / all : 0;
  }
  algebra::Grid<double> result(scene.bins, scene.bins);
  for (std::size_t b = 0; b < scene.bins; ++b)
    for (std::size_t c = 0; c < scene.bins; ++c)
      result(b, c) =
          std::inner_product(shares.row(b).begin(), shares.row(b).end(), shares.row(c).begin(), 0.);
  return result;
}

/// Adds the measurements from a photograph, one for each bin and channel that is neither clipped nor lost in noise.
void add_measurements(const Binned& photograph, std::size_t index, const colour::ToneCurve& curve,
                      std::vector<Measurement>& all) {
  constexpr double too_noisy = 0.3, too_dark = 0.01, least_error = 0.0003;
  const auto& [values, errors, sky_errors, glow_errors, slopes] = photograph.light;
  for (std::size_t b = 0; b < photograph.scene->bins; ++b) {
    const double brightest = *std::ranges::max_element(values.row(b));
    for (std::size_t k = 0; k < 3; ++k) {
      const double value = values(b, k), noise = errors(b, k) / value;
      if (value <= 0 || noise > too_noisy || value < too_dark * brightest) continue;
      double logarithm = std::log(value / photograph.errors.value_per_cd_m2.value_or(1));
      if (!slopes.empty())  // convert to the mean tone curve of all cameras
        for (std::size_t n = 0; n < colour::tone_numbers; ++n)
          logarithm -= slopes(b, k)[n] * curve.numbers[n];
      all.push_back({index, b, k, logarithm,
                     std::hypot(std::hypot(noise, least_error), slopes.empty() ? 0 : between_tents,
                                second_order_of_weather(photograph.errors.weather_error)),
                     error_of_computation(value, brightest)});
    }
  }
}

/// Covariance of the noise in a photograph's measurements.
algebra::Grid<double> noise_of(const FitScene& scene, std::span<const Measurement> own) {
  const auto of_map = covariances_of_map(scene);
  algebra::Grid<double> block(own.size(), own.size());
  for (std::size_t i = 0; i < own.size(); ++i)
    for (std::size_t j = 0; j < own.size(); ++j) {
      const auto &one = own[i], &other = own[j];
      if (one.channel == other.channel)
        block(i, j) = of_map(one.bin, other.bin) +
                      one.of_computation * other.of_computation *
                          correlation_of_computation(std::abs(scene.distances_km[one.bin] -
                                                              scene.distances_km[other.bin]));
      if (i == j) block(i, j) += one.error * one.error;
    }
  return block;
}

/// Sums over measurements, weighted by the inverse square of their noise.
struct Sum {
  std::size_t count = 0;
  double weight = 0, distance_km = 0, value = 0, squares = 0, chi_squared = 0;

  void add(double noise, double km, double of_value, double of_chi_squared) {
    const double w = 1 / (noise * noise);
    ++count;
    weight += w;
    distance_km += w * km;
    value += w * of_value;
    squares += w * of_value * of_value;
    chi_squared += of_chi_squared;
  }
  double km() const { return distance_km / weight; }
  double mean() const { return value / weight; }
  double scatter() const { return std::sqrt(std::max(0., squares / weight - mean() * mean())); }
};

}  // namespace

ComparedNight::ComparedNight(std::span<const Binned> photographs, const NightErrors& errors)
    : errors_(errors), rows_(rows_of(photographs, errors)), mixed_(is_mixed(photographs)) {
  constexpr std::size_t least = 6;
  std::vector<algebra::Grid<double>> noise;
  for (const auto& photograph : photographs) {
    curved_ = curved_ || !photograph.light.slopes.empty();
    mixing_error_ = std::max(mixing_error_, photograph.errors.mixing_error);
    saturation_error_ = std::max(saturation_error_, photograph.errors.saturation_error);
    distances_km_.push_back(photograph.scene->distances_km);
    sunlight_.push_back(sunlight_of(photograph.scene->weights));
    colours_.push_back(photograph.colours);
    const auto before = measurements_.size();
    add_measurements(photograph, distances_km_.size() - 1, errors.curve, measurements_);
    noise.push_back(noise_of(*photograph.scene, std::span(measurements_).subspan(before)));
  }
  if (measurements_.size() < least)
    throw algebra::Error(fmt::format(
        "{} parts of the disc are neither clipped nor lost in noise, allowed {} or more",
        measurements_.size(), least));
  auto design = design_of(nuisances_of(photographs, errors_), measurements_, photographs.size());
  first_ = design.first;
  first_own_ = design.first_own;
  nuisances_ = {noise, std::move(design.matrix)};
}

std::size_t ComparedNight::count_of(std::size_t photograph) const {
  return static_cast<std::size_t>(
      std::ranges::count(measurements_, photograph, &Measurement::photograph));
}

ComparedNight::Residuals ComparedNight::residuals(const algebra::Grid<double>& light) const {
  const auto steps_s = clock_steps_s(errors_.clock_error_s);
  const auto middle = steps_s.size() / 2;
  Residuals result;
  std::vector<std::array<double, 3>> logarithms(steps_s.size());
  for (std::size_t i = 0; i < measurements_.size(); ++i) {
    const auto& [p, b, k, logarithm, error, of_computation] = measurements_[i];
    if (i == 0 || p != measurements_[i - 1].photograph || b != measurements_[i - 1].bin)
      for (std::size_t s = 0; s < steps_s.size(); ++s) {
        logarithms[s] = as_written(light.row(rows_.at(p, s, b)), colours_[p], errors_.mixing,
                                   mixed_ ? least_of_brightest : 0);
        for (double& value : logarithms[s]) value = std::log(value);
      }
    result.differences.push_back(logarithm - logarithms[middle][k]);
    if (steps_s.size() > 1)
      result.per_second.push_back((logarithms.back()[k] - logarithms.front()[k]) /
                                  (steps_s.back() - steps_s.front()));
  }
  return result;
}

GoodnessOfFit ComparedNight::goodness(const algebra::Grid<double>& light) const {
  const auto [differences, per_second] = residuals(light);
  const auto whitened = nuisances_.whitened(differences);
  GoodnessOfFit result{product(whitened, whitened)};
  if (per_second.empty()) return result;
  const auto clock = nuisances_.whitened(per_second);
  const double believed = 1 / (errors_.clock_error_s * errors_.clock_error_s),
               mean_s = errors_.clock_mean_s, information = product(clock, clock) + believed;
  result.clock_s = (product(clock, whitened) + believed * mean_s) / information;
  result.clock_variance_s2 = 1 / information;
  result.chi_squared += believed * mean_s * mean_s - result.clock_s * result.clock_s * information;
  return result;
}

std::vector<double> ComparedNight::residuals_by_the_clock(
    const algebra::Grid<double>& light) const {
  auto [differences, per_second] = residuals(light);
  const double clock_s = goodness(light).clock_s;
  for (std::size_t i = 0; i < per_second.size(); ++i) differences[i] -= clock_s * per_second[i];
  return differences;
}

colour::ToneCurve ComparedNight::curve(const algebra::Grid<double>& light) const {
  colour::ToneCurve curve;
  if (!curved_) return curve;
  const auto found = nuisances_.expected(residuals_by_the_clock(light));
  for (std::size_t n = 0; n < colour::tone_numbers; ++n)
    curve.numbers[n] = -found[first_.at("tone curve") + n];  // negated to cancel the residuals
  return curve;
}

Mixing ComparedNight::mixing(const algebra::Grid<double>& light) const {
  auto mixing = errors_.mixing;
  if (!mixed_) return mixing;
  const auto found = nuisances_.expected(residuals_by_the_clock(light));
  const double saturation = saturation_error_ * found[first_.at("saturation")];
  auto element = first_.at("mixing");
  for (std::size_t to = 0; to < 3; ++to)
    for (std::size_t from = 0; from < 3; ++from) {
      mixing[to][from] += saturation * ((from == to ? 1 : 0) - luminance_of_rec709[from]);
      if (from != to) mixing[to][from] += mixing_error_ * found[element++];
    }
  return mixing;
}

std::vector<MeasuredLight> ComparedNight::measured(const algebra::Grid<double>& light) const {
  constexpr double step_km = 100;
  const auto differences = residuals_by_the_clock(light);
  const auto explained = nuisances_.explained(differences);
  struct Step {
    Sum measured, model;
    std::vector<double> weights;
  };
  std::map<std::pair<long, std::size_t>, Step> steps;  // keyed by distance step and channel
  for (std::size_t i = 0; i < measurements_.size(); ++i) {
    const auto& [p, b, k, logarithm, error, of_computation] = measurements_[i];
    const double km = distances_km_[p][b],
                 model = std::log(rec709_of(light.row(rows_.own(p, b)))[k] / sunlight_[p][k]);
    auto& step = steps[{std::lround(km / step_km), k}];
    step.measured.add(error, km, model + differences[i] - explained[i], 0);
    step.model.add(error, km, model, 0);
    step.weights.resize(measurements_.size());
    step.weights[i] = 1 / (error * error);
  }
  std::vector<MeasuredLight> all;
  for (const auto& [place, step] : steps)
    all.push_back({step.measured.km(), place.second, std::exp(step.measured.mean()),
                   std::exp(step.model.mean()), nuisances_.error_of_mean(step.weights)});
  return all;
}

std::vector<Misfit> ComparedNight::misfits(const algebra::Grid<double>& light) const {
  constexpr double step_km = 300;
  const auto differences = residuals_by_the_clock(light), weighed = nuisances_.weighed(differences),
             of_night = nuisances_.explained(differences, 0, first_own_);
  struct InChannel {
    Sum whole;
    std::map<long, Sum> steps;
  };
  std::map<std::pair<std::size_t, std::size_t>, InChannel> sums;  // keyed by photograph and channel
  for (std::size_t i = 0; i < measurements_.size(); ++i) {
    const auto& [p, b, k, logarithm, error, of_computation] = measurements_[i];
    const double km = distances_km_[p][b], left = differences[i] - of_night[i];
    auto& [whole, steps] = sums[{p, k}];
    for (auto* sum : {&whole, &steps[std::lround(km / step_km)]})
      sum->add(error, km, left, left * weighed[i]);
  }
  std::vector<Misfit> all;
  for (const auto& [place, sum] : sums) {
    const auto& worst = std::ranges::max_element(sum.steps, {}, [](const auto& step) {
                          return step.second.chi_squared;
                        })->second;
    const auto& whole = sum.whole;
    all.push_back({place.first, place.second, whole.count, whole.chi_squared, whole.mean(),
                   whole.scatter(), worst.km(), worst.mean()});
  }
  return all;
}

}  // namespace coppermoon::uses
