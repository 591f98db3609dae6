// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "atmosphere/atmosphere.h"
#include "shadow/irradiance.h"

namespace coppermoon::shadow {

/// The twilight ring: sunlight that the air of the limb scatters once into the shadow, over
/// unshaded sunlight, on a surface that faces the Sun.
///
///     E/E₀ = (1 + z/D)² / r² ∫∫∫ Σ ω_k P_k(χ) / (4π) β_k exp(−τ) ds b db dφ
///
/// over the sights from the place (r from the Earth's centre) that pass the limb at impact
/// parameter b and position angle φ, and along each of them; β_k the extinction by an absorber, ω P/(4π)
/// what it scatters (atmosphere::scattering), χ the angle between sunlight and sight, 0 to 1.7°, τ the
/// optical depth of all that stands on the straight line from the Sun to the point and on from there. Cloud stops
/// its part of the limb where either line passes below its top; the ground stops sunlight.
///
/// Given     wavelengths_nm  380 to 780; axis_distances_m: 0 or more
/// Returned  one sector for air without regions, else sectors_around; at 450 nm on the axis 1.6e-7
///           in clear air, 3.7e-7 in standard air, 1.0e-6 under a stratosphere full of ash
/// Accuracy  1.5 % of this integral; of belts every third is taken
/// Omits     multiple scattering, in our estimate some tenths of it in clear air, as much again in
///           ash; refraction, 20' of the 57' between sight and sunlight at 12 km; the Sun's width,
///           ±16'; the ellipsoid: a sphere of its mean limb, 0.2 %; depolarisation, 1 %; forward
///           peaks sharper than Henyey and Greenstein's; ω and g other than at 550 nm, 5 %; light
///           off ground and cloud, which is night as seen from within 6378 km of the axis
/// Throws    Error           when an argument is outside its range
RefractedLight twilight(const atmosphere::Atmosphere& atmosphere, const Arrangement& arrangement,
                        std::span<const double> wavelengths_nm,
                        std::span<const double> axis_distances_m);

/// Twilight in several airs at once, in less time than one after the other: lines through the air are
/// followed once.
///
/// Given   airs   one or more, that differ in amounts of dust, ozone and cloud cover alone
/// Throws  Error  when airs differ in anything else (atmosphere::richest), and as twilight
std::vector<RefractedLight> twilight_in(std::span<const atmosphere::Atmosphere> airs,
                                        const Arrangement& arrangement,
                                        std::span<const double> wavelengths_nm,
                                        std::span<const double> axis_distances_m);

/// Adds the twilight to light in the shadow: computed on one plane in the middle, every 1000 km of axis
/// distance and every 5 nm, with straight lines between, where more places and wavelengths are asked for.
/// On other planes it falls with the square of the distance from the Earth.
///
/// Given     light  its wavelengths increase
/// Accuracy  0.5 % of the twilight
void add_twilight(RefractedLight& light, const atmosphere::Atmosphere& atmosphere);

/// Adds the twilight of several airs at once.
///
/// Given  lights  one in each air, at the same places and wavelengths
///        airs    as twilight_in has them
void add_twilight_in(std::span<RefractedLight> lights,
                     std::span<const atmosphere::Atmosphere> airs);

/// Ratio to sunlight at 1 au of the light that the stars of half the sky shed on a surface: a mean
/// of 100 stars of tenth magnitude a square degree, under a Sun of V = −26.74. Its spectrum is
/// taken to be that of the Sun.
///
///     ¼ · 41253 · 100 · 10^(−0.4 (10 + 26.74))
///
/// Accuracy  a third, by which part of the Milky Way is up
/// Omits     zodiacal light, brighter than the stars near the Sun
/// Source    Leinert et al. (1998), A&AS 127, 1, for the brightness of the sky
inline constexpr double starlight_ratio = 2.08e-9;

/// Adds it everywhere, at all wavelengths.
void add_starlight(RefractedLight& light);

}  // namespace coppermoon::shadow
