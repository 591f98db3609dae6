// SPDX-License-Identifier: MIT
#include "uses/picture/twilight_colour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>

namespace coppermoon::uses {
namespace {

using std::numbers::pi;

constexpr std::array altitudes_deg{2., 4., 7., 11., 16., 23., 32., 45., 65., 90.};
constexpr std::size_t azimuths = 25;  ///< from the Sun's to the opposite one
constexpr double earth_km = 6371, top_km = 100;

/// Molecules, ozone and aerosol at a height, or along a path, over those of a vertical column.
struct Amounts {
  double molecules = 0, ozone = 0, aerosol = 0;

  void add(const Amounts& more, double km) {
    molecules += km * more.molecules;
    ozone += km * more.ozone;
    aerosol += km * more.aerosol;
  }
};

/// Shares of the vertical column in a kilometre: scale heights of 8 and 1.5 km, ozone about 22 km.
Amounts at_height(double km) {
  const double off = (km - 22) / 5;
  return {std::exp(-km / 8) / 8, std::exp(-off * off / 2) / (5 * std::sqrt(2 * pi)),
          std::exp(-km / 1.5) / 1.5};
}

double height_km(const glm::dvec3& place) { return glm::length(place) - earth_km; }

/// Length of a straight path from a place to the top of the air.
double way_out_km(const glm::dvec3& place, const glm::dvec3& direction) {
  const double along = glm::dot(place, direction), radius = earth_km + top_km;
  return -along + std::sqrt(along * along - glm::dot(place, place) + radius * radius);
}

/// Whether the Sun shines on a place.
///
/// Given  before  gets the air between the two
bool lit(const glm::dvec3& place, const glm::dvec3& sun, Amounts& before) {
  const double along = glm::dot(place, sun);
  if (along < 0 && glm::length(place - along * sun) < earth_km) return false;
  constexpr int steps = 40;
  const double way = way_out_km(place, sun), step = way / steps;
  for (int k = 0; k < steps; ++k)
    before.add(at_height(std::max(0., height_km(place + (k + 0.5) * step * sun))), step);
  return true;
}

}  // namespace

TwilightColour::TwilightColour(const atmosphere::ObserverAir& air, algebra::Angle sun_altitude)
    : colours_(altitudes_deg.size(), azimuths) {
  const auto sunlight = spectrum_of(sunlight_colour());
  const auto depths = band_depths(air);
  const double s = algebra::in_radians(sun_altitude);
  const glm::dvec3 sun(std::cos(s), 0, std::sin(s)), eye(0, 0, earth_km);
  std::array<Amounts, altitudes_deg.size()> slant{};  // along each whole line of sight
  algebra::Grid<std::vector<double>> spectra(altitudes_deg.size(), azimuths);
  std::vector<double> mean(sunlight.size());
  for (std::size_t r = 0; r < altitudes_deg.size(); ++r)
    for (std::size_t c = 0; c < azimuths; ++c) {
      const double a = altitudes_deg[r] * pi / 180,
                   b = static_cast<double>(c) * pi / (azimuths - 1);
      const glm::dvec3 view(std::cos(a) * std::cos(b), std::cos(a) * std::sin(b), std::sin(a));
      const double cosine = glm::dot(view, sun), g = 0.7;
      const double by_molecules = 0.75 * (1 + cosine * cosine),
                   by_aerosol = (1 - g * g) / std::pow(1 + g * g - 2 * g * cosine, 1.5);
      auto& spectrum = spectra(r, c) = std::vector<double>(sunlight.size());
      constexpr int steps = 80;
      const double way = way_out_km(eye, view);
      Amounts after;
      for (int k = 0; k < steps; ++k) {
        // steps that grow, as the air thins along the way
        const double from = way * std::pow(double(k) / steps, 2),
                     step = way * std::pow((k + 1.) / steps, 2) - from;
        const glm::dvec3 place = eye + (from + step / 2) * view;
        const auto here = at_height(std::max(0., height_km(place)));
        after.add(here, step / 2);
        Amounts all = after;
        if (lit(place, sun, all))
          for (std::size_t w = 0; w < spectrum.size(); ++w) {
            const auto& [rayleigh, ozone, aerosol] = depths[w];
            spectrum[w] +=
                step * sunlight[w] *
                (here.molecules * rayleigh * by_molecules + here.aerosol * aerosol * by_aerosol) *
                std::exp(-all.molecules * rayleigh - all.ozone * ozone - all.aerosol * aerosol);
          }
        after.add(here, step / 2);
      }
      slant[r] = after;
      const double weight = std::sin(2 * a) + 1e-3;
      for (std::size_t w = 0; w < mean.size(); ++w) mean[w] += weight * spectrum[w];
    }
  double sum = 0, weights = 0;
  for (const double altitude : altitudes_deg)
    weights += azimuths * (std::sin(altitude * pi / 90) + 1e-3);
  for (double& light : mean) sum += light /= weights;
  const auto& middle = depths[depths.size() / 2];
  const double overhead_share = 1 - std::exp(-middle.rayleigh - middle.ozone - middle.aerosol);
  const ScatteredColour overhead(air, sunlight_colour(), algebra::degrees(90));
  for (std::size_t r = 0; r < altitudes_deg.size(); ++r)
    for (std::size_t c = 0; c < azimuths; ++c) {
      auto& spectrum = spectra(r, c);
      constexpr double again = 0.2;
      for (std::size_t w = 0; w < spectrum.size(); ++w) {
        const auto& [rayleigh, ozone, aerosol] = depths[w];
        const double along =
            slant[r].molecules * rayleigh + slant[r].ozone * ozone + slant[r].aerosol * aerosol;
        spectrum[w] += again * mean[w] * rayleigh / (rayleigh + ozone + aerosol) *
                       (1 - std::exp(-along)) / overhead_share;
      }
      colours_(r, c) = sum > 0 ? colour_of(spectrum)
                               : normalised(overhead.along(algebra::degrees(90)).molecules);
    }
}

Rgb TwilightColour::towards(algebra::Angle altitude, algebra::Angle aside) const {
  const double degrees = std::clamp(algebra::in_degrees(altitude), altitudes_deg.front(), 90.);
  const auto upper = std::min<std::size_t>(
      static_cast<std::size_t>(std::ranges::upper_bound(altitudes_deg, degrees) -
                               altitudes_deg.begin()),
      altitudes_deg.size() - 1);
  const double up =
      (degrees - altitudes_deg[upper - 1]) / (altitudes_deg[upper] - altitudes_deg[upper - 1]);
  const double around =
      std::abs(std::remainder(algebra::in_radians(aside), 2 * pi)) / pi * (azimuths - 1);
  const auto left = std::min(static_cast<std::size_t>(around), azimuths - 2);
  const double right = around - static_cast<double>(left);
  Rgb light{};
  for (std::size_t k = 0; k < light.size(); ++k)
    light[k] =
        std::lerp(std::lerp(colours_(upper - 1, left)[k], colours_(upper - 1, left + 1)[k], right),
                  std::lerp(colours_(upper, left)[k], colours_(upper, left + 1)[k], right), up);
  return light;
}

}  // namespace coppermoon::uses
