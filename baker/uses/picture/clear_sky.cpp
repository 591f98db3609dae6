// SPDX-License-Identifier: MIT
#include "uses/picture/clear_sky.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numbers>

#include "colour/working_space.h"
#include "uses/light/photometer.h"
#include "uses/light/spectral_bands.h"
#include "uses/picture/view.h"

namespace coppermoon::uses {
namespace {

algebra::Angle altitude_of(const glm::dvec3& direction) {
  return algebra::radians(std::asin(std::clamp(direction.z, -1., 1.)));
}

algebra::Angle between(const glm::dvec3& a, const glm::dvec3& b) {
  return algebra::radians(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

glm::dvec3 sun_in_sky(const almanac::ObserverView& view, const almanac::SkyState& sky) {
  const auto sun = glm::normalize(sky.sun_m - view.position_m),
             east = glm::normalize(glm::cross(view.north, view.zenith));
  return {glm::dot(sun, east), glm::dot(sun, glm::cross(view.zenith, east)),
          glm::dot(sun, view.zenith)};
}

/// The Sun's altitude, but at most 5 degrees, because the daytime sky is modelled as bright twilight.
algebra::Angle of_twilight(algebra::Angle sun_altitude) {
  return std::min(sun_altitude, algebra::degrees(5));
}

constexpr std::size_t altitude_steps = 180;

const BroadBands& bands() {
  static const auto all = broad_bands(10);
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

ClearSky::ClearSky(const almanac::Observer& place, const almanac::SkyState& sky,
                   const atmosphere::ObserverAir& air, std::span<const double> moon_magnitudes)
    : extinction_mag_(atmosphere::visual_extinction_mag(air)),
      moon_{moon_magnitudes[V_band], almanac::view_from(place, sky).altitude},
      to_sun_(sun_in_sky(almanac::view_from(place, sky), sky)),
      sun_altitude_(altitude_of(to_sun_)),
      twilight_(of_twilight(sun_altitude_), air) {
  const auto seen = apparent_place(place, sky);
  to_moon_ = in_sky(seen.altitude, seen.azimuth);
  const ColourIndices colour{moon_magnitudes[0] - moon_magnitudes[1],
                             moon_magnitudes[1] - moon_magnitudes[2]};
  if (!std::isfinite(colour.b_minus_v + colour.v_minus_r)) return;
  const ScatteredColour scattered(air, colour, seen.altitude);
  for (std::size_t k = 0; k <= altitude_steps; ++k)
    of_moon_.push_back(scattered.along(algebra::degrees(90. * double(k) / altitude_steps)));
}

ClearSky::ClearSky(const almanac::Observer& place, const almanac::SkyState& sky,
                   const atmosphere::ObserverAir& air, double moon_magnitude)
    : ClearSky(place, sky, air,
               std::array{moon_magnitude + 0.91, moon_magnitude, moon_magnitude - 0.56}) {}

Rgb ClearSky::light(const glm::dvec3& direction) const {
  static const auto night = colour_of(spectrum_of({1.03, 0.74}));
  const auto altitude = altitude_of(direction);
  auto light = twilight_towards(direction);
  const double airglow = atmosphere::airglow_cd_m2(altitude, extinction_mag_),
               moonlight = moonlight_towards(direction);
  for (std::size_t k = 0; k < light.size(); ++k) light[k] += airglow * night[k];
  if (!(moonlight > 0) || of_moon_.empty()) return light;
  const double up = std::clamp(algebra::in_degrees(altitude) / 90, 0., 1.) * altitude_steps;
  const auto below = std::min(static_cast<std::size_t>(up), altitude_steps - 1);
  const auto& lower = of_moon_[below];
  const auto& upper = of_moon_[below + 1];
  const auto [molecules, aerosol] = atmosphere::scattering_terms(from_moon(direction));
  Rgb scattered{};
  for (std::size_t k = 0; k < scattered.size(); ++k)
    scattered[k] =
        std::lerp(molecules * lower.molecules[k] + aerosol * lower.aerosol[k],
                  molecules * upper.molecules[k] + aerosol * upper.aerosol[k], up - double(below));
  scattered = normalised(scattered);
  for (std::size_t k = 0; k < light.size(); ++k) light[k] += moonlight * scattered[k];
  return light;
}

SkyTerms ClearSky::towards(const glm::dvec3& direction) const {
  const auto altitude = altitude_of(direction);
  return {atmosphere::airglow_cd_m2(altitude, extinction_mag_),
          colour::luminance(picture_space, twilight_towards(direction)),
          moonlight_towards(direction)};
}

Rgb ClearSky::twilight_towards(const glm::dvec3& direction) const {
  const double azimuth = std::atan2(direction.x, direction.y);
  return twilight_.towards(altitude_of(direction), algebra::radians(azimuth) - sun_azimuth());
}

double ClearSky::moonlight_towards(const glm::dvec3& direction) const {
  return atmosphere::moonlit_sky_cd_m2(moon_, {altitude_of(direction), from_moon(direction)},
                                       extinction_mag_);
}

algebra::Angle ClearSky::from_moon(const glm::dvec3& direction) const {
  return between(direction, to_moon_);
}

glm::dvec3 in_sky(algebra::Angle altitude, algebra::Angle azimuth) {
  const double a = algebra::in_radians(altitude), b = algebra::in_radians(azimuth);
  return {std::cos(a) * std::sin(b), std::cos(a) * std::cos(b), std::sin(a)};
}

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

Rgb normalised(Rgb light) {
  if (const double y = colour::luminance(picture_space, light); y > 0)
    for (double& channel : light) channel /= y;
  return light;
}

Rgb colour_of(const std::vector<double>& spectrum) { return normalised(channels_of(spectrum)); }

ScatteredColour::ScatteredColour(const atmosphere::ObserverAir& air, const ColourIndices& body,
                                 algebra::Angle altitude) {
  const auto spectrum = spectrum_of(body);
  const auto extinction_mag = [](const atmosphere::VerticalDepths& depths) {
    return 2.5 * std::numbers::log10e * (depths.rayleigh + depths.ozone + depths.aerosol);
  };
  constexpr double v_nm = 550;
  const auto in_v = atmosphere::vertical_depths(air, algebra::nanometres(v_nm));
  const double of_body = atmosphere::sky_air_mass(altitude);
  for (std::size_t b = 0; b < spectrum.size(); ++b) {
    const double wavelength_nm = bands().centres_nm[b];
    const auto depths = atmosphere::vertical_depths(air, algebra::nanometres(wavelength_nm));
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
