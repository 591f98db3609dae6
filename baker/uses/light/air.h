// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "almanac/sky.h"
#include "atmosphere/atmosphere.h"

namespace coppermoon::uses {

/// Stratospheric aerosol: an amount by name, an optical depth at 550 nm, or the amount recorded for the month.
struct DatedAerosol {
  bool operator==(const DatedAerosol&) const = default;
};
using Stratosphere = std::variant<atmosphere::StratosphericAerosol,
                                  double /* optical depth, 0 to 2 */, DatedAerosol>;

/// Height profile of ozone: from US 1976, or from a climatology by latitude and month.
enum class OzoneProfile { us_1976, climatology };

/// Changes to a column of air, which may differ along the limb. Fields without a value keep the atmosphere's own.
struct ColumnChange {
  /// Step on Danjon's scale, 0 to 4, which sets cloud and aerosol. In the air of a month they are scaled until that
  /// night's eclipse reaches this step (DanjonScale).
  std::optional<int> danjon{};
  std::optional<double> ozone_du{}, dust_extinction_per_m{}, dust_bottom_km{}, dust_top_km{},
      tropospheric_optical_depth{}, cloud_top_km{}, cloud_cover{};
  std::optional<Stratosphere> stratosphere{};
  std::optional<double> tropopause_km{};
  /// Factors on the usual amounts, 0 to 100. The chance of cloud is 0 if a cloud deck is requested.
  std::optional<double> cloud_chance{}, cirrus{}, free_troposphere{}, stratospheric_factor{},
      water_vapour{};
  std::optional<double> ozone_factor{};  ///< 0 to 10

  bool operator==(const ColumnChange&) const = default;
};

/// Part of the limb with air of its own, between two latitudes or two position angles [degrees].
struct AirRegion {
  std::optional<double> from_latitude{}, to_latitude{}, from_position_angle{}, to_position_angle{};
  ColumnChange column{};

  bool operator==(const AirRegion&) const = default;
};

enum class EarthFigure { sphere, ellipsoid };

/// The Earth and its air, term by term. Fields without a value are taken from the named atmosphere.
struct Air {
  std::string atmosphere = "standard";  ///< one of atmosphere::preset_names()
  bool refraction = true, rayleigh = true;
  std::optional<EarthFigure> earth{};
  std::optional<atmosphere::Density> density{};  ///< only if there is air
  std::optional<atmosphere::Dispersion> dispersion{};
  std::optional<atmosphere::KingFactor> king_factor{};
  std::optional<atmosphere::OzonePath> ozone_path{};
  std::optional<OzoneProfile> ozone_profile{};
  std::optional<bool> oxygen_pairs{}, oxygen_bands{}, nitrogen_dioxide{};
  ColumnChange column{};
  std::vector<AirRegion> regions{};  ///< where they overlap, the first one counts

  bool operator==(const Air&) const = default;
};

/// Refuses a region unless it gives either both latitudes or both position angles.
///
/// Throws  Error
void require_place(const AirRegion& region);

/// The air at one moment, before its belts are scaled to Danjon's scale.
///
/// Given   sun_declination  at that moment, which gives the tilt of the Earth's pole
///         year             with its fraction, which gives season and aerosol
/// Throws  Error            when a term is outside its range, or there are more than 72 regions
atmosphere::Atmosphere atmosphere_of(const Air& air, algebra::Angle sun_declination, double year);

/// The air over the limb as seen from the Moon, scaled to Danjon's scale if requested.
atmosphere::Atmosphere atmosphere_of(const Air& air, const almanac::SkyState& sky);

/// Whether the air can be scaled so that the night's eclipse has the requested step on Danjon's scale. True if no step
/// is requested or the air has no belts. If false, the clearest or the darkest air is used.
bool reaches_danjon(const Air& asked, const almanac::SkyState& sky);

}  // namespace coppermoon::uses
