// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "almanac/sky.h"
#include "atmosphere/atmosphere.h"

namespace coppermoon::uses {

/// Stratospheric aerosol in the amount recorded for the month.
struct DatedAerosol {
  bool operator==(const DatedAerosol&) const = default;
};
/// Stratospheric aerosol: a named amount, an optical depth at 550 nm, or the amount recorded for the month.
using Stratosphere = std::variant<atmosphere::StratosphericAerosol,
                                  double /* optical depth, 0 to 2 */, DatedAerosol>;

/// Height profile of ozone: the US Standard Atmosphere 1976, or a climatology by latitude and month.
enum class OzoneProfile { us_1976, climatology };

/// Changes to a column of air, which may vary along the limb. Fields without a value change nothing.
struct ColumnChange {
  /// Step on Danjon's scale, 0 to 4, which sets cloud and aerosol. If the air has belts of latitude, both are scaled
  /// until the night's eclipse reaches this step (DanjonScale).
  std::optional<int> danjon{};
  std::optional<double> ozone_du{}, dust_extinction_per_m{}, dust_bottom_km{}, dust_top_km{},
      tropospheric_optical_depth{}, cloud_top_km{}, cloud_cover{};
  std::optional<Stratosphere> stratosphere{};
  std::optional<double> tropopause_km{};
  /// Factors, 0 to 100, on the usual amounts. If a cloud deck is requested, cloud chance and cirrus default to 0.
  std::optional<double> cloud_chance{}, cirrus{}, free_troposphere{}, stratospheric_factor{},
      water_vapour{};
  std::optional<double> ozone_factor{};  ///< factor on the column of ozone, 0 to 10

  bool operator==(const ColumnChange&) const = default;
};

/// Part of the limb where the air differs, between two latitudes or two position angles [degrees].
struct AirRegion {
  std::optional<double> from_latitude{}, to_latitude{}, from_position_angle{}, to_position_angle{};
  ColumnChange column{};

  bool operator==(const AirRegion&) const = default;
};

enum class EarthFigure { sphere, ellipsoid };

/// The Earth and its air: a field for each effect. A field without a value is taken from the preset `atmosphere`.
struct Air {
  std::string atmosphere = "standard";  ///< one of atmosphere::preset_names()
  bool refraction = true, rayleigh = true;
  std::optional<EarthFigure> earth{};
  std::optional<atmosphere::Density> density{};  ///< ignored if `atmosphere` is "none"
  std::optional<atmosphere::Dispersion> dispersion{};
  std::optional<atmosphere::KingFactor> king_factor{};
  std::optional<atmosphere::OzonePath> ozone_path{};
  std::optional<OzoneProfile> ozone_profile{};
  std::optional<bool> oxygen_pairs{}, oxygen_bands{}, nitrogen_dioxide{};
  ColumnChange column{};
  std::vector<AirRegion> regions{};  ///< where regions overlap, the first one counts

  bool operator==(const Air&) const = default;
};

/// Refuses a region unless it gives either both latitudes or both position angles.
///
/// Throws  Error
void require_place(const AirRegion& region);

/// The air at one moment, before it is scaled to a step on Danjon's scale.
///
/// Given   sun_declination  the Sun's declination at that moment, which gives the tilt of the Earth's pole
///         year             with a fractional part; determines the season and the recorded aerosol
/// Throws  Error            when a term is outside its range, or there are more than 72 regions
atmosphere::Atmosphere atmosphere_of(const Air& air, algebra::Angle sun_declination, double year);

/// The air around the limb as seen from the Moon, scaled to a step on Danjon's scale if one is requested.
atmosphere::Atmosphere atmosphere_of(const Air& air, const almanac::SkyState& sky);

/// Whether the air can be scaled so that the night's eclipse reaches the requested step on Danjon's scale. True if no
/// step is requested or the air has no belts. If false, atmosphere_of returns the clearest or the darkest air.
bool reaches_danjon(const Air& asked, const almanac::SkyState& sky);

}  // namespace coppermoon::uses
