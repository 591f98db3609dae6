// SPDX-License-Identifier: MIT
#include "uses/fit/compared_night.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <numeric>
#include <utility>

#include "algebra/error.h"
#include "colour/working_space.h"
#include "uses/fit/limb_weather.h"

namespace coppermoon::uses {
namespace {

/// Columns of the design matrix: nuisance parameters of the night, then those of each photograph.
namespace of_night {
enum : std::size_t {
  exposure,
  red,
  blue,
  curve,
  saturation = curve + colour::tone_numbers,
  mixing,  ///< six elements off the diagonal, row by row
  count = mixing + 6
};
}
namespace of_photograph {
enum : std::size_t { exposure, red, blue, sky, place = sky + 3, glow, count };
}

/// Error of a tone curve between the levels at which it is known.
///
/// Source  measured curves of five cameras: 0.003
constexpr double between_tents = 0.005;

/// Error of light by what weather does beyond its linear effect: the second order.
double second_order_of_weather(double weather_error) { return weather_error * weather_error; }

/// Weather of a limb's part in one hour: of all light; of blue apart; of deep light, whose rays pass lower, apart.
enum Weather : std::size_t { of_light, of_blue, of_depth, weathers };

/// Standard deviation of a channel's light by weather, over that of red, where its derivative by cloud is not known.
///
/// Given  distance_km  from the axis; the umbra ends at some 4600 km
double weather_of(std::size_t weather, std::size_t channel, double distance_km) {
  constexpr std::array<double, 3> all{1, 1.2, 1.4}, blue{0, 0.3, 0.6};
  constexpr double umbra_km = 4600;
  if (weather == of_blue) return blue[channel];
  return all[channel] * (weather == of_light ? 1 : 1 - 2 * std::min(1., distance_km / umbra_km));
}

/// Luminance of linear Rec.709.
constexpr std::array luminance_of_rec709{0.2126, 0.7152, 0.0722};

/// Least light of a channel over the brightest: cameras do not write less.
constexpr double least_of_brightest = 0.003;

/// Mean y of two values with ln(a/b) = (a − b)/y.
double logarithmic_mean(double a, double b) {
  const double ratio = a / b - 1;
  return std::abs(ratio) < 1e-4 ? std::sqrt(a * b) : b * ratio / std::log1p(ratio);
}

/// Moments, an hour apart, between which weather changes linearly.
struct WeatherKnots {
  double first_s = 0;
  std::size_t count = 1;
  static constexpr double step_s = 3600;

