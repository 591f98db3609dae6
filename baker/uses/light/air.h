// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "atmosphere/atmosphere.h"

namespace coppermoon::uses {

/// What may differ from one part of the limb to another. Without a value: as the atmosphere has it.
struct ColumnChange {
  std::optional<int> danjon{};  ///< cloud and aerosol of that step of Danjon's scale, 0 to 4
  std::optional<double> ozone_du{}, dust_extinction_per_m{}, dust_bottom_km{}, dust_top_km{},
      tropospheric_optical_depth{}, cloud_top_km{}, cloud_cover{};
  std::optional<atmosphere::StratosphericAerosol> stratosphere{};
};

/// A part of the limb with air of its own: between two latitudes, or between two position angles,
/// both in degrees.
struct AirRegion {
  std::optional<double> from_latitude{}, to_latitude{}, from_position_angle{}, to_position_angle{};
  ColumnChange column{};
};

enum class EarthFigure { sphere, ellipsoid };

/// The Earth and its air, term by term. Without a value: as the atmosphere of that name has it.
struct Air {
  std::string atmosphere = "standard";  ///< one of atmosphere::preset_names()
  bool refraction = true, rayleigh = true;
  std::optional<EarthFigure> earth{};
  std::optional<atmosphere::Density> density{};  ///< of what has any
  std::optional<atmosphere::Dispersion> dispersion{};
  std::optional<atmosphere::KingFactor> king_factor{};
  std::optional<atmosphere::OzonePath> ozone_path{};
  ColumnChange column{};
  std::vector<AirRegion> regions{};  ///< the first that holds a place counts
};

/// Refuses a region that does not say where it is: both latitudes or both position angles, no more.
///
/// Throws  Error
void require_place(const AirRegion& region);

/// The air of one moment.
///
/// Given   sun_declination  of that moment: tips the Earth's pole
/// Throws  Error            when a term is outside its range, or there are more than 72 regions
atmosphere::Atmosphere atmosphere_of(const Air& air, algebra::Angle sun_declination);

}  // namespace coppermoon::uses
