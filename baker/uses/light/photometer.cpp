// SPDX-License-Identifier: MIT
#include "uses/light/photometer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "algebra/interpolation.h"
#include "algebra/table.h"
#include "colour/cie_observer.h"
#include "light/tables.h"
#include "photons/solar_disc.h"
#include "surface/albedo_map.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses {
namespace {

/// Responses of the photometer's channels: the photometric bands, then luminance.
algebra::Grid<double> responses() {
  const auto edges = band_edges_nm();
  const auto bands = photometric_response(edges), xyz = colour::xyz_weights(edges);
  algebra::Grid<double> all(bands.rows() + 1, bands.columns());
  for (std::size_t b = 0; b < all.columns(); ++b) {
    for (std::size_t k = 0; k < bands.rows(); ++k) all(k, b) = bands(k, b);
    all(bands.rows(), b) = xyz(1, b);
  }
  return all;
}

/// Irradiance from the Sun at 1 au in each channel.
std::vector<double> sunlight_in(const algebra::Grid<double>& response) {
  const auto sunlight = photons::solar_irradiance(band_edges_nm());
  std::vector<double> sums(response.rows());
  for (std::size_t k = 0; k < response.rows(); ++k)
    for (std::size_t b = 0; b < sunlight.size(); ++b) sums[k] += response(k, b) * sunlight[b];
  return sums;
}

/// Calls `add(row, column, solid angle)` for every texel that is visible from a place.
void for_each_seen(std::size_t rows, const almanac::SkyState& sky, const glm::dvec3& from_m,
                   const std::function<void(std::size_t, std::size_t, double)>& add) {
  const glm::dmat3 gcrs_from_selenographic = glm::transpose(sky.selenographic_from_gcrs);
  const double radius = algebra::in_metres(almanac::lunar_radius);
  const double step = std::numbers::pi / static_cast<double>(rows);
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < 2 * rows; ++c) {
      const auto at = surface::texel_centre(r, c, rows);
      const double latitude = algebra::in_radians(at.latitude);
      const glm::dvec3 normal = gcrs_from_selenographic * almanac::selenographic_direction(at);
      const glm::dvec3 place = sky.moon_m - from_m + radius * normal;
      const double distance = glm::length(place),
                   cos_emission = -glm::dot(normal, place) / distance;
      const double area =
          radius * radius * step * (std::sin(latitude + step / 2) - std::sin(latitude - step / 2));
      if (cos_emission > 0) add(r, c, cos_emission * area / (distance * distance));
    }
}

}  // namespace

Photometer photometer(const std::optional<atmosphere::Sightline>& sightline) {
  const auto response = responses();
  Photometer photometer{{}, moonlight_weights(response, sightline), sunlight_in(response)};
  for (const auto& band : photometric_bands()) photometer.channels.push_back(band.name);
  photometer.channels.emplace_back("Y");
  return photometer;
}

DiscBrightness measured(const Photometer& photometer, const texture::Image& texture,
                        const almanac::SkyState& sky, const glm::dvec3& from_m) {
  const auto moon = irradiance_of_disc(texture, sky, from_m);
  DiscBrightness disc{
      {}, moon.back() / solid_angle_of_disc(texture.height, sky, from_m), moon.back()};
  const auto bands = photometric_bands();
  for (std::size_t k = 0; k < bands.size(); ++k)
    disc.magnitudes.push_back(bands[k].solar_magnitude -
                              2.5 * std::log10(moon[k] / photometer.sunlight[k]));
  return disc;
}

std::vector<PhotometricBand> photometric_bands() {
  constexpr double v = -26.76, b_minus_v = 0.653, v_minus_r = 0.356;
  return {{"B", v + b_minus_v}, {"V", v}, {"R", v - v_minus_r}};
}

algebra::ByName<double> by_band(const std::vector<double>& numbers) {
  const auto bands = photometric_bands();
  algebra::ByName<double> named;
  for (std::size_t k = 0; k < numbers.size(); ++k) named.emplace_back(bands[k].name, numbers[k]);
  return named;
}

algebra::Grid<double> photometric_response(std::span<const double> edges_nm) {
  const auto table = algebra::parse_table(light::tables::johnson_cousins_bessell_1990(),
                                          "johnson_cousins_bessell_1990.csv");
  const auto bands = photometric_bands();
  algebra::Grid<double> response(bands.size(), edges_nm.size() - 1);
  for (std::size_t b = 0; b < bands.size(); ++b)
    for (std::size_t w = 0; w + 1 < edges_nm.size(); ++w)
      response(b, w) = algebra::mean_between(table["wavelength_nm"], table[bands[b].name],
                                             edges_nm[w], edges_nm[w + 1]) *
                       (edges_nm[w + 1] - edges_nm[w]);
  return response;
}

std::vector<double> irradiance_of_disc(const texture::Image& texture, const almanac::SkyState& sky,
                                       const glm::dvec3& from_m) {
  std::vector<double> sums(texture.channels.size());
  for_each_seen(texture.height, sky, from_m, [&](std::size_t r, std::size_t c, double solid_angle) {
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += solid_angle * texture(r, c, k);
  });
  return sums;
}

double solid_angle_of_disc(std::size_t rows, const almanac::SkyState& sky,
                           const glm::dvec3& from_m) {
  double sum = 0;
  for_each_seen(rows, sky, from_m,
                [&](std::size_t, std::size_t, double solid_angle) { sum += solid_angle; });
  return sum;
}

double danjon_estimate(double visual_magnitude) {
  const double root = std::sqrt(std::max(0., 4.8 + visual_magnitude));
  return std::clamp(6 - 2 * root, 0., 4.);
}

}  // namespace coppermoon::uses
