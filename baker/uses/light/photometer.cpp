// SPDX-License-Identifier: MIT
#include "uses/light/photometer.h"

#include <cmath>

#include "colour/cie_observer.h"
#include "photons/solar_disc.h"
#include "uses/light/disc_brightness.h"
#include "uses/light/photometric_bands.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses {
namespace {

/// Channels: the photometric bands, then luminance.
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

/// Irradiance of the Sun at 1 au in each channel.
std::vector<double> sunlight_in(const algebra::Grid<double>& response) {
  const auto sunlight = photons::solar_irradiance(band_edges_nm());
  std::vector<double> sums(response.rows());
  for (std::size_t k = 0; k < response.rows(); ++k)
    for (std::size_t b = 0; b < sunlight.size(); ++b) sums[k] += response(k, b) * sunlight[b];
  return sums;
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

}  // namespace coppermoon::uses
