// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/quantity.h"

namespace coppermoon::atmosphere {

/// Extinction at 550 nm and an altitude of 7 km by aerosol in the free troposphere, in years without eruptions. The
/// extinction that satellites measured at 1.02 µm rises linearly from 1e-4 km⁻¹ at 70° south to 7e-4 km⁻¹ at 70° north;
/// a factor of 2.2 (for an Ångström exponent of 1.3) converts it to 550 nm.
///
/// Returned  [m⁻¹]  2.2e-7 to 1.5e-6
/// Accuracy  a factor of two
/// Source    Kent et al. (1998), J. Geophys. Res. 103, 28863: SAGE I and II, 6 km to the tropopause
double free_troposphere_per_m(algebra::Angle latitude);

/// Ratio of the free troposphere's aerosol extinction at an altitude to that at 7 km.
///
///     exp(−(h − 7 km) / 3 km)
///
/// Returned  this expression, faded out to 0 between the tropopause and 2 km above it
/// Accuracy  LOWTRAN 7, for comparison, has a scale height of 2.6 km between 3 and 10 km
double free_troposphere_profile(double tropopause_m, double altitude_m);

/// Share of the tropospheric aerosol's vertical optical depth per metre of altitude [m⁻¹].
///
///     exp(−h/H) / H
///
/// Given     scale_m  H: 1.2 km for the boundary layer alone, if the free troposphere's aerosol is added separately;
///                    2 km for all tropospheric aerosol together
/// Accuracy  with H = 2 km the share falls by a factor of 33 between 3 and 10 km; LOWTRAN 7's profiles for a visibility
///           of 23 km fall by factors of 30 (spring-summer) and 35 (fall-winter)
/// Source    Elterman (1968), AFCRL-68-0153, for 1.2 km; LOWTRAN 7: Kneizys et al. (1988),
///           AFGL-TR-88-0177
double tropospheric_profile_per_m(double scale_m, double altitude_m);

/// Ratio of the tropospheric aerosol's extinction at a wavelength to that at 550 nm.
///
///     (λ / 550 nm)^−1.3
///
/// Given     wavelength  380 to 780 nm
/// Throws    Error       when the wavelength is outside its range
/// Source    Ångström (1964), Tellus 16, 64, for the mean exponent
double tropospheric_spectrum(algebra::Wavelength wavelength);

}  // namespace coppermoon::atmosphere
