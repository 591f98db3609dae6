// SPDX-License-Identifier: MIT
#include "uses/picture/scattered_colour.h"

#include <cmath>
#include <numbers>

#include "atmosphere/sky_luminance.h"
#include "colour/working_space.h"
#include "photons/solar_disc.h"
#include "uses/light/photometric_bands.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses {
namespace {

struct Bands {
  std::vector<double> centres_nm, sunlight;
  algebra::Grid<double> channels;  ///< [channel][band]
};

Bands made_bands() {
  constexpr double first_nm = 380, last_nm = 780, width_nm = 10;
  std::vector<double> edges;
  for (double edge = first_nm; edge <= last_nm; edge += width_nm) edges.push_back(edge);
  Bands bands{{}, photons::solar_irradiance(edges), colour::channel_weights(picture_space, edges)};
  for (std::size_t b = 0; b + 1 < edges.size(); ++b)
    bands.centres_nm.push_back((edges[b] + edges[b + 1]) / 2);
  return bands;
}

const Bands& bands() {
  static const Bands all = made_bands();
  return all;
}

Rgb channels_of(const std::vector<double>& spectrum) {
  Rgb light{};
  for (std::size_t k = 0; k < light.size(); ++k)
    for (std::size_t b = 0; b < spectrum.size(); ++b)
      light[k] += bands().channels(k, b) * spectrum[b];
  into_gamut_or_black(picture_space, light);
  return light;
}

}  // namespace

std::vector<double> spectrum_of(const ColourIndices& colour) {
  constexpr double b_nm = 440, v_nm = 550, r_nm = 641;
  const auto sun = photometric_bands();
  const double in_b = colour.b_minus_v - (sun[0].solar_magnitude - sun[1].solar_magnitude),
               in_r = sun[1].solar_magnitude - sun[2].solar_magnitude - colour.v_minus_r;
  auto spectrum = bands().sunlight;
  for (std::size_t b = 0; b < spectrum.size(); ++b) {
    const double away_nm = bands().centres_nm[b] - v_nm;
    const double magnitude =
        away_nm < 0 ? in_b * away_nm / (b_nm - v_nm) : in_r * away_nm / (r_nm - v_nm);
    spectrum[b] *= std::pow(10, -0.4 * magnitude);
  }
  return spectrum;
}

ColourIndices sunlight_colour() {
  const auto sun = photometric_bands();
  return {sun[0].solar_magnitude - sun[1].solar_magnitude,
          sun[1].solar_magnitude - sun[2].solar_magnitude};
}

Rgb normalised(Rgb light) {
  if (const double y = colour::luminance(picture_space, light); y > 0)
    for (double& channel : light) channel /= y;
  return light;
}

Rgb colour_of(const std::vector<double>& spectrum) { return normalised(channels_of(spectrum)); }

std::vector<atmosphere::VerticalDepths> band_depths(const atmosphere::ObserverAir& air) {
  std::vector<atmosphere::VerticalDepths> all;
  for (const double nm : bands().centres_nm)
    all.push_back(atmosphere::vertical_depths(air, algebra::nanometres(nm)));
  return all;
}

ScatteredColour::ScatteredColour(const atmosphere::ObserverAir& air, const ColourIndices& body,
                                 algebra::Angle altitude) {
  const auto spectrum = spectrum_of(body);
  const auto extinction_mag = [](const atmosphere::VerticalDepths& depths) {
    return 2.5 * std::numbers::log10e * (depths.rayleigh + depths.ozone + depths.aerosol);
  };
  constexpr double v_nm = 550;
  const auto in_v = atmosphere::vertical_depths(air, algebra::nanometres(v_nm));
  const auto all_depths = band_depths(air);
  const double of_body = atmosphere::sky_air_mass(altitude);
  for (std::size_t b = 0; b < spectrum.size(); ++b) {
    const double wavelength_nm = bands().centres_nm[b];
    const auto& depths = all_depths[b];
    const double k = extinction_mag(depths);
    const double light = spectrum[b] * extinction_mag(in_v) / k * std::pow(10, -0.4 * k * of_body);
    extinction_mag_.push_back(k);
    of_molecules_.push_back(light * depths.rayleigh / in_v.rayleigh);
    of_aerosol_.push_back(light * std::pow(wavelength_nm / v_nm, -air.angstrom_exponent));
  }
}

ScatteredColour::Pair ScatteredColour::along(algebra::Angle altitude) const {
  const double air_mass = atmosphere::sky_air_mass(altitude);
  auto molecules = of_molecules_, aerosol = of_aerosol_;
  for (std::size_t b = 0; b < extinction_mag_.size(); ++b) {
    const double scattered = 1 - std::pow(10, -0.4 * extinction_mag_[b] * air_mass);
    molecules[b] *= scattered;
    aerosol[b] *= scattered;
  }
  return {channels_of(molecules), channels_of(aerosol)};
}

}  // namespace coppermoon::uses
