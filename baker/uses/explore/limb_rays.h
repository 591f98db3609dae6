// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <span>

#include "atmosphere/atmosphere.h"
#include "shadow/irradiance.h"
#include "uses/explore/page_arrays.h"

namespace coppermoon::uses {

/// Optical depths of stratospheric aerosol at 550 nm for which a page has rays. In between, it interpolates logarithms.
/// At 0.15 the kind of aerosol changes (atmosphere::StratosphericLayer::nearest).
inline constexpr double aerosol_steps[] = {0.004, 0.008, 0.028, 0.086, 0.12, 0.149,
                                           0.151, 0.2,   0.262, 0.5,   1};

/// Adds the limb rays from which a page computes the light in any air. Every part of the limb
/// (photons::WholeLimb) has rays at the same tangent heights, 200 m apart up to 30 km. Each is traced at several
/// refractivities of the air at sea level. The ray at a wavelength is a blend of these (photons::blend). The last
/// refractivity is 0, where rays are straight.
///
/// Arrays:
///     limb.heights   [ray]                            tangent heights [km]
///     limb.bending   [part][refractivity][ray]        [rad]
///     limb.excess    [part][ray]                      e in b = R + height + refractivity · e [km]
///     limb.amounts   [part][refractivity][ray][absorber]  profiles integrated along the path
///     limb.spectra   [part][wavelength][absorber]     optical depth for one unit of each amount
///     limb.aerosol   [part][step][ray]                optical depth of stratospheric aerosol at 550 nm
///     limb.aerosolSpectra [step][wavelength]          ratio of the optical depth to that at 550 nm
///     limb.recordedSpectra [part][step][wavelength]   the same for the month's own aerosol; 0 if it has none
///     limb.blend     [wavelength][refractivity but the last]
///     limb.series    [part][cosine, sine][harmonic]   the part's share in the limb, by position angle
///
/// Returned  groups of the absorbers; radius [km] and amounts for each part
/// Given     wavelengths_nm  380 to 780
nlohmann::ordered_json add_limb_rays(PageArrays& arrays, const atmosphere::Atmosphere& atmosphere,
                                     std::span<const double> wavelengths_nm);

/// Adds the light that the air scatters into the shadow (shadow::twilight), for several depths of stratospheric
/// aerosol, averaged over all position angles.
///
/// Array:
///     scattered  [aerosol][distance][wavelength]  ratio to unobstructed sunlight. Aerosol: as it was, none, then
///                aerosol_steps. Distance: every 2000 km from the axis outwards. Wavelength: every other one
///                is computed, the rest are interpolated
///
/// Given  arrangement  with one plane
void add_scattered_light(PageArrays& arrays, const atmosphere::Atmosphere& atmosphere,
                         const shadow::Arrangement& arrangement,
                         std::span<const double> wavelengths_nm);

}  // namespace coppermoon::uses
