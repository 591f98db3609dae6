// SPDX-License-Identifier: MIT
#include "verbs/air_options.h"

#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "algebra/error.h"
#include "atmosphere/presets.h"

namespace coppermoon::verbs {
namespace {

using atmosphere::Column;
using atmosphere::StratosphericAerosol;

constexpr const char* air_group = "The Earth's air";

/// Of five degrees of the limb each; they take two minutes of computing, and twice as many six.
constexpr std::size_t most_regions = 72;

template <typename Value>
Flag add_air_flag(CLI::App& app, const std::string& flag, Value& value, const std::string& text) {
  return add_flag(app, flag, value, text).in(air_group);
}

void add_column_options(CLI::App& app, ColumnOptions& options) {
  add_air_flag(
      app, "--danjon", options.danjon,
      "cloud and aerosol that make an eclipse of that brightness on Danjon's scale, 0 (very dark) "
      "to 4 (bright)");
  add_air_flag(app, "--ozone-du", options.ozone_du,
               "vertical column of ozone [DU], 0 to 1000; 0: none");
  add_air_flag(app, "--tropospheric-aerosol", options.tropospheric_optical_depth,
               "its vertical optical depth at 550 nm, 0 to 10; 0: none");
  add_air_flag(app, "--stratospheric-aerosol", options.stratosphere,
               "none, background, or after an eruption: moderate, high, extreme")
      .one_of({"none", "background", "moderate", "high", "extreme"});
  add_air_flag(app, "--cloud-cover", options.cloud_cover,
               "part of the limb where cloud stops the light, 0 to 1; 0: none");
  add_air_flag(app, "--cloud-top-km", options.cloud_top_km, "[km], 0 to 30");
  add_air_flag(
      app, "--dust-extinction", options.dust_extinction_per_m,
      "of a grey layer of dust [1/m]; 1e-6 slight, 4.7e-6 usual, 1e-4 a dark eclipse; 0: none");
  add_air_flag(app, "--dust-bottom-km", options.dust_bottom_km, "of that layer [km]; 15");
  add_air_flag(app, "--dust-top-km", options.dust_top_km, "of that layer [km]; 20");
}

StratosphericAerosol stratosphere_named(const std::string& name) {
  if (name == "background") return StratosphericAerosol::background;
  if (name == "moderate") return StratosphericAerosol::moderate;
  if (name == "high") return StratosphericAerosol::high;
  return name == "extreme" ? StratosphericAerosol::extreme : StratosphericAerosol::none;
}

Column changed(Column column, const ColumnOptions& options) {
  if (options.danjon) column = atmosphere::danjon(*options.danjon, column);
  column.ozone_du = options.ozone_du.value_or(column.ozone_du);
  column.tropospheric_optical_depth =
      options.tropospheric_optical_depth.value_or(column.tropospheric_optical_depth);
  if (options.stratosphere) column.stratosphere = stratosphere_named(*options.stratosphere);
  column.cloud_cover = options.cloud_cover.value_or(column.cloud_cover);
  column.cloud_top_m = options.cloud_top_km.value_or(column.cloud_top_m / 1e3) * 1e3;
  column.dust_extinction_per_m =
      options.dust_extinction_per_m.value_or(column.dust_extinction_per_m);
  column.dust_bottom_m = options.dust_bottom_km.value_or(column.dust_bottom_m / 1e3) * 1e3;
  column.dust_top_m = options.dust_top_km.value_or(column.dust_top_m / 1e3) * 1e3;
  return column;
}

/// Both ends by latitude or both by position angle, and no more than that.
bool says_where(const RegionOptions& options) {
  const auto ends = [](const auto& from, const auto& to) {
    return from.has_value() + to.has_value();
  };
  const int latitudes = ends(options.from_latitude, options.to_latitude),
            angles = ends(options.from_position_angle, options.to_position_angle);
  return std::max(latitudes, angles) == 2 && std::min(latitudes, angles) == 0;
}

std::vector<atmosphere::Region> regions_from(const std::string& text,
                                             const atmosphere::Atmosphere& air,
                                             algebra::Angle sun_declination) {
  RegionReader reader;
  const auto& options = reader.read(text);
  const auto column = changed(air.column, options.column);
  if (options.from_latitude)
    return between_latitudes(algebra::degrees(*options.from_latitude),
                             algebra::degrees(*options.to_latitude), sun_declination, column);
  for (const double angle : {*options.from_position_angle, *options.to_position_angle})
    algebra::require_within("position angle [degrees]", angle, -360, 720);
  return {{algebra::degrees(*options.from_position_angle),
           algebra::degrees(*options.to_position_angle), column}};
}

void change_molecules(const AirOptions& options, atmosphere::Atmosphere& air) {
  using atmosphere::Dispersion, atmosphere::KingFactor, atmosphere::OzonePath, atmosphere::Density;
  if (options.dispersion)
    air.molecules.dispersion =
        *options.dispersion == "crc" ? Dispersion::crc : Dispersion::ciddor_1996;
  if (options.king_factor)
    air.molecules.king_factor =
        *options.king_factor == "fixed" ? KingFactor::fixed : KingFactor::bates_1984;
  if (options.ozone_path)
    air.column.ozone_path = *options.ozone_path == "filter" ? OzonePath::filter : OzonePath::bent;
  if (options.density && air.column.density != Density::none)
    air.column.density = *options.density == "us-1976" ? Density::us_1976 : Density::yapo_cutler;
  air.column.refraction = options.refraction == "on";
  air.column.rayleigh = options.rayleigh == "on";
}

std::vector<std::string> presets() {
  const auto names = atmosphere::preset_names();
  return {names.begin(), names.end()};
}

}  // namespace

void add_air_options(CLI::App& verb, AirOptions& options) {
  add_air_flag(
      verb, "--atmosphere", options.atmosphere,
      "standard; clear: its air and ozone alone; molecular: without ozone; paper: as in Yapo & "
      "Cutler (2009); none: the bare Earth")
      .one_of(presets());
  add_air_flag(verb, "--earth", options.earth, "sphere or ellipsoid")
      .one_of({"sphere", "ellipsoid"});
  add_air_flag(verb, "--density", options.density, "us-1976: to 86 km; yapo-cutler: cut at 42 km")
      .one_of({"us-1976", "yapo-cutler"});
  add_air_flag(verb, "--refraction", options.refraction, "on or off").one_of({"on", "off"});
  add_air_flag(verb, "--dispersion", options.dispersion, "of refraction: ciddor or crc")
      .one_of({"ciddor", "crc"});
  add_air_flag(verb, "--rayleigh", options.rayleigh,
               "Rayleigh scattering out of the ray, on or off")
      .one_of({"on", "off"});
  add_air_flag(verb, "--king-factor", options.king_factor,
               "of Rayleigh scattering: bates: by wavelength; fixed: 1.05")
      .one_of({"bates", "fixed"});
  add_air_flag(verb, "--ozone-path", options.ozone_path,
               "bent: along each ray's own path; filter: the same for all")
      .one_of({"bent", "filter"});
  add_column_options(verb, options.column);
  add_air_flag(verb, "--region", options.regions,
               "a part of the limb with air of its own, as "
               "from-latitude=-90,to-latitude=0,dust-extinction=1e-5 (or from-position-angle, "
               "to-position-angle); may be given again, the first that holds a place counts")
      .one_value_each_time();
}

RegionReader::RegionReader() : app_(std::make_unique<CLI::App>("", "a region")) {
  app_->set_help_flag();
  app_->add_option("--from-latitude", options_.from_latitude);
  app_->add_option("--to-latitude", options_.to_latitude);
  app_->add_option("--from-position-angle", options_.from_position_angle);
  app_->add_option("--to-position-angle", options_.to_position_angle);
  add_column_options(*app_, options_.column);
}

RegionReader::~RegionReader() = default;

const RegionOptions& RegionReader::read(const std::string& text) {
  options_ = {};
  std::vector<std::string> flags;
  std::istringstream pairs(text);
  for (std::string pair; std::getline(pairs, pair, ',');) flags.insert(flags.begin(), "--" + pair);
  try {
    app_->parse(flags);  // last first, as CLI11 takes them
  } catch (const CLI::ParseError& error) {
    throw algebra::Error(fmt::format("region '{}': {}", text, error.what()));
  }
  if (!says_where(options_))
    throw algebra::Error(
        fmt::format("region '{}': needs from-latitude and to-latitude, or from-position-angle and "
                    "to-position-angle [degrees]",
                    text));
  return options_;
}

atmosphere::Atmosphere atmosphere_of(const AirOptions& options, algebra::Angle sun_declination) {
  auto air = atmosphere::preset(options.atmosphere, sun_declination);
  if (options.earth)
    air.earth = *options.earth == "sphere"
                    ? atmosphere::Figure{}
                    : atmosphere::ellipsoid(algebra::in_radians(sun_declination));
  change_molecules(options, air);
  air.column = changed(air.column, options.column);
  if (options.regions.size() > most_regions)
    throw algebra::Error(
        fmt::format("regions = {}, allowed up to {}: each has air of its own to compute",
                    options.regions.size(), most_regions));
  for (const auto& text : options.regions)
    for (const auto& region : regions_from(text, air, sun_declination))
      air.regions.push_back(region);
  require_valid(air);
  return air;
}

}  // namespace coppermoon::verbs
