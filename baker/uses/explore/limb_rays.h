// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <span>

#include "atmosphere/atmosphere.h"
#include "shadow/irradiance.h"
#include "uses/explore/page_arrays.h"

namespace coppermoon::uses {

/// Optical depths of the stratosphere's aerosol at 550 nm that a page has rays for; between them it
/// interpolates logarithms. At 0.15 the kind of aerosol changes that light is scattered by
/// (atmosphere::StratosphericLayer::nearest).
inline constexpr double aerosol_steps[] = {0.004, 0.008, 0.028, 0.086, 0.12, 0.149,
                                           0.151, 0.2,   0.262, 0.5,   1};

/// What a page needs of the limb to sum up light by itself, whatever its reader does to the air. Rays
/// stand at the same tangent heights over all parts of the limb (photons::WholeLimb), 200 m apart up to
/// 20 km. They are followed at some refractivities of the air at sea level; a wavelength's ray is a blend
/// of these (photons::blend). The last refractivity is 0: rays that no air bends.
///
/// Arrays:
///     limb.heights   [ray]                            tangent heights [km]
///     limb.bending   [part][refractivity][ray]        [rad]
///     limb.excess    [part][ray]                      b − R is the height and the refractivity times it [km]
///     limb.amounts   [part][refractivity][ray][absorber]  profiles summed along the path
///     limb.spectra   [part][wavelength][absorber]     optical depth is the sum of amounts times these
///     limb.aerosol   [part][step][ray]                optical depth at 550 nm of the stratosphere's aerosol
///     limb.aerosolSpectra [step][wavelength]          over that at 550 nm
///     limb.blend     [wavelength][refractivity but the last]
///     limb.series    [part][cosine, sine][harmonic]   the part's share of the limb by position angle
///
/// Returned  the rest: names of absorbers; of each part its radius [km], and what of each term it holds
/// Given     wavelengths_nm  380 to 780
nlohmann::ordered_json add_limb_rays(PageArrays& arrays, const atmosphere::Atmosphere& atmosphere,
                                     std::span<const double> wavelengths_nm);

/// Light that the air scatters into the shadow (shadow::twilight) for some amounts of the stratosphere's
/// aerosol, the mean over all position angles.
///
/// Array:
///     scattered  [amount][distance][wavelength]  over unshaded sunlight; amounts: as it was, none, and
///                aerosol_steps; distances: every 2000 km from the axis on. Computed at every other
///                wavelength, straight lines between
///
/// Given  arrangement  of one plane
void add_scattered_light(PageArrays& arrays, const atmosphere::Atmosphere& atmosphere,
                         const shadow::Arrangement& arrangement,
                         std::span<const double> wavelengths_nm);

}  // namespace coppermoon::uses
