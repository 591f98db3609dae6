// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/quantity.h"

namespace coppermoon::atmosphere {

/// How much sulphuric acid and ash hang in the stratosphere: clear since years, or after a volcano
/// has erupted. Vertical optical depths at 550 nm, above 9 km: 0, 0.008, 0.028, 0.086, 0.262.
enum class StratosphericAerosol { none, background, moderate, high, extreme };

/// Extinction by that aerosol at 550 nm [m⁻¹].
///
/// Given     altitude_m  fades out from 11 down to 9 km, where the tropospheric aerosol is; 0 above
///                       100 km
/// Returned  [m⁻¹]       5.1e-7, 1.35e-6, 8.4e-6, 5.5e-5 at 20 km
/// Accuracy  the printed profiles at their altitudes; above 11 km optical depths 0.0072, 0.0269,
///           0.0844 and 0.260 where theirs are 0.0072, 0.0269, 0.0843 and 0.257
/// Omits     season: the mean of spring-summer and fall-winter
/// Source    LOWTRAN 7: Kneizys et al. (1988), AFGL-TR-88-0177
double stratospheric_extinction_per_m(StratosphericAerosol aerosol, double altitude_m);

/// Extinction at a wavelength over that at 550 nm: of 75 % sulphuric acid (background), aged
/// (moderate, high) or fresh (extreme) volcanic aerosol, straight lines between logarithms.
///
/// Given     wavelength  380 to 780 nm
/// Returned  1 at 550 nm; 1 where there is no aerosol
/// Throws    Error       when the wavelength is outside its range
/// Source    LOWTRAN 7: Kneizys et al. (1988), AFGL-TR-88-0177
double stratospheric_spectrum(StratosphericAerosol aerosol, algebra::Wavelength wavelength);

/// Height in which the aerosol of the troposphere falls to 1/e [m].
inline constexpr double tropospheric_scale_height_m = 2e3;

/// Share of the vertical optical depth of the tropospheric aerosol in a metre of altitude [m⁻¹].
///
///     exp(−h/H) / H       H = 2 km
///
/// Accuracy  between 3 and 10 km it falls by 33, the profiles of LOWTRAN 7 for 23 km of visibility
///           by 30 (spring-summer) and 35 (fall-winter)
/// Source    LOWTRAN 7: Kneizys et al. (1988), AFGL-TR-88-0177
double tropospheric_profile_per_m(double altitude_m);

/// Extinction by the tropospheric aerosol at a wavelength over that at 550 nm.
///
///     (λ / 550 nm)^−1.3
///
/// Given     wavelength  380 to 780 nm
/// Throws    Error       when the wavelength is outside its range
/// Source    Ångström (1964), Tellus 16, 64: the mean exponent
double tropospheric_spectrum(algebra::Wavelength wavelength);

}  // namespace coppermoon::atmosphere
