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
  double base_m, density_ratio;
  double warming_per_m;  // lapse rate divided by base temperature, L/T_b
  double exponent;       // power of T/T_b in the density; if L is 0, d ln(density)/dh [1/m]
};

constexpr std::size_t layer_count = 7;

double geometric(double geopotential_m) {
  return geopotential_radius_m * geopotential_m / (geopotential_radius_m - geopotential_m);
}

ValueAndSlope along_geopotential(const Layer& layer, double above_base_m) {
  if (layer.warming_per_m == 0) {
    const double ratio = layer.density_ratio * std::exp(layer.exponent * above_base_m);
    return {ratio, layer.exponent * ratio};
  }
  const double warmth = 1 + layer.warming_per_m * above_base_m;
  const double ratio = layer.density_ratio * std::exp(layer.exponent * std::log(warmth));
  return {ratio, ratio * layer.exponent * layer.warming_per_m / warmth};
}

struct Layers {
  std::array<Layer, layer_count> layer;
  std::array<double, layer_count> top_geometric_m;
};

Layers standard_layers() {
  const auto table = algebra::parse_table(tables::us_standard_1976(), "us_standard_1976.csv");
  const auto &base = table["base_km"], &lapse = table["lapse_K_per_km"],
             &temperature = table["temperature_K"];
  Layers layers{};
  double ratio = 1;
  for (std::size_t i = 0; i < layer_count; ++i) {
    const double l = lapse[i] / 1e3, t = temperature[i];
    const double exponent =
        l == 0 ? -hydrostatic_constant_k_per_m / t : -1 - hydrostatic_constant_k_per_m / l;
    layers.layer[i] = {base[i] * 1e3, ratio, l / t, exponent};
    layers.top_geometric_m[i] = geometric(base[i + 1] * 1e3);
    ratio = along_geopotential(layers.layer[i], (base[i + 1] - base[i]) * 1e3).value;
  }
  return layers;
}

const Layers layers = standard_layers();

const Layer* layer_at(double altitude_m) {
  for (std::size_t i = 0; i < layer_count; ++i)
    if (altitude_m < layers.top_geometric_m[i]) return &layers.layer[i];
  return nullptr;
}

}  // namespace

double density_ratio_us_1976(double altitude_m) {
  return density_ratio_and_slope_us_1976(altitude_m).value;
}

ValueAndSlope density_ratio_and_slope_us_1976(double altitude_m) {
  const Layer* layer = layer_at(altitude_m);
  if (!layer) return {0, 0};
  const double stretch = geopotential_radius_m / (geopotential_radius_m + altitude_m);
  const auto ratio = along_geopotential(*layer, stretch * altitude_m - layer->base_m);
  return {ratio.value, ratio.slope_per_m * stretch * stretch};
}

std::span<const double> density_breaks_us_1976_m() { return layers.top_geometric_m; }

double density_ratio_yapo_cutler(double altitude_m) {
  return density_ratio_and_slope_yapo_cutler(altitude_m).value;
}

ValueAndSlope density_ratio_and_slope_yapo_cutler(double altitude_m) {
  if (altitude_m >= taper_top_m) return {0, 0};
  const auto ratio = density_ratio_and_slope_us_1976(altitude_m);
  if (altitude_m <= taper_bottom_m) return ratio;
  const double width = taper_top_m - taper_bottom_m, left = (taper_top_m - altitude_m) / width;
  return {ratio.value * left, ratio.slope_per_m * left - ratio.value / width};
}

std::span<const double> density_breaks_m() {
  static const std::array breaks{layers.top_geometric_m[0], layers.top_geometric_m[1],
                                 layers.top_geometric_m[2], taper_bottom_m, taper_top_m};
  return breaks;
}

}  // namespace coppermoon::atmosphere
