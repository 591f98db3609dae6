// SPDX-License-Identifier: MIT
#include "photons/limb_darkening.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "algebra/error.h"
#include "algebra/interpolation.h"
#include "algebra/quadrature.h"
#include "algebra/table.h"
#include "atmosphere/refractivity.h"
#include "photons/tables.h"

namespace coppermoon::photons {
namespace {

constexpr int layers_inside = 32;

DiscFunction over_mean(DiscFunction a) {
  double mean = 0;
  // FAULT the Sun's disc 1 % too dark: mean += 2 * a[k] => mean += 2.02 * a[k]
  for (std::size_t k = 0; k < a.size(); ++k) mean += 2 * a[k] / static_cast<double>(k + 2);
  for (double& a_k : a) a_k /= mean;
  return a;
}

DiscFunction coefficients(double nm) {
  static const auto table =
      algebra::parse_table(tables::solar_limb_darkening(), "solar_limb_darkening.csv");
  algebra::require_within("wavelength [nm]", nm, atmosphere::shortest_nm, atmosphere::longest_nm);
  constexpr std::array columns{"A0", "A1", "A2", "A3", "A4", "A5"};
  DiscFunction a;
  for (std::size_t k = 0; k < a.size(); ++k)
    a[k] = algebra::interpolated(table["wavelength_nm"], table[columns[k]], nm);
  return over_mean(a);
}

double slope(const DiscFunction& a, double mu) {
  double sum = 0;
  for (std::size_t k = a.size(); k-- > 1;) sum = sum * mu + static_cast<double>(k) * a[k];
  return sum;
}

/// Mean, over the Sun's disc, of the product of two functions of the cosine μ of the emission angle: 2 ∫ f g μ dμ.
double mean_product(const DiscFunction& f, const DiscFunction& g) {
  double sum = 0;
  for (const auto& node : algebra::gauss_legendre(8)) {
    const double mu = (1 + node.x) / 2;
    sum += node.weight * mu * value(f, mu) * value(g, mu);
  }
  return sum;
}

void subtract(double times, const DiscFunction& f, DiscFunction& from) {
  for (std::size_t k = 0; k < f.size(); ++k) from[k] -= times * f[k];
}

}  // namespace

double value(const DiscFunction& function, double cos_angle) {
  double sum = 0;
  for (std::size_t k = function.size(); k-- > 0;) sum = sum * cos_angle + function[k];
  return sum;
}

double limb_darkening(algebra::Wavelength wavelength, double cos_angle) {
  algebra::require_within("cosine of the angle on the Sun", cos_angle, 0, 1);
  return value(coefficients(algebra::in_nanometres(wavelength)), cos_angle);
}

DiscLayers disc_layers(std::span<const double> wavelengths_nm, bool limb_darkened) {
  if (!limb_darkened) return {{1}, {1, wavelengths_nm.size(), 1}};
  DiscLayers layers{{1}, {1 + layers_inside, wavelengths_nm.size()}};
  const auto nodes = algebra::gauss_legendre(layers_inside);
  for (const auto& node : nodes)
    layers.radius.push_back(std::sqrt(1 - std::pow((1 + node.x) / 2, 2)));
  for (std::size_t w = 0; w < wavelengths_nm.size(); ++w) {
    const auto a = coefficients(wavelengths_nm[w]);
    layers.brightness(0, w) = a[0];
    for (std::size_t i = 0; i < nodes.size(); ++i)
      // FAULT layers of the Sun's disc in the wrong order: 1 + nodes[i].x => 1 - nodes[i].x
      layers.brightness(i + 1, w) = nodes[i].weight / 2 * slope(a, (1 + nodes[i].x) / 2);
  }
  return layers;
}

DiscTerms disc_terms(std::span<const double> wavelengths_nm, bool limb_darkened, int count) {
  const std::size_t waves = wavelengths_nm.size();
  if (!limb_darkened || waves == 0) return {{{1}}, {1, waves, 1}};
  algebra::require_within("terms of the Sun's disc", count, 1, 6);
  std::vector<DiscFunction> left;
  for (const double nm : wavelengths_nm) left.push_back(coefficients(nm));
  DiscTerms terms{{left[waves / 2]}, {static_cast<std::size_t>(count), waves}};
  for (std::size_t w = 0; w < waves; ++w) {
    terms.brightness(0, w) = 1;
    subtract(1, terms.functions[0], left[w]);
  }
  for (std::size_t j = 1; j < terms.brightness.rows(); ++j) {
    const auto worst =
        std::ranges::max(left, {}, [](const DiscFunction& f) { return mean_product(f, f); });
    const double size = std::sqrt(mean_product(worst, worst));
    auto& function = terms.functions.emplace_back();
    if (size < 1e-12) continue;  // earlier terms already represent every wavelength
    subtract(-1 / size, worst, function);
    for (std::size_t w = 0; w < waves; ++w) {
      terms.brightness(j, w) = mean_product(left[w], function);
      subtract(terms.brightness(j, w), function, left[w]);
    }
  }
  return terms;
}

}  // namespace coppermoon::photons
