// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <cstddef>
#include <span>

#include "uses/fit/lit_bins.h"

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

/// Shares of a scene's bins in the light of the limb's parts: (bin, part).
algebra::Grid<double> limb_of_bins(const FitScene& scene);

/// Kinds of weather that a part of the limb has: of all light; of blue apart; of deep light, whose rays pass lower,
/// apart. Where the derivative by cloud of all light is known the last is in it.
inline constexpr std::size_t weather_of_light = 0, weather_of_blue = 1, weather_kinds = 3,
                             weather_kinds_beside_cloud = 2;

/// Standard deviation of a channel's light by a kind of weather, over that of red by all of it.
///
/// Given  distance_km  from the axis; the umbra ends at some 4600 km
double light_by_weather(std::size_t kind, std::size_t channel, double distance_km);

/// Weights of independent changes of weather, one an hour, at some moments, between which weather changes linearly. A
/// part of the weather stays from hour to hour: systems of 1500 km pass the limb in an hour near the equator, in many
/// near the poles; land and sea, cloudier or clearer than their belt, stay for a night.
///
/// Given     seconds  from any moment
/// Returned  (moment, change); one change within a quarter of an hour
algebra::Grid<double> weather_changes(std::span<const double> seconds);

/// Error of light by weather over that in usual air. Weather changes the chance of cloud, and the more light that cloud
/// takes, the more weather changes light. Other weather leaves half of what is usual.
///
/// Given     dimming  decrease of the logarithm of red light in the umbra by that of the chance of cloud: 0.3 in usual
///                    air, 0.6 in air without aerosol
/// Returned  0.5 or more
double weather_over_usual(double dimming);

}  // namespace coppermoon::uses
