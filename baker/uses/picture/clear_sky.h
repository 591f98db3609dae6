// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "algebra/quantity.h"
#include "almanac/observer.h"
#include "atmosphere/observer_air.h"
#include "atmosphere/sky_luminance.h"
#include "atmosphere/twilight_sky.h"

namespace coppermoon::uses {

using Rgb = std::array<double, 3>;  ///< linear Rec.709

/// A colour, given by two colour indices of astronomical photometry.
struct ColourIndices {
  double b_minus_v, v_minus_r;
};

/// Spectrum of sunlight, adjusted to have the given colour indices, in bands of 10 nm from 380 to 780 nm.
///
///     E(λ) = E_sun(λ) 10^(−0.4 Δm(λ))
///
/// Δm, the difference from the Sun [mag], is interpolated linearly between B (440 nm), V (550 nm) and R (641 nm), and
/// extrapolated linearly beyond them.
std::vector<double> spectrum_of(const ColourIndices& colour);

/// Colour, scaled to luminance 1, of a spectrum in the bands of spectrum_of. Black stays black.
Rgb colour_of(const std::vector<double>& spectrum);

/// The colour scaled to luminance 1; black stays black.
Rgb normalised(Rgb light);

/// Colour of a celestial body's light once the air has scattered it into a line of sight.
///
///     S(λ) = E(λ) g(λ) k_V/k(λ) 10^(−0.4 k(λ) X_m) (1 − 10^(−0.4 k(λ) X))
///
/// Here g = τ(λ)/τ(550 nm), for molecules or for aerosol, and k is the extinction. X_m is the air mass towards the
/// body, and X is the air mass along the line of sight. The law is that of atmosphere::moonlit_sky_cd_m2.
///
/// Omits  light that is scattered more than once
class ScatteredColour {
 public:
  /// Given  altitude  of the celestial body
  ScatteredColour(const atmosphere::ObserverAir& air, const ColourIndices& body,
                  algebra::Angle altitude);

  /// Light scattered by molecules and by aerosol, each computed with a scattering term of 1 (see scattering_terms).
  struct Pair {
    Rgb molecules, aerosol;
  };
  Pair along(algebra::Angle altitude) const;

 private:
  std::vector<double> extinction_mag_, of_molecules_, of_aerosol_;  ///< one value for each band
};

/// The terms that make up a sky's luminance [cd/m²].
struct SkyTerms {
  double airglow, twilight, moonlight;

  double sum() const { return airglow + twilight + moonlight; }
};

/// Clear sky over a place at one moment, in every direction: airglow, twilight, and moonlight that the air scatters
/// (atmosphere/twilight_sky.h, sky_luminance.h). By day it looks as in bright twilight, with the Sun 5 degrees high.
class ClearSky {
 public:
  /// Given   moon_magnitudes  the Moon's magnitudes without air, in B, V and R; infinite for a dark Moon
  /// Throws  Error            when a member of `air`, such as the ozone column, is outside its range
  ClearSky(const almanac::Observer& place, const almanac::SkyState& sky,
           const atmosphere::ObserverAir& air, std::span<const double> moon_magnitudes);
  /// A clear sky lit by a Moon that has the colour of the full Moon.
  ClearSky(const almanac::Observer& place, const almanac::SkyState& sky,
           const atmosphere::ObserverAir& air, double moon_magnitude);

  /// Light of the sky [cd/m²], linear Rec.709, with the luminance that `towards` gives. Moonlight gets its colour from
  /// scattering (ScatteredColour). Airglow has the colour indices B − V = 1.03 and V − R = 0.74.
  ///
  /// Given   direction  as for `towards`
  /// Source  Patat (2003), A&A 400, 1183, for the colour of airglow
  Rgb light(const glm::dvec3& direction) const;

  /// Luminance of the sky in an apparent direction: a unit vector (east, north, up) that includes refraction.
  SkyTerms towards(const glm::dvec3& direction) const;

  /// Apparent angle between a direction and the Moon.
  algebra::Angle from_moon(const glm::dvec3& direction) const;

  double zenith_cd_m2() const { return towards({0, 0, 1}).sum(); }
  algebra::Angle sun_altitude() const { return sun_altitude_; }  ///< altitude without refraction
  algebra::Angle sun_azimuth() const { return algebra::radians(std::atan2(to_sun_.x, to_sun_.y)); }
  double extinction_mag() const { return extinction_mag_; }  ///< extinction in V, at the zenith

 private:
  Rgb twilight_towards(const glm::dvec3& direction) const;
  double moonlight_towards(const glm::dvec3& direction) const;

  double extinction_mag_;
  atmosphere::SkyLamp moon_;
  glm::dvec3 to_moon_, to_sun_;  ///< unit vectors: east, north, up
  algebra::Angle sun_altitude_;
  atmosphere::TwilightSky twilight_;
  std::vector<ScatteredColour::Pair>
      of_moon_;  ///< moonlight at evenly spaced altitudes, 0 to 90°; empty if the Moon is dark
};

/// Direction in an observer's sky, as a unit vector: east, north, up.
glm::dvec3 in_sky(algebra::Angle altitude, algebra::Angle azimuth);

}  // namespace coppermoon::uses
