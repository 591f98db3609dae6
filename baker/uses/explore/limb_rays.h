// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <span>

#include "atmosphere/atmosphere.h"
#include "shadow/irradiance.h"
#include "uses/explore/page_arrays.h"

namespace coppermoon::uses {

/// Optical depths of the stratosphere's aerosol at 550 nm for which a page has rays; between them it interpolates
/// logarithms. At 0.15 the kind of aerosol changes (atmosphere::StratosphericLayer::nearest).
inline constexpr double aerosol_steps[] = {0.004, 0.008, 0.028, 0.086, 0.12, 0.149,
                                           0.151, 0.2,   0.262, 0.5,   1};

/// Adds the rays of the limb from which a page sums up the light of any air. Every part of the limb
/// (photons::WholeLimb) has rays at the same tangent heights, 200 m apart up to 30 km. Each is traced at some
/// refractivities of the air at sea level; a wavelength's ray is a blend of these (photons::blend). At the last
/// refractivity, 0, rays are straight.
///
/// Arrays:
///     limb.heights   [ray]                            tangent heights [km]
///     limb.bending   [part][refractivity][ray]        [rad]
///     limb.excess    [part][ray]                      e in b = R + height + refractivity · e [km]
///     limb.amounts   [part][refractivity][ray][absorber]  profiles integrated along the path
///     limb.spectra   [part][wavelength][absorber]     optical depth of a unit of each amount
///     limb.aerosol   [part][step][ray]                optical depth at 550 nm of the stratosphere's aerosol
///     limb.aerosolSpectra [step][wavelength]          optical depth over that at 550 nm
///     limb.recordedSpectra [part][step][wavelength]   the same of the month's own aerosol; 0: it has none
///     limb.blend     [wavelength][refractivity but the last]
///     limb.series    [part][cosine, sine][harmonic]   share of the part in the limb, by position angle
///
/// Returned  groups of the absorbers; radius [km] and amounts of each part
/// Given     wavelengths_nm  380 to 780
nlohmann::ordered_json add_limb_rays(PageArrays& arrays, const atmosphere::Atmosphere& atmosphere,
                                     std::span<const double> wavelengths_nm);

/// Adds the light that the air scatters into the shadow (shadow::twilight), for some depths of the stratosphere's
/// aerosol; mean over all position angles.
///
/// Array:
///     scattered  [aerosol][distance][wavelength]  over unobstructed sunlight. Aerosol: as it was, none, and
///                aerosol_steps. Distance: every 2000 km from the axis on. Wavelength: every other one is
///                computed, the rest interpolated
///
/// Given  arrangement  of one plane
void add_scattered_light(PageArrays& arrays, const atmosphere::Atmosphere& atmosphere,
                         const shadow::Arrangement& arrangement,
                         std::span<const double> wavelengths_nm);

}  // namespace coppermoon::uses
