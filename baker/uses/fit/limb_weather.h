// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "eclipse/shadow_axis.h"

namespace coppermoon::uses {

/// Equal parts of the limb, by position angle, whose weather is independent: 30 degrees each.
inline constexpr std::size_t weather_sectors = 12;

/// Shares of a place's refracted light by parts of the limb; part s is centred at the position angle 2π s / 12.
///
/// A part of the limb spreads the Sun's image outwards from the axis along its own position angle: a place within the
/// image's radius of that line has light of it, the more, the farther out on the line. The brightness along the line
/// grows as exp(x / 700 km).
///
/// Given     sun_distance_m  of the Sun from the Earth
/// Returned  with sum 1, times the share of refracted light in all light: less than 1 outside the umbra
/// Accuracy  0.05, against light without a part of the limb
std::array<double, weather_sectors> shares_of_limb(const eclipse::ShadowPlace& place,
                                                   double sun_distance_m);

/// Error of light by weather over that in usual air. Weather changes the chance of cloud, and the more light that cloud
/// takes, the more weather changes light. Other weather leaves half of what is usual.
///
/// Given     dimming  decrease of the logarithm of red light in the umbra by that of the chance of cloud: 0.3 in usual
///                    air, 0.6 in air without aerosol
/// Returned  0.5 or more
double weather_over_usual(double dimming);

}  // namespace coppermoon::uses
