// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "atmosphere/atmosphere.h"
#include "verbs/flags.h"

namespace coppermoon::verbs {

/// What may differ from one part of the limb to another. Without a value: as the atmosphere has it.
struct ColumnOptions {
  std::optional<int> danjon;
  std::optional<double> ozone_du, dust_extinction_per_m, dust_bottom_km, dust_top_km,
      tropospheric_optical_depth, cloud_top_km, cloud_cover;
  std::optional<std::string> stratosphere;
};

/// The Earth and its air, term by term. Without a value: as the atmosphere has it.
struct AirOptions {
  std::string atmosphere = "standard", refraction = "on", rayleigh = "on";
  std::optional<std::string> earth, density, dispersion, king_factor, ozone_path;
  ColumnOptions column;
  std::vector<std::string> regions;  ///< "from-latitude=-90,to-latitude=0,dust-extinction=1e-5"
};

void add_air_options(CLI::App& verb, AirOptions& options);

/// One region as it is told: where, and what differs there.
struct RegionOptions {
  std::optional<double> from_latitude, to_latitude, from_position_angle, to_position_angle;
  ColumnOptions column;
};

/// What a region may say, and what it said once it was read.
class RegionReader {
 public:
  RegionReader();
  ~RegionReader();
  RegionReader(const RegionReader&) = delete;
  RegionReader& operator=(const RegionReader&) = delete;

  /// Given   text   "from-latitude=-90,to-latitude=0,dust-extinction=1e-5"
  /// Throws  Error  when it cannot be understood, or does not say where the region is
  const RegionOptions& read(const std::string& text);

  const CLI::App& app() const { return *app_; }

 private:
  std::unique_ptr<CLI::App> app_;
  RegionOptions options_;
};

/// Given   sun_declination  of the moment: tips the Earth's pole
/// Throws  Error            when a term is outside its range, or a region cannot be understood
atmosphere::Atmosphere atmosphere_of(const AirOptions& options, algebra::Angle sun_declination);

}  // namespace coppermoon::verbs
