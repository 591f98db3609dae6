// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/quantity.h"

namespace coppermoon::atmosphere {

/// Cubic step from 0 to 1 between t = 0 and 1, flat at both ends and beyond. It is used to fade out cloud and aerosol.
double smooth_step(double t);

/// Largest distance of the tropopause on a single day from its monthly mean [m].
inline constexpr double tropopause_wander_m = 2e3;

/// Probability, per metre of a ray's path under the tropopause, that the ray meets opaque cloud [m⁻¹].
///
/// Satellites followed the setting Sun down to 7 km in 30 % of occultations in the tropics and in 60 % at high
/// latitudes. If the probability does not depend on height (cloud_profile), this gives 1.74e-6 m⁻¹ up to 10° and
/// 1.46e-6 m⁻¹ from 65° on, with linear interpolation in between. At each latitude, the value is then multiplied by a
/// ratio: the cover of high cloud there, divided by a cover interpolated linearly from 0.223 at 10° to 0.252 at 65°.
///
/// Returned  1.1e-6 to 1.9e-6, smallest at 30° and 90°
/// Accuracy  reproduces the 30 % and the 60 % to within 0.02; elsewhere a third
/// Omits     the seasons (except for the tropopause); differences between hemispheres, and between land and sea
/// Source    Woodbury & McCormick (1983), Geophys. Res. Lett. 10, 1180; London (1957) and Telegadas & London
///           (1954) for high cloud by latitude
double cloud_chance_per_m(algebra::Angle latitude);

/// Probability of meeting cloud at an altitude, relative to that well below the tropopause. It falls smoothly from 1 to
/// 0 between 2 km below and 2 km above the mean tropopause. The probability that a ray meets no cloud is
///
///     exp(−∫ p ds)        p = cloud_chance_per_m × cloud_profile, about 1 / (600 km)
///
/// as if clouds were independent of each other. The measured probability already accounts for the length of clouds.
///
/// Omits     variation of the frequency of cloud with height, because no frequencies below 7 km are published
double cloud_profile(double tropopause_m, double altitude_m);

/// Mean extinction by thin cirrus, which dims a ray without stopping it [m⁻¹]. Cirrus is assumed to be present half of
/// the time, one kilometre thick, with an extinction of 2e-3 km⁻¹, anywhere in the 3 km below the tropopause.
///
/// Accuracy  a factor of three
/// Omits     forward scattering: half of the extinguished light continues within a degree of its direction, and falls
///           elsewhere in the shadow
/// Source    Lesigne et al. (2024), Atmos. Chem. Phys. 24, 5935, for frequency and thickness; Sassen & Cho
///           (1992), J. Appl. Meteorol. 31, 1275, for extinction: 2e-4 to 2e-2 km⁻¹
double cirrus_extinction_per_m(double tropopause_m, double altitude_m);

}  // namespace coppermoon::atmosphere
