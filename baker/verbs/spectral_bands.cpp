// SPDX-License-Identifier: MIT
#include "verbs/spectral_bands.h"

#include <numbers>

#include "colour/cie_observer.h"
#include "photons/solar_disc.h"
#include "surface/reflectance.h"

namespace coppermoon::verbs {
namespace {

constexpr int bands = 200;
constexpr double first_nm = 380, width_nm = 2;

std::vector<double> lunar_reflectance() {
  const auto xyz = colour::xyz_weights(band_edges_nm());
  const auto luminance = xyz.row(1);
  std::vector<double> reflectance;
  const auto sunlight = photons::solar_irradiance(band_edges_nm());
  const auto centres = band_centres_nm();
  double seen = 0, light = 0;
  for (std::size_t b = 0; b < centres.size(); ++b) {
    reflectance.push_back(surface::lunar_reflectance_yapo_cutler(algebra::nanometres(centres[b])));
    seen += luminance[b] * sunlight[b] * reflectance[b];
    light += luminance[b] * sunlight[b];
  }
  for (double& r : reflectance) r *= light / seen;
  return reflectance;
}

double transmittance(const std::optional<atmosphere::Sightline>& sightline, double wavelength_nm) {
  if (!sightline) return 1;
  return atmosphere::transmittance_above(sightline->air, sightline->altitude,
                                         algebra::nanometres(wavelength_nm));
}

}  // namespace

std::vector<double> band_edges_nm() {
  std::vector<double> edges;
  for (int i = 0; i <= bands; ++i) edges.push_back(first_nm + width_nm * i);
  return edges;
}

std::vector<double> band_centres_nm() {
  std::vector<double> centres;
  for (int i = 0; i < bands; ++i) centres.push_back(first_nm + width_nm * (i + 0.5));
  return centres;
}

algebra::Grid<double> moonlight_weights(const algebra::Grid<double>& response,
                                        const std::optional<atmosphere::Sightline>& sightline) {
  const auto sunlight = photons::solar_irradiance(band_edges_nm());
  const auto centres = band_centres_nm();
  const auto reflectance = lunar_reflectance();
  algebra::Grid<double> weights = response;
  for (std::size_t b = 0; b < centres.size(); ++b) {
    const double air = transmittance(sightline, centres[b]);
    for (std::size_t c = 0; c < weights.rows(); ++c)
      weights(c, b) *= sunlight[b] * reflectance[b] / std::numbers::pi * air;
  }
  return weights;
}

}  // namespace coppermoon::verbs
