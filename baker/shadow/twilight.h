// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "atmosphere/atmosphere.h"
#include "shadow/irradiance.h"

namespace coppermoon::shadow {

/// Twilight ring: sunlight that the air at the limb scatters once into the shadow, as a ratio to unshaded sunlight, on
/// a surface that faces the Sun.
///
///     E/E₀ = (1 + z/D)² / r² ∫∫∫ Σ ω_k P_k(χ) / (4π) β_k exp(−τ) ds b db dφ
///
/// The integral runs over lines of sight from the place (at the distance r from the Earth's centre) past the limb at
/// impact parameter b and position angle φ, and along each line by s. For each absorber k, β_k is the extinction and
/// ω_k P_k/(4π) the scattering (atmosphere::scattering). χ is the angle between sunlight and line of sight, 0 to 1.7°.
/// τ is the optical depth along the straight lines from the Sun to the scattering point and from there to the place.
/// Over the share of the limb that cloud covers, cloud stops both lines below its top. The ground stops sunlight.
///
/// Given     wavelengths_nm    380 to 780
///           axis_distances_m  0 or more
/// Returned  one sector for air without regions, otherwise sectors_around. On the axis at 450 nm, the ratio is 1.6e-7
///           in clear air, 3.7e-7 in standard air, and 1.0e-6 under a stratosphere full of ash
/// Accuracy  1.5 %, compared with this integral and with sasktran2's single scattering on the axis, from clear air to
///           ash. Only every third of the air's belts of latitude is used. That saves 60 % of the time, but errs by
///           2 % in the air of 1982 and 1991, and by 4 % in the air of 2022
/// Omits     multiple scattering. On the axis, it adds 9 % (at 420 nm) to 5 % (at 700 nm) to this light in clear air,
///           1 % more over ground of albedo 0.3, 2 to 11 % with stratospheric aerosol, and 2 to 4 % under ash, as found
///           by sasktran2 (discrete ordinates and successive orders). Refraction, 1 % along the line of sight and 1 %
///           along sunlight. It loses no light, but causes 20' of the 57' between these two directions at 12 km. The
///           Sun's radius, 16'. Flattening: the Earth is a sphere with the limb's mean radius (0.2 %). Depolarisation
///           (1 %). Forward peaks sharper than Henyey and Greenstein's. The variation of ω and g with wavelength (5 %);
///           both are for 550 nm. Light from ground and cloud: their day side is not seen within 6378 km of the axis
/// Throws    Error           if an argument is outside its range
RefractedLight twilight(const atmosphere::Atmosphere& atmosphere, const Arrangement& arrangement,
                        std::span<const double> wavelengths_nm,
                        std::span<const double> axis_distances_m);

/// Twilight in several atmospheres at once, which is faster than one by one, because lines through the air are
/// integrated only once.
///
/// Given   airs   one or more, which may differ only in their dust, ozone and cloud cover
/// Throws  Error  if the atmospheres differ in anything else (atmosphere::richest), and as for twilight
std::vector<RefractedLight> twilight_in(std::span<const atmosphere::Atmosphere> airs,
                                        const Arrangement& arrangement,
                                        std::span<const double> wavelengths_nm,
                                        std::span<const double> axis_distances_m);

/// Twilight on a coarse grid, from which `add_between` interpolates the twilight at the places of `light`. The grid has
/// one plane, in the middle. It has wavelengths every 5 nm and distances every 1000 km, or those of `light` if fewer.
///
/// Given   light  light at the places, with increasing wavelengths
///         airs   as for twilight_in
std::vector<RefractedLight> twilight_about(const RefractedLight& light,
                                           std::span<const atmosphere::Atmosphere> airs);

/// Adds twilight from one plane to light in the shadow, interpolated linearly in axis distance, position angle and
/// wavelength. On other planes, twilight varies with the inverse square of the distance from the Earth.
///
/// Given  more  twilight, from twilight_about
void add_between(const RefractedLight& more, RefractedLight& light);

/// Adds twilight to the light in the shadow: `twilight_about` computes it, `add_between` adds it by interpolation.
///
/// Given     light  with increasing wavelengths
/// Accuracy  0.5 % of the twilight
void add_twilight(RefractedLight& light, const atmosphere::Atmosphere& atmosphere);

/// Adds the twilight in several atmospheres at once.
///
/// Given  lights  light in each atmosphere, at the same places and wavelengths
///        airs    as for twilight_in
void add_twilight_in(std::span<RefractedLight> lights,
                     std::span<const atmosphere::Atmosphere> airs);

/// Ratio of the irradiance from the stars of half the sky to sunlight at 1 au. The sky's mean brightness is taken as
/// 100 stars of tenth magnitude per square degree, the Sun as V = −26.74, and the stars' spectrum as the Sun's.
///
///     ¼ · 41253 · 100 · 10^(−0.4 (10 + 26.74))
///
/// Accuracy  a third, depending on which part of the Milky Way is up
/// Omits     zodiacal light, which near the Sun is brighter than the stars
/// Source    Leinert et al. (1998), A&AS 127, 1, for the brightness of the sky
inline constexpr double starlight_ratio = 2.08e-9;

/// Adds starlight everywhere, at all wavelengths.
void add_starlight(RefractedLight& light);

}  // namespace coppermoon::shadow
