// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "almanac/sky.h"
#include "atmosphere/atmosphere.h"

namespace coppermoon::uses {

/// The stratosphere's aerosol: an amount by name; of an optical depth at 550 nm; that of the month.
struct DatedAerosol {
  bool operator==(const DatedAerosol&) const = default;
};
using Stratosphere = std::variant<atmosphere::StratosphericAerosol,
                                  double /* optical depth, 0 to 2 */, DatedAerosol>;

/// Ozone's profile: of US 1976, or of the latitude and month.
enum class OzoneProfile { us_1976, climatology };

/// What may differ from one part of the limb to another. Without a value: as the atmosphere has it.
struct ColumnChange {
  /// Cloud and aerosol of that step of Danjon's scale, 0 to 4; in the air of a month, what makes the
  /// eclipse of that night such a one (danjon_clearness).
  std::optional<int> danjon{};
  std::optional<double> ozone_du{}, dust_extinction_per_m{}, dust_bottom_km{}, dust_top_km{},
      tropospheric_optical_depth{}, cloud_top_km{}, cloud_cover{};
  std::optional<Stratosphere> stratosphere{};
  std::optional<double> tropopause_km{};
  /// Factors on what is usual, 0 to 100; of cloud: 0 where a deck is asked for.
  std::optional<double> cloud_chance{}, cirrus{}, free_troposphere{};

  bool operator==(const ColumnChange&) const = default;
};

/// A part of the limb with air of its own: between two latitudes, or between two position angles,
/// both in degrees.
struct AirRegion {
  std::optional<double> from_latitude{}, to_latitude{}, from_position_angle{}, to_position_angle{};
  ColumnChange column{};

  bool operator==(const AirRegion&) const = default;
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
  std::optional<OzoneProfile> ozone_profile{};
  std::optional<bool> oxygen_pairs{}, nitrogen_dioxide{};
  ColumnChange column{};
  std::vector<AirRegion> regions{};  ///< the first that holds a place counts

  bool operator==(const Air&) const = default;
};

/// Refuses a region that does not say where it is: both latitudes or both position angles, no more.
///
/// Throws  Error
void require_place(const AirRegion& region);

/// The air of one moment, belts before Danjon's scale is set to them.
///
/// Given   sun_declination  of that moment: tips the Earth's pole
///         year             of that moment, with its fraction: says the season and the aerosol
/// Throws  Error            when a term is outside its range, or there are more than 72 regions
atmosphere::Atmosphere atmosphere_of(const Air& air, algebra::Angle sun_declination, double year);

/// The same of a sky, for the air over the limb that the Moon sees.
atmosphere::Atmosphere atmosphere_of(const Air& air, const almanac::SkyState& sky);

/// Whether there is air that makes the eclipse of that night one of the step of Danjon's scale that is asked
/// for; true where none is, or the air has no belts to clear. Without, the clearest or the darkest is taken.
bool reaches_danjon(const Air& asked, const almanac::SkyState& sky);

}  // namespace coppermoon::uses
