// SPDX-License-Identifier: MIT
#pragma once

#include <span>

namespace coppermoon::atmosphere {

/// Value and derivative of a function of altitude.
struct ValueAndSlope {
  double value, slope_per_m;
};

/// Ratio of the density of air to its sea-level value, ρ(h)/ρ₀.
///
///     T = T_b + L (H − H_b)        H = r₀ h / (r₀ + h)
///     ρ/ρ₀ = (ρ_b/ρ₀) (T/T_b)^(−1 − k/L)   or, if L = 0,   (ρ_b/ρ₀) exp(−k (H − H_b) / T_b)
///     k = g₀ M₀ / R* = 34.163195 K/km,   r₀ = 6356.766 km
///
/// Given     altitude_m  geometric; below 0 the lowest layer is extrapolated, above 86 km the density is 0
/// Returned  ρ/ρ₀        1 at 0 m, 2.44e-3 at 42 km
/// Accuracy  matches the printed tables to their last digit (worst relative error 1e-4 up to 50 km)
/// Omits     weather, season and latitude, which change the density by up to 20 % below 10 km
/// Source    U.S. Standard Atmosphere 1976, NOAA-S/T 76-1562
double density_ratio_us_1976(double altitude_m);

/// Density ratio ρ/ρ₀ and its analytic slope d(ρ/ρ₀)/dh.
ValueAndSlope density_ratio_and_slope_us_1976(double altitude_m);

/// Altitude at which the US Standard Atmosphere ends [m]. No model has air above it.
inline constexpr double top_of_us_1976_m = 86e3;

/// Altitudes where the slope of the US 1976 density jumps [m]: the tops of its layers, lowest first. The last is 86 km,
/// where the density drops to 0.
std::span<const double> density_breaks_us_1976_m();

/// Altitudes between which Yapo & Cutler (2009) multiply the US 1976 density by a ramp from 1 to 0 [m].
inline constexpr double taper_bottom_m = 39e3, taper_top_m = 42e3;

/// Density ratio of US 1976 times a ramp that falls linearly from 1 at 39 km to 0 at 42 km.
///
/// Source  Yapo & Cutler (2009), Rendering Lunar Eclipses, §2.3
double density_ratio_yapo_cutler(double altitude_m);
ValueAndSlope density_ratio_and_slope_yapo_cutler(double altitude_m);

/// Altitudes where the slope of Yapo & Cutler's density jumps [m], lowest first.
std::span<const double> density_breaks_m();

}  // namespace coppermoon::atmosphere
