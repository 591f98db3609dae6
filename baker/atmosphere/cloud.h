// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/quantity.h"

namespace coppermoon::atmosphere {

/// The tropopause of a day lies so far from that of the month, at most [m].
inline constexpr double tropopause_wander_m = 2e3;

/// Chance that a ray meets cloud that stops it, in a metre of its way under the tropopause [m⁻¹].
///
/// Occultations of the Sun were followed down to 7 km in 30 % of the cases in the tropics and in 60 % at
/// high latitudes: with cloud alike at all heights (cloud_profile) that is 1.74e-6 up to 10° and 1.46e-6
/// at 65°, straight between; times the cover by high cloud of a latitude over that of those two.
///
/// Returned  1.1e-6 to 1.9e-6, least at 30° and 90°
/// Accuracy  0.02 of those two shares; elsewhere a third
/// Omits     season but for the tropopause's, hemisphere, land and sea
/// Source    Woodbury & McCormick (1983), Geophys. Res. Lett. 10, 1180; London (1957) and Telegadas & London
///           (1954) for high cloud by latitude
double cloud_chance_per_m(algebra::Angle latitude);

/// Chance to meet cloud at an altitude, over that well below the tropopause: 1 below, 0 above a tropopause
/// that wanders by 2 km either way. What a ray passes on its way is
///
///     exp(−∫ chance ds)
///
/// for clouds that lie as dice fall, each as long as it is: that it reaches so far into the next is
/// in the chance, some 600 km of way for each.
///
/// Omits     that cloud may be more frequent at some heights: below 7 km nothing of the kind is
///           published
double cloud_profile(double tropopause_m, double altitude_m);

/// Mean extinction by thin cirrus, which dims a ray without stopping it [m⁻¹]: half of the time there, a
/// kilometre thick, 2e-3 km⁻¹, somewhere in the 3 km under the tropopause.
///
/// Accuracy  a factor of three
/// Omits     that half of it goes on within a degree, as light bent by ice does: it lands elsewhere in
///           the shadow
/// Source    Lesigne et al. (2024), Atmos. Chem. Phys. 24, 5935, for how often and thick; Sassen & Cho
///           (1992), J. Appl. Meteorol. 31, 1275, for extinction: 2e-4 to 2e-2 km⁻¹
double cirrus_extinction_per_m(double tropopause_m, double altitude_m);

}  // namespace coppermoon::atmosphere
