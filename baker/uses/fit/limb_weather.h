// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <cstddef>
#include <span>

#include "uses/fit/lit_bins.h"

namespace coppermoon::uses {

/// Number of parts of the Earth's limb with independent weather. Each part covers 30 degrees of position angle.
inline constexpr std::size_t weather_sectors = 12;

/// Shares of the light at a place in the shadow that come from each part of the Earth's limb. Part s is centred at
/// position angle 2π s / 12.
///
/// Each point of the limb spreads the Sun's image along a line through the shadow's axis at the point's position angle.
/// A place receives light from the point if the line is nearer to the place than the radius of the Sun's image. Along
/// the line, the brightness grows outwards as exp(x / 700 km).
///
/// Given     sun_distance_m  distance from the Sun to the Earth
/// Returned  shares, whose sum is the share of refracted light in all light: 1 in the umbra, less outside
/// Accuracy  0.05, compared with light computed with one part of the limb removed
std::array<double, weather_sectors> shares_of_limb(const eclipse::ShadowPlace& place,
                                                   double sun_distance_m);

/// Share of each bin's light that comes from each part of the Earth's limb: (bin, part).
algebra::Grid<double> limb_of_bins(const FitScene& scene);

/// Kinds of weather at a part of the limb. The first changes all light, the second mainly blue light, and the third the
/// light deep in the umbra relative to that near its edge. If the effect of cloud is known, there is no third kind.
inline constexpr std::size_t weather_of_light = 0, weather_of_blue = 1, weather_kinds = 3,
                             weather_kinds_beside_cloud = 2;

/// Change that a kind of weather causes in a channel's light, relative to the change that the first kind causes in red.
///
/// Given  distance_km  distance from the shadow's axis; the umbra ends at about 4600 km
double light_by_weather(std::size_t kind, std::size_t channel, double distance_km);

/// Describes the weather at given moments as a weighted sum of independent random changes: one at the first moment and
/// one after each hour. Between them, weather varies linearly. Part of it persists from hour to hour: weather systems
/// of 1500 km cross the limb in an hour near the equator, but take many hours near the poles, and regions with more or
/// less cloud than is usual at their latitude stay so for a night.
///
/// Given     seconds  moments, counted from any origin
/// Returned  weights (moment, change), with a single change if all moments lie within a quarter of an hour
algebra::Grid<double> weather_changes(std::span<const double> seconds);

/// Ratio of the error of light due to weather in a given air to that in typical air. Weather changes the chance of
/// cloud, so the ratio grows with the light that clouds block. Effects other than cloud keep the ratio at 0.5 or more.
///
/// Given     dimming  decrease of ln(red light in the umbra) per unit of ln(chance of cloud): 0.3 in typical air, 0.6
///                    in air without aerosol
/// Returned  0.5 or more
double weather_over_usual(double dimming);

}  // namespace coppermoon::uses
