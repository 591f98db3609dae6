// SPDX-License-Identifier: MIT
#include "verbs/flags/air_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <sstream>

#include "algebra/error.h"
#include "algebra/number.h"
#include "atmosphere/presets.h"

namespace coppermoon::verbs {
namespace {

using atmosphere::StratosphericAerosol;

template <typename Value>
Flag add_air_flag(CLI::App& app, const std::string& flag, Value& value, const std::string& text) {
  return add_flag(app, flag, value, text).in(air_group);
}

uses::Stratosphere stratosphere_from(const std::string& text) {
  static const std::map<std::string, StratosphericAerosol> names{
      {"none", StratosphericAerosol::none},
      {"background", StratosphericAerosol::background},
      {"moderate", StratosphericAerosol::moderate},
      {"high", StratosphericAerosol::high},
      {"extreme", StratosphericAerosol::extreme}};
  if (text == "dated") return uses::DatedAerosol{};
  if (const auto name = names.find(text); name != names.end()) return name->second;
  if (const auto depth = algebra::number_in(text)) {
    algebra::require_within("stratospheric aerosol", *depth, 0, 2);
    return *depth;
  }
  throw WrongUsage(
      fmt::format("--stratospheric-aerosol: {}, allowed dated, none, background, moderate, high, "
                  "extreme, or an optical depth of 0 to 2",
                  text));
}

/// Layers that a fit takes as they are told.
void add_layers(CLI::App& app, uses::ColumnChange& column) {
  add_air_flag(app, "--tropospheric-aerosol", column.tropospheric_optical_depth,
               "its vertical optical depth at 550 nm, 0 to 10; 0: none");
  add_parsed(
      app, "--stratospheric-aerosol",
      [&column](const std::string& text) { column.stratosphere = stratosphere_from(text); },
      "dated: that of the month, 500 BC to 2025; none, background, or after an eruption: moderate, "
      "high, extreme; or its vertical optical depth at 550 nm, 0 to 2")
      .in(air_group);
  add_air_flag(app, "--free-troposphere", column.free_troposphere,
               "factor on the aerosol between ground and tropopause that satellites see, 0 to 100; "
               "0: none");
  add_air_flag(app, "--cloud-chance", column.cloud_chance,
               "factor on the chance that a ray meets cloud, by height and latitude, 0 to 100; 0: "
               "none; 1: usual");
  add_air_flag(app, "--cirrus", column.cirrus,
               "factor on thin cirrus under the tropopause, 0 to 100; 0: none; 1: usual");
  add_air_flag(app, "--tropopause-km", column.tropopause_km,
               "height where cloud ends and the stratosphere begins [km], 5 to 20");
  add_air_flag(app, "--cloud-top-km", column.cloud_top_km, "[km], 0 to 30");
  add_air_flag(app, "--dust-bottom-km", column.dust_bottom_km, "of that layer [km]; 15");
  add_air_flag(app, "--dust-top-km", column.dust_top_km, "of that layer [km]; 20");
}

/// What a fit seeks, and Danjon's scale, which says all of it.
void add_sought(CLI::App& app, uses::ColumnChange& column) {
  add_air_flag(
      app, "--danjon", column.danjon,
      "air that makes this eclipse so bright on Danjon's scale, 0 (very dark) to 4 (bright); the "
      "clearest where none makes it so bright; of undated air, cloud and aerosol alike for all");
  add_air_flag(app, "--ozone-du", column.ozone_du,
               "vertical column of ozone [DU], 0 to 1000; 0: none");
  add_air_flag(app, "--cloud-cover", column.cloud_cover,
               "part of the limb where cloud stops the light, 0 to 1; 0: none");
  add_air_flag(
      app, "--dust-extinction", column.dust_extinction_per_m,
      "of a grey layer of dust [1/m]; 1e-6 slight, 4.7e-6 usual, 1e-4 a dark eclipse; 0: none");
}

void add_terms(CLI::App& verb, uses::Air& air) {
  using atmosphere::Density, atmosphere::Dispersion, atmosphere::KingFactor, atmosphere::OzonePath,
      uses::EarthFigure, uses::OzoneProfile;
  const auto names = atmosphere::preset_names();
  add_air_flag(
      verb, "--atmosphere", air.atmosphere,
      "standard or monthly: the air of the month along the limb; undated: alike everywhere and "
      "always, the standard of version 0.1; clear: air and ozone alone; molecular: without ozone; "
      "paper: as in Yapo & Cutler (2009); none: the bare Earth")
      .one_of({names.begin(), names.end()});
  add_choice<EarthFigure>(verb, "--earth", air.earth,
                          {{"sphere", EarthFigure::sphere}, {"ellipsoid", EarthFigure::ellipsoid}},
                          "sphere or ellipsoid")
      .in(air_group);
  add_choice<Density>(
      verb, "--density", air.density,
      {{"seasonal", Density::seasonal},
       {"us-1976", Density::us_1976},
       {"yapo-cutler", Density::yapo_cutler}},
      "seasonal: by latitude and season; us-1976: to 86 km; yapo-cutler: cut at 42 km")
      .in(air_group);
  add_on_off(verb, "--refraction", air.refraction, "on or off").in(air_group);
  add_choice<Dispersion>(verb, "--dispersion", air.dispersion,
                         {{"ciddor", Dispersion::ciddor_1996}, {"crc", Dispersion::crc}},
                         "of refraction: ciddor or crc")
      .in(air_group);
  add_on_off(verb, "--rayleigh", air.rayleigh, "Rayleigh scattering out of the ray, on or off")
      .in(air_group);
  add_choice<KingFactor>(verb, "--king-factor", air.king_factor,
                         {{"bates", KingFactor::bates_1984}, {"fixed", KingFactor::fixed}},
                         "of Rayleigh scattering: bates: by wavelength; fixed: 1.05")
      .in(air_group);
  add_choice<OzonePath>(verb, "--ozone-path", air.ozone_path,
                        {{"bent", OzonePath::bent}, {"filter", OzonePath::filter}},
                        "bent: along each ray's own path; filter: the same for all")
      .in(air_group);
  add_choice<OzoneProfile>(
      verb, "--ozone-profile", air.ozone_profile,
      {{"climatology", OzoneProfile::climatology}, {"us-1976", OzoneProfile::us_1976}},
      "climatology: by latitude and month, its column too; us-1976")
      .in(air_group);
  add_on_off(verb, "--oxygen-pairs", air.oxygen_pairs, "absorption by pairs of O2, on or off")
      .in(air_group);
  add_on_off(verb, "--nitrogen-dioxide", air.nitrogen_dioxide, "its absorption, on or off")
      .in(air_group);
}

void add_regions(CLI::App& verb, uses::Air& air) {
  Flag(*verb.add_option_function<std::vector<std::string>>(
           "--region",
           [&air](const std::vector<std::string>& texts) {
             RegionReader reader;
             air.regions.clear();
             for (const auto& text : texts) air.regions.push_back(reader.read(text));
           },
           "a part of the limb with air of its own, as "
           "from-latitude=-90,to-latitude=0,dust-extinction=1e-5 (or from-position-angle, "
           "to-position-angle); may be given again, the first that holds a place counts"))
      .in(air_group)
      .one_value_each_time();
}

}  // namespace

void add_air_but_sought(CLI::App& verb, uses::Air& air) {
  add_terms(verb, air);
  add_layers(verb, air.column);
}

void add_air_options(CLI::App& verb, uses::Air& air) {
  add_terms(verb, air);
  add_sought(verb, air.column);
  add_layers(verb, air.column);
  add_regions(verb, air);
}

RegionReader::RegionReader() : app_(std::make_unique<CLI::App>("", "a region")) {
  app_->set_help_flag();
  app_->add_option("--from-latitude", region_.from_latitude);
  app_->add_option("--to-latitude", region_.to_latitude);
  app_->add_option("--from-position-angle", region_.from_position_angle);
  app_->add_option("--to-position-angle", region_.to_position_angle);
  add_sought(*app_, region_.column);
  add_layers(*app_, region_.column);
}

RegionReader::~RegionReader() = default;

const uses::AirRegion& RegionReader::read(const std::string& text) {
  region_ = {};
  std::vector<std::string> flags;
  std::istringstream pairs(text);
  for (std::string pair; std::getline(pairs, pair, ',');) flags.insert(flags.begin(), "--" + pair);
  try {
    app_->parse(flags);  // last first, as CLI11 takes them
    require_place(region_);
  } catch (const CLI::ParseError& error) {
    throw algebra::Error(fmt::format("region '{}': {}", text, error.what()));
  } catch (const WrongUsage& error) {
    throw algebra::Error(fmt::format("region '{}': {}", text, error.what()));
  } catch (const algebra::Error& error) {
    throw algebra::Error(fmt::format("region '{}': {}", text, error.what()));
  }
  return region_;
}

}  // namespace coppermoon::verbs
