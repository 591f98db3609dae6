// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "almanac/sky.h"
#include "atmosphere/atmosphere.h"

namespace coppermoon::uses {

/// Aerosol of the stratosphere: an amount by name, an optical depth at 550 nm, or that of the month.
struct DatedAerosol {
  bool operator==(const DatedAerosol&) const = default;
};
using Stratosphere = std::variant<atmosphere::StratosphericAerosol,
                                  double /* optical depth, 0 to 2 */, DatedAerosol>;

/// Height profile of ozone: of US 1976, or of latitude and month.
enum class OzoneProfile { us_1976, climatology };

/// Changes of a column of air, which may differ along the limb. Without a value: as the atmosphere has it.
struct ColumnChange {
  /// Step of Danjon's scale, 0 to 4: cloud and aerosol of it; in the air of a month, scaled until the eclipse of that
  /// night has it (DanjonScale).
  std::optional<int> danjon{};
  std::optional<double> ozone_du{}, dust_extinction_per_m{}, dust_bottom_km{}, dust_top_km{},
      tropospheric_optical_depth{}, cloud_top_km{}, cloud_cover{};
  std::optional<Stratosphere> stratosphere{};
  std::optional<double> tropopause_km{};
  /// Factors on the usual amounts, 0 to 100; the chance of cloud is 0 where a deck is asked for.
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

/// Earth and its air, term by term. Without a value: as the named atmosphere has it.
struct Air {
  std::string atmosphere = "standard";  ///< one of atmosphere::preset_names()
  bool refraction = true, rayleigh = true;
  std::optional<EarthFigure> earth{};
  std::optional<atmosphere::Density> density{};  ///< of air that has any
  std::optional<atmosphere::Dispersion> dispersion{};
  std::optional<atmosphere::KingFactor> king_factor{};
  std::optional<atmosphere::OzonePath> ozone_path{};
  std::optional<OzoneProfile> ozone_profile{};
  std::optional<bool> oxygen_pairs{}, oxygen_bands{}, nitrogen_dioxide{};
  ColumnChange column{};
  std::vector<AirRegion> regions{};  ///< the first that holds a place counts

  bool operator==(const Air&) const = default;
};

/// Refuses a region that does not say where it is: both latitudes or both position angles, no more.
///
/// Throws  Error
void require_place(const AirRegion& region);

/// Air of one moment, its belts not yet scaled to Danjon's scale.
///
/// Given   sun_declination  at that moment: tilt of the Earth's pole
///         year             with its fraction: season and aerosol
/// Throws  Error            when a term is outside its range, or there are more than 72 regions
atmosphere::Atmosphere atmosphere_of(const Air& air, algebra::Angle sun_declination, double year);

/// Air over the limb that the Moon of a sky sees, scaled to Danjon's scale where that is asked for.
atmosphere::Atmosphere atmosphere_of(const Air& air, const almanac::SkyState& sky);

/// Whether some air gives the eclipse of that night the step of Danjon's scale that is asked for; true where none is
/// asked for, or the air has no belts. Otherwise the clearest or the darkest air is taken.
bool reaches_danjon(const Air& asked, const almanac::SkyState& sky);

}  // namespace coppermoon::uses
