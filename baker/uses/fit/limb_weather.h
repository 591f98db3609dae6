// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <cstddef>
#include <span>

#include "uses/fit/lit_bins.h"

namespace coppermoon::uses {

/// Equal parts of the limb, by position angle, whose weather is independent: 30 degrees each.
inline constexpr std::size_t weather_sectors = 12;

/// Shares of a place's refracted light that come from each part of the limb. Part s is centred at position angle
/// 2π s / 12.
///
/// A part of the limb spreads the Sun's image outwards from the axis along its own position angle. A place within the
/// image's radius of that line gets light from it, and more light farther out: the brightness along the line grows as
/// exp(x / 700 km).
///
/// Given     sun_distance_m  distance from the Sun to the Earth
/// Returned  shares that add up to that of refracted light in all light: 1 in the umbra, less outside
/// Accuracy  0.05, compared with light computed without a part of the limb
std::array<double, weather_sectors> shares_of_limb(const eclipse::ShadowPlace& place,
                                                   double sun_distance_m);

/// How much of each bin's light comes from each part of the limb: (bin, part).
algebra::Grid<double> limb_of_bins(const FitScene& scene);

/// Kinds of weather at a part of the limb: one that changes all light; one for blue alone; one for deep light alone,
/// whose rays pass lower. If the derivative of light with respect to cloud is known, it covers the last kind.
inline constexpr std::size_t weather_of_light = 0, weather_of_blue = 1, weather_kinds = 3,
                             weather_kinds_beside_cloud = 2;

/// Standard deviation of a channel's light due to one kind of weather, relative to that of red due to all weather.
///
/// Given  distance_km  from the axis; the umbra ends at about 4600 km
double light_by_weather(std::size_t kind, std::size_t channel, double distance_km);

/// Weights of independent changes of weather at given moments. There is one change an hour, and weather varies linearly
/// in between. Part of the weather persists from hour to hour: systems of 1500 km cross the limb in an hour near the
/// equator but take many hours near the poles, and land and sea that are cloudier or clearer than their belt stay so
/// for a night.
///
/// Given     seconds  of the moments, counted from any origin
/// Returned  (moment, change); a single change if all moments are within a quarter of an hour
algebra::Grid<double> weather_changes(std::span<const double> seconds);

/// Error of light due to weather, relative to that in usual air. Weather changes the chance of cloud, so the more light
/// clouds take, the more weather changes light. Weather other than cloud keeps the ratio at one half or more.
///
/// Given     dimming  by how much ln(red light in the umbra) falls per unit of ln(chance of cloud): 0.3 in usual air,
///                    0.6 in air without aerosol
/// Returned  0.5 or more
double weather_over_usual(double dimming);

}  // namespace coppermoon::uses
