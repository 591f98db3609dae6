// SPDX-License-Identifier: MIT
#include "uses/light/spectral_bands.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "algebra/error.h"
#include "algebra/interpolation.h"
#include "colour/cie_observer.h"
#include "photons/solar_disc.h"
#include "surface/ground.h"
#include "surface/reflectance.h"

namespace coppermoon::uses {
namespace {

constexpr int bands = 400;
constexpr double first_nm = 380, width_of_band_nm = 1;

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

/// Mean of surface::colour_spectrum, weighted by moonlight and the eye's response.
double mean_colour() {
  const auto xyz = colour::xyz_weights(band_edges_nm());
  const auto all = moonlight_weights(xyz);
  const auto centres = band_centres_nm();
  double sum = 0, light = 0;
  for (std::size_t b = 0; b < centres.size(); ++b) {
    sum += all(1, b) * surface::colour_spectrum(algebra::nanometres(centres[b]));
    light += all(1, b);
  }
  return sum / light;
}

double transmittance(const std::optional<atmosphere::Sightline>& sightline, double wavelength_nm) {
  if (!sightline) return 1;
  return atmosphere::transmittance_above(sightline->air, sightline->altitude,
                                         algebra::nanometres(wavelength_nm));
}

}  // namespace

std::vector<double> band_edges_nm() {
  std::vector<double> edges;
  for (int i = 0; i <= bands; ++i) edges.push_back(first_nm + width_of_band_nm * i);
  return edges;
}

std::vector<double> band_centres_nm() {
  std::vector<double> centres;
  for (int i = 0; i < bands; ++i) centres.push_back(first_nm + width_of_band_nm * (i + 0.5));
  return centres;
}

BroadBands broad_bands(double width_nm) {
  constexpr double last_nm = first_nm + bands * width_of_band_nm;
  BroadBands all;
  for (double edge = first_nm; edge <= last_nm; edge += width_nm) all.edges_nm.push_back(edge);
  for (std::size_t b = 0; b + 1 < all.edges_nm.size(); ++b)
    all.centres_nm.push_back((all.edges_nm[b] + all.edges_nm[b + 1]) / 2);
  all.sunlight = photons::solar_irradiance(all.edges_nm);
  all.channels = colour::channel_weights(picture_space, all.edges_nm);
  return all;
}

std::vector<double> wavelengths_nm(int count) {
  algebra::require_within("wavelengths", count, 1, bands);
  std::vector<double> middles;
  for (int i = 0; i < count; ++i)
    middles.push_back(first_nm + bands * width_of_band_nm * (i + 0.5) / count);
  return middles;
}

algebra::Grid<double> at_wavelengths(const algebra::Grid<double>& weights, int count) {
  const int points = std::min(4, count);
  algebra::Grid<double> nodes(weights.rows(), static_cast<std::size_t>(count));
  for (int b = 0; b < bands; ++b) {
    const double place = (b + 0.5) * count / bands - 0.5;
    const int first =
        std::clamp(static_cast<int>(std::floor(place)) - (points / 2 - 1), 0, count - points);
    std::vector<double> around(static_cast<std::size_t>(points));
    std::iota(around.begin(), around.end(), first);
    const auto shares = algebra::on_polynomial(around, place);
    for (std::size_t i = 0; i < shares.size(); ++i)
      for (std::size_t c = 0; c < weights.rows(); ++c)
        nodes(c, static_cast<std::size_t>(first) + i) +=
            shares[i] * weights(c, static_cast<std::size_t>(b));
  }
  return nodes;
}

void into_gamut_or_black(colour::WorkingSpace space, std::span<double> channels) {
  if (colour::luminance(space, channels) < 0)
    std::ranges::fill(channels, 0);
  else
    colour::into_gamut(space, channels);
}

algebra::Grid<double> white_ground_weights(const algebra::Grid<double>& response,
                                           const std::optional<atmosphere::Sightline>& sightline) {
  const auto sunlight = photons::solar_irradiance(band_edges_nm());
  const auto centres = band_centres_nm();
  algebra::Grid<double> weights = response;
  for (std::size_t b = 0; b < centres.size(); ++b) {
    const double seen = sunlight[b] / std::numbers::pi * transmittance(sightline, centres[b]);
    for (std::size_t c = 0; c < weights.rows(); ++c) weights(c, b) *= seen;
  }
  return weights;
}

algebra::Grid<double> moonlight_weights(const algebra::Grid<double>& response,
                                        const std::optional<atmosphere::Sightline>& sightline) {
  const auto reflectance = lunar_reflectance();
  auto weights = white_ground_weights(response, sightline);
  for (std::size_t c = 0; c < weights.rows(); ++c)
    for (std::size_t b = 0; b < weights.columns(); ++b) weights(c, b) *= reflectance[b];
  return weights;
}

double colour_at(double wavelength_nm) {
  static const double mean = mean_colour();
  return surface::colour_spectrum(algebra::nanometres(wavelength_nm)) - mean;
}

algebra::Grid<double> reddest_and_bluest(const algebra::Grid<double>& weights,
                                         std::span<const double> at_nm) {
  const std::size_t channels = weights.rows();
  algebra::Grid<double> both(2 * channels, weights.columns());
  for (std::size_t w = 0; w < weights.columns(); ++w) {
    const double change = surface::strongest_colour * colour_at(at_nm[w]);
    for (std::size_t c = 0; c < channels; ++c) {
      both(c, w) = weights(c, w) * (1 - change);
      both(channels + c, w) = weights(c, w) * (1 + change);
    }
  }
  return both;
}

}  // namespace coppermoon::uses
