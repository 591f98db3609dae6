// SPDX-License-Identifier: MIT
#include "uses/picture/star_light.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "algebra/grid.h"
#include "colour/working_space.h"
#include "photons/solar_disc.h"
#include "uses/light/photometric_bands.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses {
namespace {

/// Bands of 5 nm, in which air and black bodies change little.
struct Bands {
  std::vector<double> centres_nm, v;         ///< v: response of the V band, [band]
  algebra::Grid<double> channels;            ///< of the CIE observer, [channel][band]
  double solar_magnitude = 0, sunlight = 0;  ///< the Sun's in V
};

std::vector<double> edges_of_bands() {
  constexpr double first_nm = 380, last_nm = 780, width_nm = 5;
  std::vector<double> edges;
  for (double edge = first_nm; edge <= last_nm; edge += width_nm) edges.push_back(edge);
  return edges;
}

Bands made_bands() {
  const auto edges = edges_of_bands();
  Bands bands;
  for (std::size_t b = 0; b + 1 < edges.size(); ++b)
    bands.centres_nm.push_back((edges[b] + edges[b + 1]) / 2);
  const auto photometric = photometric_bands();
  const auto v = static_cast<std::size_t>(
      std::ranges::find(photometric, "V", &PhotometricBand::name) - photometric.begin());
  const auto response = photometric_response(edges);
  const auto sun = photons::solar_irradiance(edges);
  for (std::size_t b = 0; b < bands.centres_nm.size(); ++b) {
    bands.v.push_back(response(v, b));
    bands.sunlight += response(v, b) * sun[b];
  }
  bands.channels = colour::channel_weights(picture_space, edges);
  bands.solar_magnitude = photometric[v].solar_magnitude;
  return bands;
}

const Bands& bands_of_light() {
  static const Bands bands = made_bands();
  return bands;
}

/// Planck's law, of any scale.
double black_body(double wavelength_nm, double temperature_k) {
  constexpr double second_radiation_nm_k = 1.438776877e7;  // CODATA 2018, hc/k
  return std::pow(wavelength_nm, -5) /
         std::expm1(second_radiation_nm_k / (wavelength_nm * temperature_k));
}

}  // namespace

double star_temperature_k(double b_minus_v) {
  const double colour = 0.92 * std::clamp(b_minus_v, -0.5, 4.);
  return 4600 * (1 / (colour + 1.7) + 1 / (colour + 0.62));
}

StarLights::StarLights(const std::optional<atmosphere::ObserverAir>& air,
                       const std::string& response)
    : channels_(response.empty()
                    ? bands_of_light().channels
                    : colour::channel_weights(picture_space, edges_of_bands(), response)) {
  if (!air) return;
  for (const double centre : bands_of_light().centres_nm)
    depths_.push_back(atmosphere::vertical_depths(*air, algebra::nanometres(centre)));
}

std::array<double, 3> StarLights::lux(double magnitude, double b_minus_v,
                                      algebra::Angle altitude) const {
  const Bands& bands = bands_of_light();
  const double temperature_k = star_temperature_k(b_minus_v);
  double in_v = 0;
  std::array<double, 3> light{};
  for (std::size_t b = 0; b < bands.centres_nm.size(); ++b) {
    const double above = black_body(bands.centres_nm[b], temperature_k);
    in_v += bands.v[b] * above;
    const double seen =
        depths_.empty() ? above : above * atmosphere::transmittance_above(depths_[b], altitude);
    for (std::size_t k = 0; k < 3; ++k) light[k] += channels_(k, b) * seen;
  }
  const double scale =
      bands.sunlight / in_v * std::pow(10, -0.4 * (magnitude - bands.solar_magnitude));
  for (double& channel : light) channel *= scale;
  into_gamut_or_black(picture_space, light);
  return light;
}

}  // namespace coppermoon::uses
