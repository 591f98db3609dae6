// SPDX-License-Identifier: MIT
#pragma once

#include <span>

namespace coppermoon::atmosphere {

/// A function of altitude with its derivative.
struct ValueAndSlope {
  double value, slope_per_m;
};

/// Density of air over its sea-level value, ρ(h)/ρ₀.
///
///     T = T_b + L (H − H_b)        H = r₀ h / (r₀ + h)
///     ρ/ρ₀ = (ρ_b/ρ₀) (T/T_b)^(−1 − k/L)   or, where L = 0,   (ρ_b/ρ₀) exp(−k (H − H_b) / T_b)
///     k = g₀ M₀ / R* = 34.163195 K/km,   r₀ = 6356.766 km
///
/// Given     altitude_m  geometric; below 0 the lowest layer goes on, above 86 km the density is 0
/// Returned  ρ/ρ₀        1 at 0 m, 2.44e-3 at 42 km
/// Accuracy  the printed tables to their digits (worst 1e-4 relative up to 50 km)
/// Omits     weather, season and latitude: up to 20 % locally below 10 km
/// Source    U.S. Standard Atmosphere 1976, NOAA-S/T 76-1562
double density_ratio_us_1976(double altitude_m);

/// Density ratio with its slope dρ/dh, analytic.
ValueAndSlope density_ratio_and_slope_us_1976(double altitude_m);

/// Altitude where the standard ends, and all air with it [m].
inline constexpr double top_of_us_1976_m = 86e3;

/// The altitudes where the slope of that density jumps [m]: the tops of its layers, lowest first,
/// the last at 86 km, where the density itself ends.
std::span<const double> density_breaks_us_1976_m();

/// Altitude below which the paper's density is that of US 1976, and altitude where its linear ramp
/// has brought it to nothing [m].
inline constexpr double taper_bottom_m = 39e3, taper_top_m = 42e3;

/// US 1976 times a ramp that falls from 1 at 39 km to 0 at 42 km.
///
/// Source  Yapo & Cutler (2009), Rendering Lunar Eclipses, §2.3
double density_ratio_yapo_cutler(double altitude_m);
ValueAndSlope density_ratio_and_slope_yapo_cutler(double altitude_m);

/// The altitudes where the slope of that density jumps [m], lowest first.
std::span<const double> density_breaks_m();

}  // namespace coppermoon::atmosphere