  /// Weights of independent changes, one at each knot, in the weather of a moment.
  ///
  /// A part of the weather stays from knot to knot: systems of 1500 km pass the limb in an hour near the equator, in many
  /// near the poles; land and sea, cloudier or clearer than their belt, stay for a night.
  std::vector<double> weights(double seconds) const {
    constexpr double stays = 0.8;
    const double place = count > 1 ? (seconds - first_s) / step_s : 0;
    const auto knot = std::min(static_cast<std::size_t>(std::max(0., place)), count - 1);
    const double part = place - static_cast<double>(knot);
    const auto left_at = [&](std::size_t at, std::size_t change) {
      if (change > at) return 0.;
      const double first = change == 0 ? 1 : std::sqrt(1 - stays * stays);
      return first * std::pow(stays, static_cast<double>(at - change));
    };
    std::vector<double> all;
    for (std::size_t change = 0; change < count; ++change)
      all.push_back((1 - part) * left_at(knot, change) +
                    (part > 0 ? part * left_at(knot + 1, change) : 0));
    return all;
  }
};

/// Seconds from the first photograph's moment.
double seconds_of(std::span<const NightPhotograph> photographs, std::size_t p) {
  return almanac::seconds_between(photographs.front().scene.sky.when,
                                  photographs[p].scene.sky.when);
}

WeatherKnots weather_knots(std::span<const NightPhotograph> photographs) {
  double first = 0, last = 0;
  for (std::size_t p = 0; p < photographs.size(); ++p) {
    first = std::min(first, seconds_of(photographs, p));
    last = std::max(last, seconds_of(photographs, p));
  }
  const double hours = (last - first) / WeatherKnots::step_s;
  return {first, hours < 0.25 ? 1 : static_cast<std::size_t>(std::ceil(hours)) + 1};
}

/// Shares of a scene's bins in the light of the limb's parts: (bin, part).
algebra::Grid<double> limb_of_bins(const FitScene& scene) {
  const double sun_m = glm::length(scene.sky.sun_m);
  algebra::Grid<double> shares(scene.bins, weather_sectors);
  std::vector<double> sunlit(scene.bins);
  for (const auto& lit : lit_bins(scene, scene.sky).places) {
    const auto of_place = shares_of_limb(lit.place, sun_m);
    sunlit[lit.bin] += lit.sunlit;
    for (std::size_t s = 0; s < of_place.size(); ++s)
      shares(lit.bin, s) += lit.sunlit * of_place[s];
  }
  for (std::size_t b = 0; b < scene.bins; ++b)
    for (double& share : shares.row(b)) share /= std::max(sunlit[b], 1e-300);
  return shares;
}

/// Prior standard deviation (log units) of a nuisance parameter about which nothing is known.
constexpr double unknown_deviation = 10;

/// Relative error of the computation in one channel: of FittedLight, and of the number of wavelengths.
double error_of_computation(double value, double brightest) {
  constexpr double of_value = 0.0005, of_brightest = 0.0002;
  return std::hypot(of_value, of_brightest * brightest / value);
}

/// Correlation of the computation's errors between bins of one channel so far apart.
double correlation_of_computation(double distance_km) {
  constexpr double alike_km = 500;
  return std::exp(-distance_km / alike_km);
}

/// Covariance of the map's errors, (bin, bin), independent in each channel: 1.2 % in each place of 200 km, over
/// which a bin is the mean.
algebra::Grid<double> covariances_of_map(const FitScene& scene) {
  constexpr double error = 0.012, place_km = 200,
                   pixel_km = 2 * algebra::in_kilometres(almanac::lunar_radius) /
                              (fit_disc_share * fit_side_px),
                   place_px = place_km / pixel_km;
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

/// Derivative of the logarithm of light by distance from the axis [1/km], from the neighbouring bins.
double logarithmic_slope(const FitScene& scene, const algebra::Grid<double>& values, std::size_t b,
                         std::size_t k) {
  const auto known = [&](std::size_t bin) { return bin < scene.bins && values(bin, k) > 0; };
  const auto from = b > 0 && known(b - 1) ? b - 1 : b, to = known(b + 1) ? b + 1 : b;
  if (from == to) return 0;
  return std::log(values(to, k) / values(from, k)) /
         (scene.distances_km[to] - scene.distances_km[from]);
}

/// Moments beside each photograph's at which light is computed, for its derivative by the clock [s].
std::vector<double> clock_steps_s(double clock_error_s) {
  constexpr double step_s = 60;
  return clock_error_s > 0 ? std::vector<double>{-step_s, 0, step_s} : std::vector<double>{0};
}

}  // namespace

FittedLight night_light(const LightRequest& request, Unknowns unknowns,
                        std::span<const NightPhotograph> photographs,
                        std::span<const almanac::Instant> instants, double clock_error_s,
                        FittedAirs airs, const algebra::Progress& progress,
                        const std::optional<AirRange>& range) {
  std::vector<LitBins> parts;
  std::vector<almanac::SkyState> skies;
  for (std::size_t p = 0; p < photographs.size(); ++p)
    for (const double step_s : clock_steps_s(clock_error_s)) {
      skies.push_back(almanac::sky_at(almanac::later(instants[p], step_s)));
      parts.push_back(lit_bins(photographs[p].scene, skies.back()));
    }
  std::ranges::sort(skies, [](const auto& one, const auto& other) {
    return almanac::seconds_between(one.when, other.when) > 0;
  });
  return {request, unknowns, skies, parts, airs, progress, range};
}

ComparedNight::ComparedNight(std::span<const NightPhotograph> photographs,
                             const NightErrors& errors)
    : errors_(errors) {
  constexpr std::size_t least = 6;
  for (const auto& photograph : photographs) {
    bins_ = photograph.scene.bins;
    curved_ = curved_ || !photograph.light.slopes.empty();
    mixed_ = mixed_ || photograph.errors.mixing_error > 0;
    mixing_error_ = std::max(mixing_error_, photograph.errors.mixing_error);
    saturation_error_ = std::max(saturation_error_, photograph.errors.saturation_error);
    distances_km_.push_back(photograph.scene.distances_km);
    sunlight_.push_back(sunlight_of(photograph.scene.weights));
    add_measurements(photograph, distances_km_.size() - 1);
  }
  if (measurements_.size() < least)
    throw algebra::Error(fmt::format(
        "{} parts of the disc are neither clipped nor lost in noise, allowed {} or more",
        measurements_.size(), least));
  nuisances_ = {noise(photographs), design(photographs)};
}

std::vector<algebra::Grid<double>> ComparedNight::noise(
    std::span<const NightPhotograph> photographs) const {
  std::vector<algebra::Grid<double>> all;
  for (std::size_t p = 0, first = 0; p < photographs.size(); ++p) {
    const auto of_map = covariances_of_map(photographs[p].scene);
    const auto count = count_of(p);
    auto& block = all.emplace_back(count, count);
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < count; ++j) {
        const auto &one = measurements_[first + i], &other = measurements_[first + j];
        if (one.channel == other.channel)
          block(i, j) = of_map(one.bin, other.bin) +
                        one.of_computation * other.of_computation *
                            correlation_of_computation(
                                std::abs(distances_km_[p][one.bin] - distances_km_[p][other.bin]));
        if (i == j) block(i, j) += one.error * one.error;
      }
    first += count;
  }
  return all;
}

void ComparedNight::add_measurements(const NightPhotograph& photograph, std::size_t index) {
  constexpr double too_noisy = 0.3, too_dark = 0.01, least_error = 0.0003;
  const auto& [values, errors, sky_errors, glow_errors, slopes] = photograph.light;
  for (std::size_t b = 0; b < bins_; ++b) {
    const double brightest = *std::ranges::max_element(values.row(b));
    for (std::size_t k = 0; k < 3; ++k) {
      const double value = values(b, k), noise = errors(b, k) / value;
      if (value <= 0 || noise > too_noisy || value < too_dark * brightest) continue;
      double logarithm = std::log(value / photograph.errors.value_per_cd_m2.value_or(1));
      if (!slopes.empty())  // by the mean tone curve of cameras, to first order
        for (std::size_t n = 0; n < colour::tone_numbers; ++n)
          logarithm -= slopes(b, k)[n] * errors_.curve.numbers[n];
      const double of_tents = slopes.empty() ? 0 : between_tents;
      measurements_.push_back({index, b, k, logarithm,
                               std::hypot(std::hypot(noise, least_error), of_tents,
                                          second_order_of_weather(photograph.errors.weather_error)),
                               error_of_computation(value, brightest)});
    }
  }
}

std::array<double, 3> ComparedNight::as_written(std::span<const double> xyz) const {
  const auto rgb = rec709_of(xyz);
  const double brightest = *std::ranges::max_element(rgb);
  std::array<double, 3> written;
  for (std::size_t k = 0; k < 3; ++k)
    written[k] = std::max(std::inner_product(rgb.begin(), rgb.end(), errors_.mixing[k].begin(), 0.),
                          mixed_ ? least_of_brightest * brightest : 1e-12);
  return written;
}

std::array<double, 3> ComparedNight::expected_of(const NightPhotograph& photograph,
                                                 std::size_t index, std::size_t bin) const {
  const auto steps = clock_steps_s(errors_.clock_error_s).size();
  if (errors_.expected.rows() > 0)
    return rec709_of(errors_.expected.row((index * steps + steps / 2) * bins_ + bin));
  const auto row = photograph.scene.usual_values.row(bin);
  return {row[0], row[1], row[2]};
}

algebra::Grid<double> ComparedNight::design(std::span<const NightPhotograph> photographs) const {
  constexpr double white_balance_drift = 0.003;
  const auto knots = weather_knots(photographs);
  const bool weather = std::ranges::any_of(
      photographs, [](const auto& one) { return one.errors.weather_error > 0; });
  const std::size_t of_photographs = of_night::count + of_photograph::count * photographs.size(),
                    of_weather = weather ? weather_sectors * weathers * knots.count : 0;
  std::size_t cameras = 0;
  for (const auto& photograph : photographs)
    cameras = std::max(cameras, photograph.scene.by_filters.size());
  algebra::Grid<double> a(measurements_.size(), of_photographs + of_weather + cameras);
  const auto dimming = dimming_by_cloud();
  std::vector<algebra::Grid<double>> limbs;
  if (weather)
    for (const auto& photograph : photographs) limbs.push_back(limb_of_bins(photograph.scene));
  for (std::size_t i = 0; i < measurements_.size(); ++i) {
    const auto& [p, b, k, logarithm, error, of_computation] = measurements_[i];
    const auto& [scene, light, errors] = photographs[p];
    const double value = light.values(b, k);
    const bool scaled = errors.value_per_cd_m2.has_value(), curved = !light.slopes.empty();
    const auto night = a.row(i), own = night.subspan(of_night::count + of_photograph::count * p,
                                                     of_photograph::count);
    if (scaled) night[of_night::exposure] = errors.exposure_error;
    own[of_photograph::exposure] = scaled ? errors.shutter_error : unknown_deviation;
    if (k != 1) {
      const bool fixed = errors.white_balance_fixed;
      if (fixed) night[of_night::red + k / 2] = errors.white_balance_error;
      own[of_photograph::red + k / 2] = fixed ? white_balance_drift : errors.white_balance_error;
    }
    own[of_photograph::sky + k] = light.sky_errors(b, k) / value;
    own[of_photograph::place] =
        errors.place_error_km * logarithmic_slope(scene, light.values, b, k);
    own[of_photograph::glow] = light.glow_errors(b, k) / value;
    if (curved) std::ranges::copy(light.slopes(b, k), &night[of_night::curve]);
    if (errors.mixing_error > 0) add_mixing(photographs[p], measurements_[i], night);
    // the covariance of these columns is that of the cameras about the one assumed
    for (std::size_t c = 0; c < scene.by_filters.size(); ++c)
      night[of_photographs + of_weather + c] =
          scene.by_filters[c](b, k) / std::sqrt(static_cast<double>(cameras));
    if (errors.weather_error > 0) {
      const auto changes = knots.weights(seconds_of(photographs, p));
      for (std::size_t s = 0; s < weather_sectors; ++s)
        for (std::size_t w = 0; w < weathers; ++w) {
          const double light_of_part =
              errors.weather_error * limbs[p](b, s) *
              (dimming.rows() == 0 || w == of_blue ? weather_of(w, k, scene.distances_km[b])
               : w == of_light                     ? dimming(p * bins_ + b, k)
                                                   : 0);
          for (std::size_t change = 0; change < changes.size(); ++change)
            night[of_photographs + (change * weathers + w) * weather_sectors + s] =
                changes[change] * light_of_part;
        }
    }
  }
  return a;
}

algebra::Grid<double> ComparedNight::dimming_by_cloud() const {
  if (errors_.clouded.rows() == 0) return {};
  constexpr double least_distance_km = 1000, most_distance_km = 4000;
  const auto steps = clock_steps_s(errors_.clock_error_s).size();
  algebra::Grid<double> all(distances_km_.size() * bins_, 3);
  double red = 0, count = 0;
  for (std::size_t p = 0; p < distances_km_.size(); ++p)
    for (std::size_t b = 0; b < bins_; ++b) {
      const auto row = (p * steps + steps / 2) * bins_ + b;
      const auto before = as_written(errors_.expected.row(row)),
                 after = as_written(errors_.clouded.row(row));
      for (std::size_t k = 0; k < 3; ++k) all(p * bins_ + b, k) = std::log(before[k] / after[k]);
      const double distance_km = distances_km_[p][b];
      if (distance_km < least_distance_km || distance_km > most_distance_km) continue;
      red += all(p * bins_ + b, 0);
      ++count;
    }
  if (count == 0 || red <= 0) return {};
  const double mean = red / count,
               weather = errors_.clouded_by > 0 ? weather_over_usual(mean / errors_.clouded_by) : 1;
  for (double& value : all.values()) value *= weather / mean;
  return all;
}

void ComparedNight::add_mixing(const NightPhotograph& photograph, const Measurement& measurement,
                               std::span<double> night) const {
  const auto& [p, b, k, logarithm, error, of_computation] = measurement;
  const auto light = expected_of(photograph, p, b);
  std::array<double, 3> written;
  for (std::size_t c = 0; c < 3; ++c)
    written[c] = std::inner_product(light.begin(), light.end(), errors_.mixing[c].begin(), 0.);
  const auto brightest =
      static_cast<std::size_t>(std::ranges::max_element(written) - written.begin());
  const double least = least_of_brightest * written[brightest];
  // the photograph's own light, as bright as expected in its brightest channel
  const double seen = photograph.light.values(b, brightest) > 0
                          ? photograph.light.values(b, k) / photograph.light.values(b, brightest) *
                                written[brightest]
                          : written[k];
  const double mean = logarithmic_mean(std::max(seen, least), std::max(written[k], least));
  std::size_t column = of_night::mixing + 2 * k;
  for (std::size_t from = 0; from < 3; ++from) {
    const double change = light[from] / mean;
    const double whole = (from == k ? 1 : 0) - luminance_of_rec709[from];
    night[of_night::saturation] += photograph.errors.saturation_error * whole * change;
    if (from != k) night[column++] = photograph.errors.mixing_error * change;
  }
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
        logarithms[s] = as_written(light.row((p * steps_s.size() + s) * bins_ + b));
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
  colour::ToneCurve found;
  if (!curved_) return found;
  const auto parameters = nuisances_.expected(residuals_by_the_clock(light));
  for (std::size_t n = 0; n < colour::tone_numbers; ++n)
    found.numbers[n] = -parameters[of_night::curve + n];  // excess light is taken off by the curve
  return found;
}

Mixing ComparedNight::mixing(const algebra::Grid<double>& light) const {
  auto found = errors_.mixing;
  if (!mixed_) return found;
  const auto parameters = nuisances_.expected(residuals_by_the_clock(light));
  std::size_t element = of_night::mixing;
  for (std::size_t to = 0; to < 3; ++to)
    for (std::size_t from = 0; from < 3; ++from) {
      const double whole = (from == to ? 1 : 0) - luminance_of_rec709[from];
      found[to][from] += saturation_error_ * parameters[of_night::saturation] * whole;
      if (from != to) found[to][from] += mixing_error_ * parameters[element++];
    }
  return found;
}

std::vector<MeasuredLight> ComparedNight::measured(const algebra::Grid<double>& light) const {
  constexpr double step_km = 100;
  const auto differences = residuals_by_the_clock(light);
  const auto explained = nuisances_.explained(differences);
  std::map<std::pair<long, std::size_t>, std::vector<std::size_t>> steps;  // [step, channel]
  for (std::size_t i = 0; i < measurements_.size(); ++i) {
    const auto& [p, b, k, logarithm, error, of_computation] = measurements_[i];
    steps[{std::lround(distances_km_[p][b] / step_km), k}].push_back(i);
  }
  std::vector<MeasuredLight> all;
  for (const auto& [step, members] : steps) {
    std::vector<double> weights(measurements_.size());
    double sum = 0, distance_km = 0, measured = 0, model = 0;
    for (const auto i : members) {
      const auto& [p, b, k, logarithm, error, of_computation] = measurements_[i];
      const double weight = 1 / (error * error), sunlight = std::log(sunlight_[p][k]);
      weights[i] = weight;
      sum += weight;
      distance_km += weight * distances_km_[p][b];
      measured += weight * (logarithm - explained[i] - sunlight);
      model += weight * (logarithm - differences[i] - sunlight);
    }
    all.push_back({distance_km / sum, step.second, std::exp(measured / sum), std::exp(model / sum),
                   nuisances_.error_of_mean(weights)});
  }
  return all;
}

std::vector<Misfit> ComparedNight::misfits(const algebra::Grid<double>& light) const {
  constexpr double step_km = 300;
  auto differences = residuals_by_the_clock(light);
  const auto weighed = nuisances_.weighed(differences), known = nuisances_.explained(differences),
             own = nuisances_.explained(differences, of_night::count,
                                        of_photograph::count * distances_km_.size());
  for (std::size_t i = 0; i < differences.size(); ++i) differences[i] -= known[i] - own[i];
  struct Sum {
    std::size_t count = 0;
    double weight = 0, distance_km = 0, mean = 0, squares = 0, chi_squared = 0;

    void add(double noise, double km, double difference, double part) {
      const double w = 1 / (noise * noise);
      ++count;
      weight += w;
      distance_km += w * km;
      mean += w * difference;
      squares += w * difference * difference;
      chi_squared += part;
    }
  };
  std::map<std::pair<std::size_t, std::size_t>, std::map<long, Sum>> sums;
  std::map<std::pair<std::size_t, std::size_t>, Sum> wholes;
  for (std::size_t i = 0; i < measurements_.size(); ++i) {
    const auto& [p, b, k, logarithm, error, of_computation] = measurements_[i];
    const double km = distances_km_[p][b], part = differences[i] * weighed[i];
    for (auto* sum : {&wholes[{p, k}], &sums[{p, k}][std::lround(km / step_km)]})
      sum->add(error, km, differences[i], part);
  }
  std::vector<Misfit> all;
  for (const auto& [place, whole] : wholes) {
    const auto& [distance, worst] = *std::ranges::max_element(
        sums[place], {}, [](const auto& step) { return step.second.chi_squared; });
    const double mean = whole.mean / whole.weight;
    all.push_back({place.first, place.second, whole.count, whole.chi_squared, mean,
                   std::sqrt(std::max(0., whole.squares / whole.weight - mean * mean)),
                   worst.distance_km / worst.weight, worst.mean / worst.weight});
  }
  return all;
}

}  // namespace coppermoon::uses
