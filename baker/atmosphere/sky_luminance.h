// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/quantity.h"
#include "atmosphere/observer_air.h"

namespace coppermoon::atmosphere {

/// Luminance [cd/m²] for a surface brightness in V magnitudes per square arc second.
///
///     1.08e5 · 10^(−0.4 m)
///
/// Given   mag_per_arcsec2  0 to 30
/// Throws  Error            when the brightness is outside its range
/// Source  1.08e5 is common in the literature; the Sun's V = -26.76 and 1.28e5 lx confirm this factor to 3 %
double luminance_of_magnitude_cd_m2(double mag_per_arcsec2);

/// Extinction by the air above an observer, in the V band at the zenith [mag].
///
///     k = 2.5 lg e · τ(550 nm)        τ: Rayleigh scattering, ozone and aerosol (vertical_depths)
///
/// Throws  Error  when a quantity of the air is outside its range
double visual_extinction_mag(const ObserverAir& air);

/// Air mass for light that is scattered or emitted along a line of sight.
///
///     X = (1 − 0.96 sin² z)^−½        z: zenith distance
///
/// Given     altitude  0 to 90 degrees; values outside are clamped
/// Returned  X         1 at the zenith, 5 on the horizon
/// Source    Garstang (1989), PASP 101, 306; Krisciunas & Schaefer (1991), eq. 3
double sky_air_mass(algebra::Angle altitude);

/// Luminance of the airglow on a moonless night.
///
///     L₀ X 10^(−0.4 k (X − 1))        L₀: 21.9 mag/arcsec²
///
/// Given     extinction_mag  k, from visual_extinction_mag
/// Returned  [cd/m²]         1.9e-4 at the zenith, twice as much at 20 degrees
/// Omits     towns, Milky Way, zodiacal light; the sunspot cycle, which changes the airglow by a factor of two
/// Source    Krisciunas & Schaefer (1991), PASP 103, 1033, eq. 2
double airglow_cd_m2(algebra::Angle altitude, double extinction_mag);

/// Celestial body that illuminates the air.
struct SkyLamp {
  double magnitude = 0;     ///< V magnitude above the air; infinite for a dark body
  algebra::Angle altitude;  ///< true (airless) altitude
};

/// Direction of a line of sight.
struct SkyDirection {
  algebra::Angle altitude, from_lamp;  ///< from_lamp: angle between this direction and the SkyLamp
};

/// Terms for moonlight scattered by molecules and by aerosol, without the factors for transmittance and for the share
/// of the light that is scattered.
///
///     molecules 10^5.36 (1.06 + cos²ρ)        aerosol (a⁴ + b⁴)^¼, a = 10^(6.15 − ρ/40°), b = 6.2e7 / (1 + (ρ/1°)²)
///
/// Given   from_lamp  ρ, 0 to 180 degrees. The term for aerosol flattens within one degree, where most of an aureole is
///                    due to optics and dust
/// Source  Krisciunas & Schaefer (1991), eqs. 17 to 21. Below 10 degrees they use b = 6.2e7 (ρ/1°)^−2, which causes a
///         jump of a fifth at 10 degrees
struct ScatteringTerms {
  double molecules, aerosol;
};
ScatteringTerms scattering_terms(algebra::Angle from_lamp);

/// Luminance of a clear sky due to scattered moonlight.
///
///     B = f(ρ) 10^(−0.4 (m + 16.57)) 10^(−0.4 k X_m) (1 − 10^(−0.4 k X)) nL
///
/// where f is the sum of scattering_terms, X the air mass of the line of sight, X_m that of the Moon, and 1 nL = 10⁻⁵/π
/// cd/m². The light fades out while the Moon is within 0.3 degrees of the horizon.
///
/// Given     extinction_mag  k, from visual_extinction_mag
/// Returned  [cd/m²]         0 for a Moon below the horizon
/// Accuracy  8 to 23 % for the formula on Mauna Kea; about 0.3 mag at sea level, where the air contains more aerosol
/// Omits     polarisation; the colour of moonlight (the red light of a total eclipse is scattered a tenth less than
///           white light of equal magnitude)
/// Source    Krisciunas & Schaefer (1991), PASP 103, 1033
double moonlit_sky_cd_m2(const SkyLamp& moon, const SkyDirection& towards, double extinction_mag);

}  // namespace coppermoon::atmosphere
