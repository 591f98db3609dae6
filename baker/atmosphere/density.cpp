// SPDX-License-Identifier: MIT
#include "atmosphere/density.h"

#include <array>
#include <cmath>

#include "algebra/table.h"
#include "atmosphere/tables.h"

namespace coppermoon::atmosphere {
namespace {

constexpr double geopotential_radius_m = 6356766;
constexpr double hydrostatic_constant_k_per_m = 9.80665 * 28.9644 / 8314.32;

struct Layer {
  double base_m, lapse_k_per_m, temperature_k, density_ratio;
  double exponent;  // of T/T_b; where the lapse rate is 0, of e, per metre
  double top_geometric_m;
};

constexpr std::size_t layer_count = 7;

double geometric(double geopotential_m) {
  return geopotential_radius_m * geopotential_m / (geopotential_radius_m - geopotential_m);
}

double ratio_in(const Layer& layer, double above_base_m) {
  if (layer.lapse_k_per_m == 0)
    return layer.density_ratio * std::exp(layer.exponent * above_base_m);
  const double warmth = 1 + layer.lapse_k_per_m * above_base_m / layer.temperature_k;
  return layer.density_ratio * std::pow(warmth, layer.exponent);
}

std::array<Layer, layer_count> standard_layers() {
  const auto table = algebra::parse_table(tables::us_standard_1976(), "us_standard_1976.csv");
  const auto &base = table["base_km"], &lapse = table["lapse_K_per_km"],
             &temperature = table["temperature_K"];
  std::array<Layer, layer_count> layers{};
  double ratio = 1;
  for (std::size_t i = 0; i < layer_count; ++i) {
    const double l = lapse[i] / 1e3, t = temperature[i];
    const double exponent =
        l == 0 ? -hydrostatic_constant_k_per_m / t : -1 - hydrostatic_constant_k_per_m / l;
    layers[i] = {base[i] * 1e3, l, t, ratio, exponent, geometric(base[i + 1] * 1e3)};
    ratio = ratio_in(layers[i], (base[i + 1] - base[i]) * 1e3);
  }
  return layers;
}

const std::array<Layer, layer_count> layers = standard_layers();

const Layer* layer_at(double altitude_m) {
  for (const auto& layer : layers)
    if (altitude_m < layer.top_geometric_m) return &layer;
  return nullptr;
}

}  // namespace

double density_ratio_us_1976(double altitude_m) {
  const Layer* layer = layer_at(altitude_m);
  if (!layer) return 0;
  const double h = geopotential_radius_m * altitude_m / (geopotential_radius_m + altitude_m);
  return ratio_in(*layer, h - layer->base_m);
}

ValueAndSlope density_ratio_and_slope_us_1976(double altitude_m) {
  const Layer* layer = layer_at(altitude_m);
  if (!layer) return {0, 0};
  const double stretch = geopotential_radius_m / (geopotential_radius_m + altitude_m);
  const double above = stretch * altitude_m - layer->base_m;
  const double ratio = ratio_in(*layer, above);
  const double log_slope = layer->lapse_k_per_m == 0
                               ? layer->exponent
                               : layer->exponent * layer->lapse_k_per_m /
                                     (layer->temperature_k + layer->lapse_k_per_m * above);
  return {ratio, ratio * log_slope * stretch * stretch};
}

double density_ratio_yapo_cutler(double altitude_m) {
  if (altitude_m >= taper_top_m) return 0;
  const double ratio = density_ratio_us_1976(altitude_m);
  if (altitude_m <= taper_bottom_m) return ratio;
  return ratio * (taper_top_m - altitude_m) / (taper_top_m - taper_bottom_m);
}

ValueAndSlope density_ratio_and_slope_yapo_cutler(double altitude_m) {
  if (altitude_m >= taper_top_m) return {0, 0};
  const auto ratio = density_ratio_and_slope_us_1976(altitude_m);
  if (altitude_m <= taper_bottom_m) return ratio;
  const double width = taper_top_m - taper_bottom_m, left = (taper_top_m - altitude_m) / width;
  return {ratio.value * left, ratio.slope_per_m * left - ratio.value / width};
}

std::span<const double> density_breaks_m() {
  static const std::array breaks{layers[0].top_geometric_m, layers[1].top_geometric_m,
                                 layers[2].top_geometric_m, taper_bottom_m, taper_top_m};
  return breaks;
}

std::span<const double> density_breaks_us_1976_m() {
  static const std::array breaks{layers[0].top_geometric_m, layers[1].top_geometric_m,layers[2].top_geometric_m, layers[3].top_geometric_m,layers[4].top_geometric_m, layers[5].top_geometric_m,layers[6].top_geometric_m};
  return breaks;
}

}  // namespace coppermoon::atmosphere
