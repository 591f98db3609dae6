// SPDX-License-Identifier: MIT
#include "verbs/flags/air_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
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
               "vertical optical depth of the aerosol near the ground at 550 nm, 0 to 10");
  add_parsed(
      app, "--stratospheric-aerosol",
      [&column](const std::string& text) { column.stratosphere = stratosphere_from(text); },
      "aerosol of the stratosphere: dated (of that month, 500 BC to 2025), none, background, or "
      "moderate, high, extreme (after an eruption); or its vertical optical depth at 550 nm, 0 to "
      "2")
      .in(air_group);
  add_air_flag(app, "--free-troposphere", column.free_troposphere,
               "factor on the aerosol that satellites see between ground and tropopause, 0 to 100");
  add_air_flag(app, "--cloud-chance", column.cloud_chance,
               "factor on the chance that a ray meets cloud, 0 (no cloud) to 100; the chance "
               "depends on height and latitude");
  add_air_flag(app, "--cirrus", column.cirrus,
               "factor on the thin cirrus below the tropopause, 0 (none) to 100");
  add_air_flag(app, "--tropopause-km", column.tropopause_km,
               "height of the tropopause [km], 5 to 20: cloud ends there");
  add_air_flag(app, "--cloud-top-km", column.cloud_top_km,
               "height of the cloud deck that --cloud-cover lays [km], 0 to 30");
  add_air_flag(app, "--dust-bottom-km", column.dust_bottom_km,
               "lower edge of the dust layer [km]; default: 15");
  add_air_flag(app, "--dust-top-km", column.dust_top_km,
               "upper edge of the dust layer [km]; default: 20");
}

/// What a fit seeks, and Danjon's scale, which says all of it.
void add_sought(CLI::App& app, uses::ColumnChange& column) {
  add_air_flag(
      app, "--danjon", column.danjon,
      "brightness of this eclipse on Danjon's scale, 0 (very dark) to 4 (bright): cloud and "
      "aerosol are scaled until the eclipse has it. Where no air does, the clearest air is taken");
  add_air_flag(app, "--ozone-du", column.ozone_du, "vertical column of ozone [DU], 0 to 1000");
  add_air_flag(app, "--cloud-cover", column.cloud_cover,
               "share of the Earth's limb where a deck of cloud stops the light, 0 to 1; replaces "
               "the chance of cloud");
  add_air_flag(app, "--dust-extinction", column.dust_extinction_per_m,
               "extinction of a grey layer of dust [1/m]: 1e-6 is slight, 4.7e-6 usual, 1e-4 makes "
               "a dark eclipse");
}

void add_terms(CLI::App& verb, uses::Air& air) {
  using atmosphere::Density, atmosphere::Dispersion, atmosphere::KingFactor, atmosphere::OzonePath,
      uses::EarthFigure, uses::OzoneProfile;
  const auto names = atmosphere::preset_names();
  add_air_flag(verb, "--atmosphere", air.atmosphere,
               "air of the Earth. standard (also monthly): that of the eclipse's month, by "
               "latitude; undated: the same everywhere and always; clear: air and ozone only; "
               "molecular: air only; paper: as in Yapo & Cutler (2009); none: the bare Earth")
      .one_of({names.begin(), names.end()});
  add_choice<EarthFigure>(verb, "--earth", air.earth,
                          {{"sphere", EarthFigure::sphere}, {"ellipsoid", EarthFigure::ellipsoid}},
                          "figure of the Earth")
      .in(air_group);
  add_choice<Density>(verb, "--density", air.density,
                      {{"seasonal", Density::seasonal},
                       {"us-1976", Density::us_1976},
                       {"yapo-cutler", Density::yapo_cutler}},
                      "density of the air: seasonal (by latitude and season), us-1976 (to 86 km) "
                      "or yapo-cutler (cut at 42 km)")
      .in(air_group);
  add_on_off(verb, "--refraction", air.refraction, "bending of light in the Earth's air")
      .in(air_group);
  add_choice<Dispersion>(verb, "--dispersion", air.dispersion,
                         {{"ciddor", Dispersion::ciddor_1996}, {"crc", Dispersion::crc}},
                         "formula of the refractive index by wavelength")
      .in(air_group);
  add_on_off(verb, "--rayleigh", air.rayleigh, "Rayleigh scattering out of the ray").in(air_group);
  add_choice<KingFactor>(
      verb, "--king-factor", air.king_factor,
      {{"bates", KingFactor::bates_1984}, {"fixed", KingFactor::fixed}},
      "King factor of Rayleigh scattering: bates (by wavelength) or fixed (1.05)")
      .in(air_group);
  add_choice<OzonePath>(
      verb, "--ozone-path", air.ozone_path,
      {{"bent", OzonePath::bent}, {"filter", OzonePath::filter}},
      "ozone that a ray meets: bent (along its own path) or filter (the same for all rays)")
      .in(air_group);
  add_choice<OzoneProfile>(
      verb, "--ozone-profile", air.ozone_profile,
      {{"climatology", OzoneProfile::climatology}, {"us-1976", OzoneProfile::us_1976}},
      "height profile of ozone: climatology (by latitude and month) or us-1976")
      .in(air_group);
  add_on_off(verb, "--oxygen-pairs", air.oxygen_pairs, "absorption by pairs of oxygen molecules")
      .in(air_group);
  add_on_off(verb, "--nitrogen-dioxide", air.nitrogen_dioxide, "absorption by nitrogen dioxide")
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
           "part of the Earth's limb with air of its own, as "
           "from-latitude=-90,to-latitude=0,dust-extinction=1e-5; or between from-position-angle "
           "and to-position-angle. May be given again: the first region that holds a place counts"))
      .in(air_group)
      .one_value_each_time();
}

/// "ozone 300 DU", "stratospheric aerosol extreme".
std::string in_words(const std::string& flag, const std::string& value) {
  static const std::map<std::string, std::string> units{{"-km", " km"}, {"-du", " DU"}};
  auto name = flag;
  std::string unit;
  for (const auto& [ending, its_unit] : units)
    if (name.ends_with(ending)) name.resize(name.size() - ending.size()), unit = its_unit;
  std::ranges::replace(name, '-', ' ');
  return name + ' ' + value + unit;
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

std::string air_in_words(const CLI::App& verb) {
  std::string air = "standard air", changes;
  for (const auto* option : verb.get_options()) {
    if (option->get_group() != air_group || option->count() == 0) continue;
    const auto& flag = option->get_lnames().front();
    const auto& value = option->results().back();
    const auto usual = option->get_default_str();
    if (flag == "atmosphere")
      air = value == "none" ? "no air"
                            : (value == atmosphere::lasting_name(usual) ? usual : value) + " air";
    else if (flag == "region")
      changes += option->count() == 1 ? ", 1 region" : fmt::format(", {} regions", option->count());
    else if (value != usual)
      changes += ", " + in_words(flag, value);
  }
  return air + changes;
}

void say_unless_danjon_is_reached(const uses::Air& air, const almanac::SkyState& sky) {
  if (reaches_danjon(air, sky)) return;
  fmt::print(stderr,
             "coppermoon: no air makes this eclipse {} on Danjon's scale; the nearest is taken\n",
             *air.column.danjon);
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
