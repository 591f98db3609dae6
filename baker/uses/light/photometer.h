// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "algebra/described.h"
#include "algebra/grid.h"
#include "almanac/sky.h"
#include "atmosphere/observer_air.h"
#include "texture/image.h"

namespace coppermoon::uses {

/// A band of astronomical photometry.
struct PhotometricBand {
  std::string name;
  double solar_magnitude;  ///< magnitude of the Sun at 1 au
};

/// Index of V among photometric_bands.
inline constexpr std::size_t V_band = 1;

/// The photometric bands B and V (Johnson) and R (Cousins).
///
/// Source  V = −26.76, B − V = 0.653, V − R = 0.356: Ramírez et al. (2012), ApJ 752, 5; Willmer (2018), ApJS 236, 47
std::vector<PhotometricBand> photometric_bands();

/// Numbers keyed by the names of their bands.
///
/// Given  numbers  one for each band; if empty, the result is empty too
algebra::ByName<double> by_band(const std::vector<double>& numbers);

/// Response of the photometric bands to irradiance, [band][wavelength band]. Each response has a peak of 1 and is
/// multiplied by the width of the wavelength band [nm].
///
/// Given  edges_nm  edges of the wavelength bands, from 380 to 780
/// Omits  the part of R beyond 780 nm, which is 6 % of R
/// Source Bessell (1990), PASP 102, 1181
algebra::Grid<double> photometric_response(std::span<const double> edges_nm);

/// Channels of a texture on which the Moon is measured: the photometric bands, and luminance.
struct Photometer {
  std::vector<std::string> channels;
  algebra::Grid<double> weights;  ///< weights for moonlight, [channel][band]
  std::vector<double> sunlight;   ///< the Sun's irradiance at 1 au in each channel
};

/// Given  sightline  line of sight through the air, which dims the Moon; if absent, the Moon is seen from space
Photometer photometer(const std::optional<atmosphere::Sightline>& sightline = {});

/// Brightness of the whole disc.
struct DiscBrightness {
  std::vector<double> magnitudes;  ///< one for each band; infinite if the disc is black
  double mean_luminance_cd_m2 = 0;
  double illuminance_lx = 0;  ///< illuminance on a surface that faces the Moon
};

template <class Field>
void describe_magnitudes(Field&& is, const DiscBrightness& disc) {
  is("magnitudes", by_band(disc.magnitudes), algebra::unit::mag,
     "magnitudes of the whole Moon by band: B and V (Johnson), R (Cousins)");
}

template <class Field>
void describe_light(Field&& is, const DiscBrightness& disc) {
  is("mean_luminance_cd_m2", disc.mean_luminance_cd_m2, algebra::unit::luminance,
     "luminance, the mean over the disc");
  is("illuminance_lx", disc.illuminance_lx, algebra::unit::illuminance,
     "illuminance on a surface that faces the Moon");
}

/// Describes the magnitude in each band under a separate key. `where` is appended to each description.
///
/// Given  disc  nullptr if the numbers are not known
template <class Field>
void describe_magnitude_columns(Field&& is, const DiscBrightness* disc, const std::string& prefix,
                                const std::string& where) {
  const auto bands = photometric_bands();
  for (std::size_t k = 0; k < bands.size(); ++k)
    is(prefix + bands[k].name + "_magnitude",
       disc && k < disc->magnitudes.size() ? std::optional(disc->magnitudes[k]) : std::nullopt,
       algebra::unit::mag, bands[k].name + " magnitude of the whole Moon" + where);
}

/// Describes everything that is measured on a disc, one column for each number.
///
/// Given  disc  nullptr if the numbers are not known
template <class Field>
void describe_columns(Field&& is, const DiscBrightness* disc, const std::string& prefix,
                      const std::string& where) {
  describe_magnitude_columns(is, disc, prefix, where);
  is(prefix + "mean_luminance_cd_m2",
     disc ? std::optional(disc->mean_luminance_cd_m2) : std::nullopt, algebra::unit::luminance,
     "luminance, the mean over the disc" + where);
  is(prefix + "illuminance_lx", disc ? std::optional(disc->illuminance_lx) : std::nullopt,
     algebra::unit::illuminance, "illuminance on a surface that faces the Moon" + where);
}

/// Brightness of the Moon's disc, measured on a texture.
///
/// Given  texture  plate carrée, with the photometer's channels
///        from_m   the place from which the Moon is seen, relative to the Earth's centre on GCRS axes
DiscBrightness measured(const Photometer& photometer, const texture::Image& texture,
                        const almanac::SkyState& sky, const glm::dvec3& from_m = {0, 0, 0});

/// Irradiance from the whole Moon in each channel, summed over texels of area ΔA:
///
///     E = Σ L cos e ΔA / d²        e: emission angle, d: distance from the texel to the observer
///
/// Given     texture  plate carrée, with any channels of radiance or luminance L
///           from_m   the place from which the Moon is seen, relative to the Earth's centre on GCRS axes
/// Returned  [channel]  irradiance or illuminance on a surface that faces the Moon
std::vector<double> irradiance_of_disc(const texture::Image& texture, const almanac::SkyState& sky,
                                       const glm::dvec3& from_m = {0, 0, 0});

/// Solid angle of the Moon as seen from a place [sr], summed over the same texels as irradiance_of_disc.
double solid_angle_of_disc(std::size_t rows, const almanac::SkyState& sky,
                           const glm::dvec3& from_m = {0, 0, 0});

/// Danjon's L of a totally eclipsed Moon, estimated from its visual magnitude.
///
///     m = 4.2 − 3 L + (L/2)²
///
/// Returned  L, clamped to 0 to 4
/// Accuracy  0.4, by which observers' estimates differ
/// Source    H. C. Vital's correlation of observers' estimates (REA Brazil, 2004 to 2015)
double danjon_estimate(double visual_magnitude);

}  // namespace coppermoon::uses
