// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <span>

#include "atmosphere/atmosphere.h"
#include "shadow/irradiance.h"
#include "uses/explore/page_arrays.h"

namespace coppermoon::uses {

/// Optical depths of stratospheric aerosol at 550 nm for which the page has data. The page interpolates between their
/// logarithms. At 0.15 the kind of aerosol changes (atmosphere::StratosphericLayer::nearest).
inline constexpr double aerosol_steps[] = {0.004, 0.008, 0.028, 0.086, 0.12, 0.149,
                                           0.151, 0.2,   0.262, 0.5,   1};

/// Adds the rays past the Earth's limb, from which the page computes the light in the shadow as its user changes the
/// air. In every part of the limb (photons::WholeLimb), rays have the same tangent heights, 200 m apart up to 30 km.
/// Each ray is traced for several refractivities of the air at sea level, and the page blends the results for each
/// wavelength (photons::blend). The last refractivity is 0, for which rays are straight.
///
/// Arrays:
///     limb.heights   [ray]                            tangent heights [km]
///     limb.bending   [part][refractivity][ray]        bending angles [rad]
///     limb.excess    [part][ray]                      e [km], where impact distance = R + height + refractivity · e
///     limb.amounts   [part][refractivity][ray][absorber]  amounts of absorbers along the ray
///     limb.spectra   [part][wavelength][absorber]     optical depth per unit of each amount
///     limb.aerosol   [part][step][ray]                optical depth of stratospheric aerosol at 550 nm
///     limb.aerosolSpectra [step][wavelength]          optical depth relative to 550 nm
///     limb.recordedSpectra [part][step][wavelength]   the same for the aerosol recorded in the month; 0 if no record
///     limb.blend     [wavelength][refractivity]       weights of all refractivities but the last
///     limb.series    [part][cosine, sine][harmonic]   each part's share of the limb, as a series in position angle
///
/// Returned  groups of absorbers, refractivities, and for each part its radius [km], ozone, aerosol and cloud
/// Given     wavelengths_nm  from 380 to 780
nlohmann::ordered_json add_limb_rays(PageArrays& arrays, const atmosphere::Atmosphere& atmosphere,
                                     std::span<const double> wavelengths_nm);

/// Adds the light that the air scatters into the shadow (shadow::twilight), averaged over all position angles, for
/// several optical depths of stratospheric aerosol.
///
/// Array:
///     scattered  [aerosol][distance][wavelength]  light relative to unobstructed sunlight. The first entry is for the
///                aerosol of the given air, the second for none, and the others for aerosol_steps. Distances from the
///                axis are 2000 km apart. Every other wavelength is computed, and the rest are interpolated
///
/// Given  arrangement  has one element in depths_m, the depth at which light is computed
void add_scattered_light(PageArrays& arrays, const atmosphere::Atmosphere& atmosphere,
                         const shadow::Arrangement& arrangement,
                         std::span<const double> wavelengths_nm);

}  // namespace coppermoon::uses
