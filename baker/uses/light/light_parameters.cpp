// SPDX-License-Identifier: MIT
#include "uses/light/light_parameters.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <set>
#include <sstream>

#include "algebra/error.h"
#include "algebra/number.h"
#include "atmosphere/presets.h"

namespace coppermoon::uses {
namespace {

using request::Affects, request::Parameters, request::choice, request::on_off, request::parameter,
    request::parsed, request::Words;

const Words<atmosphere::StratosphericAerosol>& stratospheric_amounts() {
  using enum atmosphere::StratosphericAerosol;
  static const Words<atmosphere::StratosphericAerosol> words{{"none", none},
                                                             {"background", background},
                                                             {"moderate", moderate},
                                                             {"high", high},
                                                             {"extreme", extreme}};
  return words;
}

Stratosphere stratosphere_from(const std::string& text) {
  if (text == "dated") return DatedAerosol{};
  for (const auto& [word, amount] : stratospheric_amounts())
    if (text == word) return amount;
  if (const auto depth = algebra::number_in(text)) {
    algebra::require_within("stratospheric aerosol", *depth, 0, 2);
    return *depth;
  }
  throw request::UnknownWord(
      fmt::format("stratospheric-aerosol = {}, allowed dated, none, background, moderate, high, "
                  "extreme, or an optical depth of 0 to 2",
                  text));
}

std::string text_of(const std::optional<Stratosphere>& stratosphere) {
  if (!stratosphere) return {};
  if (std::holds_alternative<DatedAerosol>(*stratosphere)) return "dated";
  if (const auto* depth = std::get_if<double>(&*stratosphere)) return fmt::format("{}", *depth);
  return request::word_for(stratospheric_amounts(),
                           std::get<atmosphere::StratosphericAerosol>(*stratosphere));
}

/// A term that the computation of light may leave out, and the member of plan::Work that switches it on.
struct Term {
  std::string_view name;
  bool plan::Work::*in;
};

constexpr std::array known_terms{
    Term{"refracted-light", &plan::Work::refracted}, Term{"ellipsoid", &plan::Work::ellipsoid},
    Term{"regions", &plan::Work::regions}, Term{"scattered-light", &plan::Work::scattered_light}};

std::string term_names() {
  std::vector<std::string_view> names;
  for (const auto& term : known_terms) names.push_back(term.name);
  return fmt::format("none or {}, with commas between", fmt::join(names, ", "));
}

std::string terms_left_out(const plan::Work& work) {
  std::vector<std::string_view> out;
  for (const auto& term : known_terms)
    if (!(work.*term.in)) out.push_back(term.name);
  return out.empty() ? "none" : fmt::format("{}", fmt::join(out, ","));
}

double tolerance_of(const std::string& text) {
  const auto percentage = algebra::number_with_unit(text, {{"%", 1}});
  if (!percentage)
    throw algebra::Error(fmt::format("tolerance = {}, allowed a percentage as 0.1%", text));
  algebra::require_within("tolerance [%]", *percentage, 0.01, 50);
  return 0.01 * *percentage;
}

double budget_of(const std::string& text) {
  const auto budget =
      algebra::number_with_unit(text, {{"ms", 1e-3}, {"s", 1}, {"min", 60}, {"", 1}});
  if (!budget)
    throw algebra::Error(fmt::format("budget = {}, allowed a time as 500ms, 2s or 1min", text));
  algebra::require_within("budget [s]", *budget, 1e-3, 1e7);
  return *budget;
}

/// Conditions on the settings: those that select the method of Yapo & Cutler (2009), and those that select any photon
/// tracing. If neither are met, a plan does not use photons.
const request::Conditions as_the_paper{{"quality", {"paper"}}},
    of_photons{{"solver", {"photons", "literal"}}, {"photons"}, {"quality", {"paper"}}};

/// The tolerance (a relative error) that a named quality stands for.
double tolerance_named(const std::string& quality) {
  if (quality == "draft") return 0.05;
  return quality == "reference" ? 5e-4 : 0.01;
}

/// Parameter for the regions of the air, which are set from strings and printed as strings.
request::Parameter regions_of(std::vector<AirRegion>& regions) {
  request::Parameter made;
  made.name = "region";
  made.spelling = "region";
  made.meaning =
      "part of the Earth's limb with air of its own, as "
      "from-latitude=-90,to-latitude=0,dust-extinction=1e-5; or between from-position-angle "
      "and to-position-angle. May be given again: the first region that holds a place counts";
  made.many = true;
  const auto one = std::make_shared<AirRegion>();  // kept alive by `parts`, which refers to it
  made.parts = {new Parameters, [one](Parameters* parts) { delete parts; }};
  describe(*made.parts, *one);
  made.read = [&regions] {
    request::Texts texts;
    for (auto region : regions) {
      Parameters parts;
      describe(parts, region);
      std::string text;
      for (const auto& part : parts)
        if (part.has_value())
          text += fmt::format("{}{}={}", text.empty() ? "" : ",", part.name, part.text());
      texts.push_back(text);
    }
    return texts;
  };
  made.write = [&regions](const request::Texts& texts) {
    regions.clear();
    for (const auto& text : texts) regions.push_back(region_from(text));
  };
  made.restore = [&regions, first = regions] { regions = first; };
  return made;
}

}  // namespace

void describe_layers(Parameters& is, ColumnChange& column) {
  is.begin(air_heading, "atmosphere", Affects::photons);
  is.add(parameter("tropospheric-aerosol", column.tropospheric_optical_depth,
                   "vertical optical depth of the aerosol near the ground at 550 nm, 0 to 10"))
      .within(0, 10);
  auto& stratosphere = column.stratosphere;
  is.add(parsed(
      "stratospheric-aerosol", stratosphere, [&stratosphere] { return text_of(stratosphere); },
      [&stratosphere](const std::string& text) { stratosphere = stratosphere_from(text); },
      "aerosol of the stratosphere: dated (of that month, 500 BC to 2025), none, background, or "
      "moderate, high, extreme (after an eruption); or its vertical optical depth at 550 nm, 0 to "
      "2"));
  is.add(parameter("stratospheric-factor", column.stratospheric_factor,
                   "factor on the aerosol of the stratosphere, 0 (none) to 100"))
      .within(0, 100);
  is.add(parameter("free-troposphere", column.free_troposphere,
                   "factor on the aerosol that satellites see between ground and tropopause, 0 to "
                   "100"))
      .within(0, 100);
  is.add(parameter("water-vapour", column.water_vapour,
                   "factor on the water vapour of latitude and season, 0 (none) to 100"))
      .within(0, 100);
  is.add(parameter("cloud-chance", column.cloud_chance,
                   "factor on the chance that a ray meets cloud, 0 (no cloud) to 100; the chance "
                   "depends on height and latitude"))
      .within(0, 100);
  is.add(parameter("cirrus", column.cirrus,
                   "factor on the thin cirrus below the tropopause, 0 (none) to 100"))
      .within(0, 100);
  is.add(parameter("tropopause-km", column.tropopause_km,
                   "height of the tropopause [km], 5 to 20: cloud ends there"))
      .within(5, 20);
  is.add(parameter("cloud-top-km", column.cloud_top_km,
                   "height of the cloud deck that cloud-cover lays [km], 0 to 30"))
      .within(0, 30);
  is.add(parameter("dust-bottom-km", column.dust_bottom_km,
                   "lower edge of the dust layer [km], 0 to 86; default: 15"))
      .within(0, 86);
  is.add(
        parameter("dust-top-km", column.dust_top_km,
                  "upper edge of the dust layer [km], 0 to 86, at or above the lower; default: 20"))
      .within(0, 86);
}

void describe_sought(Parameters& is, ColumnChange& column) {
  is.begin(air_heading, "atmosphere", Affects::photons);
  is.add(parameter(
             "danjon", column.danjon,
             "brightness of this eclipse on Danjon's scale, 0 (very dark) to 4 (bright): cloud and "
             "aerosol are scaled until the eclipse has it. Where no air does, the clearest air is "
             "taken"))
      .within(0, 4);
  is.add(parameter("ozone-du", column.ozone_du, "vertical column of ozone [DU], 0 to 1000"))
      .within(0, 1000);
  is.add(parameter("ozone-factor", column.ozone_factor,
                   "factor on that column of ozone, 0 to 10; of a region: on the ozone around it"))
      .within(0, 10);
  is.add(parameter("cloud-cover", column.cloud_cover,
                   "share of the Earth's limb where a deck of cloud stops the light, 0 to 1; "
                   "replaces the chance of cloud"))
      .within(0, 1);
  is.add(parameter("dust-extinction", column.dust_extinction_per_m,
                   "extinction of a grey layer of dust [1/m], 0 to 0.01: 1e-6 is slight, 4.7e-6 "
                   "usual, 1e-4 makes a dark eclipse"))
      .within(0, 0.01);
}

void describe(Parameters& is, AirRegion& region) {
  is.begin(air_heading, "atmosphere", Affects::photons);
  is.add(parameter("from-latitude", region.from_latitude, "southern edge [degrees], -90 to 90"))
      .within(-90, 90);
  is.add(parameter("to-latitude", region.to_latitude, "northern edge [degrees], -90 to 90"))
      .within(-90, 90);
  is.add(parameter("from-position-angle", region.from_position_angle,
                   "position angle about the shadow's axis at which it begins, from north through "
                   "east [degrees], -360 to 720"))
      .within(-360, 720);
  is.add(parameter("to-position-angle", region.to_position_angle,
                   "position angle at which it ends [degrees], -360 to 720"))
      .within(-360, 720);
  describe_sought(is, region.column);
  describe_layers(is, region.column);
}

void describe_terms(Parameters& is, Air& air) {
  using atmosphere::Density, atmosphere::Dispersion, atmosphere::KingFactor, atmosphere::OzonePath;
  is.begin(air_heading, "atmosphere", Affects::photons);
  Words<std::string> presets;
  for (const auto& name : atmosphere::preset_names()) presets.emplace_back(name, name);
  is.add(choice("atmosphere", air.atmosphere, presets,
                "air of the Earth. standard: that of the eclipse's month, by latitude; undated: "
                "the same everywhere and always; clear: air and ozone only; molecular: air only; "
                "paper: as in Yapo & Cutler (2009); none: the bare Earth"));
  is.add(choice("earth", air.earth,
                {{"sphere", EarthFigure::sphere}, {"ellipsoid", EarthFigure::ellipsoid}},
                "figure of the Earth"));
  is.add(choice("density", air.density,
                {{"seasonal", Density::seasonal},
                 {"us-1976", Density::us_1976},
                 {"yapo-cutler", Density::yapo_cutler}},
                "density of the air: seasonal (by latitude and season), us-1976 (to 86 km) or "
                "yapo-cutler (cut at 42 km)"));
  is.add(on_off("refraction", air.refraction, "bending of light in the Earth's air"));
  is.add(choice("dispersion", air.dispersion,
                {{"ciddor", Dispersion::ciddor_1996}, {"crc", Dispersion::crc}},
                "formula of the refractive index by wavelength"));
  is.add(on_off("rayleigh", air.rayleigh, "Rayleigh scattering out of the ray"));
  is.add(choice("king-factor", air.king_factor,
                {{"bates", KingFactor::bates_1984}, {"fixed", KingFactor::fixed}},
                "King factor of Rayleigh scattering: bates (by wavelength) or fixed (1.05)"));
  is.add(choice("ozone-path", air.ozone_path,
                {{"bent", OzonePath::bent}, {"filter", OzonePath::filter}},
                "ozone that a ray meets: bent (along its own path) or filter (the same for all "
                "rays)"));
  is.add(choice("ozone-profile", air.ozone_profile,
                {{"climatology", OzoneProfile::climatology}, {"us-1976", OzoneProfile::us_1976}},
                "height profile of ozone: climatology (by latitude and month) or us-1976"));
  is.add(on_off("oxygen-pairs", air.oxygen_pairs, "absorption by pairs of oxygen molecules"));
  is.add(on_off("oxygen-bands", air.oxygen_bands,
                "absorption by the bands of oxygen at 628, 688 and 762 nm"));
  is.add(on_off("nitrogen-dioxide", air.nitrogen_dioxide, "absorption by nitrogen dioxide"));
}

namespace {

/// Declares which parameters of the air require or exclude others. If a region or a step on Danjon's scale is
/// requested, nothing is required, because either may add aerosol, cloud or ozone that the preset atmosphere lacks.
void relate(Parameters& is) {
  using request::Conditions;
  const auto with = [](Conditions any) {
    any.insert(any.end(), {{"region"}, {"danjon"}});
    return any;
  };
  const request::Texts of_months{"standard", "calibrated"},
      with_aerosol{"standard", "calibrated", "undated"},
      with_ozone{"standard", "calibrated", "undated", "clear", "paper"};
  for (const char* edge : {"dust-bottom-km", "dust-top-km"})
    is.find(edge)->only_with(with({{"dust-extinction"}}));
  is.find("stratospheric-factor")
      ->only_with(with({{"atmosphere", with_aerosol}, {"stratospheric-aerosol"}}));
  is.find("cloud-top-km")->only_with(with({{"atmosphere", with_aerosol}, {"cloud-cover"}}));
  is.find("tropopause-km")
      ->only_with(with({{"atmosphere", of_months},
                        {"cloud-chance"},
                        {"cirrus"},
                        {"free-troposphere"},
                        {"stratospheric-aerosol"}}));
  for (const char* of_ozone : {"ozone-factor", "ozone-path"})
    is.find(of_ozone)->only_with(
        with({{"atmosphere", with_ozone}, {"ozone-du"}, {"ozone-profile", {"climatology"}}}));
  is.find("ozone-profile")->not_beside({{"ozone-path", {"filter"}}}, {"us-1976"});
  is.find("king-factor")->not_beside({{"rayleigh", {"off"}}});
  for (auto& term : is)
    if (term.name != "atmosphere" && term.name != "earth")
      term.not_beside({{"atmosphere", {"none"}}});
}

}  // namespace

void describe(Parameters& is, Air& air) {
  describe_terms(is, air);
  describe_sought(is, air.column);
  describe_layers(is, air.column);
  is.add(regions_of(air.regions));
  relate(is);
}

void describe_sunlight(Parameters& is, LightRequest& light) {
  is.begin(air_heading, "atmosphere", Affects::photons);
  is.add(on_off("limb-darkening", light.limb_darkening,
                "limb darkening of the Sun; off with atmosphere paper"));
  is.begin(air_heading, "atmosphere", Affects::light);
  is.add(choice("scattered-light", light.scattered_light,
                {{"auto", ScatteredLight::automatic},
                 {"on", ScatteredLight::on},
                 {"off", ScatteredLight::off}},
                "sunlight that the air scatters into the shadow; auto: where it counts"))
      .not_beside({{"leave-out"}}, {"auto", "on"});
  is.add(on_off("starlight", light.starlight, "light of the stars on the Moon"));
}

void describe(Parameters& is, Effort& effort) {
  is.begin(light_heading, "", Affects::light);
  is.add(choice("quality", effort.quality,
                {{"draft", "draft"},
                 {"standard", "standard"},
                 {"reference", "reference"},
                 {"paper", "paper"}},
                "error of luminance: draft (5 %), standard (1 %) or reference (0.05 %); paper: 1e7 "
                "literal photons, as Yapo & Cutler (2009)"))
      .not_beside({{"tolerance"}, {"budget"}}, {"standard", "reference"});
  is.add(parameter("tolerance", effort.tolerance,
                   "largest error of luminance on the disc, 0.01% to 50%, in place of quality"))
      .replaced_by_plan();
  is.add(parameter("budget", effort.budget,
                   "time for the light, as 500ms, 2s or 1min: the most exact that it allows is "
                   "made"))
      .replaced_by_plan();
}

plan::Wish wish_of(const Effort& effort) {
  plan::Wish wish;
  if (effort.tolerance && effort.quality != "standard")
    throw algebra::Error(fmt::format("tolerance = {}, allowed with quality standard, not {}",
                                     *effort.tolerance, effort.quality));
  if (effort.tolerance) wish.tolerance = tolerance_of(*effort.tolerance);
  if (effort.budget) wish.budget_s = budget_of(*effort.budget);
  if (!effort.tolerance && !effort.budget) wish.tolerance = tolerance_named(effort.quality);
  return wish;
}

void describe_knobs(Parameters& is, plan::ByHand& knobs) {
  is.begin(light_heading, "", Affects::light);
  is.add(parameter("bands", knobs.bands,
                   "number of wavelengths that light is computed at, 1 to 400"))
      .within(1, 400)
      .replaced_by_plan();
  is.begin(light_heading, "", Affects::photons);
  is.add(parameter("rays", knobs.rays,
                   "number of rays between the ground and the top of the air, for quadrature and "
                   "photons, 2 to 1e7"))
      .within(2, 1e7)
      .replaced_by_plan();
  is.begin(light_heading, "", Affects::light);
  is.add(parameter("sun-terms", knobs.sun_terms,
                   "number of terms of the Sun's limb darkening, 1 to 6; 6 is exact"))
      .within(1, 6)
      .not_beside({{"limb-darkening", {"off"}}})
      .not_beside(of_photons)
      .replaced_by_plan();
  is.add(parameter("planes", knobs.planes, "number of planes across the Moon's depth, 1 to 9"))
      .within(1, 9)
      .replaced_by_plan();
  is.add(parameter("place-error", knobs.place_error,
                   "error of light between the places where it is computed, 1e-5 to 1"))
      .within(1e-5, 1)
      .not_beside(of_photons)
      .replaced_by_plan();
  auto& chosen = knobs.terms;
  is.add(parsed(
             "leave-out", chosen, [&chosen] { return chosen ? terms_left_out(*chosen) : ""; },
             [&chosen](const std::string& list) { chosen = everything_but(list); },
             "terms to leave out: " + term_names()))
      .replaced_by_plan();
}

void describe_solver(Parameters& is, LightRequest& light) {
  is.begin(light_heading, "", Affects::photons);
  is.add(choice("solver", light.solver,
                {{"auto", Solver::automatic},
                 {"quadrature", Solver::quadrature},
                 {"photons", Solver::table},
                 {"literal", Solver::literal}},
                "quadrature (without noise), photons (by a table of the limb's rays), literal "
                "(photons step by step, each alone, as in the paper), or auto (the quickest; "
                "photons where photons is given)"))
      .not_beside(as_the_paper)
      .replaced_by_plan();
  is.begin(light_heading, "", Affects::light);
  is.add(parameter("photons", light.photons,
                   "number of photons, 1 to 1e12; default: as many as the tolerance needs. 1e6 "
                   "take a second by the table, literal ones minutes"))
      .within(1, 1e12)
      .only_with({{"solver", {"auto", "photons", "literal"}}, {"quality", {"paper"}}})
      .replaced_by_plan();
  is.begin(light_heading, "", Affects::photons);
  is.add(parameter("seed", light.seed, "seed of the photons")).only_with(of_photons);
  is.add(parameter("step-km", light.step_km, "step of a literal photon's path [km], 0.001 to 100"))
      .within(0.001, 100)
      .only_with({{"solver", {"literal"}}, {"quality", {"paper"}}});
  is.add(parameter("ring-km", light.ring_km,
                   "width of the rings that gather photons [km], 1 to 2000"))
      .within(1, 2000)
      .only_with(of_photons);
  is.begin(light_heading, "", Affects::light);
  is.add(parameter("smoothing-km", light.smoothing_km,
                   "standard deviation of the Gaussian that smooths photons [km], 0 to 2000; 0: "
                   "no smoothing"))
      .within(0, 2000)
      .only_with(of_photons);
}

AirRegion region_from(const std::string& text) {
  AirRegion region;
  Parameters parts;
  describe(parts, region);
  try {
    take_parts(parts, text);
    require_place(region);
  } catch (const algebra::Error& error) {
    throw algebra::Error(fmt::format("region '{}': {}", text, error.what()));
  }
  return region;
}

plan::Work everything_but(const std::string& list) {
  plan::Work work;
  for (const auto& term : known_terms) work.*term.in = true;
  if (list == "none") return work;
  std::istringstream names(list);
  for (std::string name; std::getline(names, name, ',');) {
    const auto term = std::ranges::find(known_terms, name, &Term::name);
    if (term == known_terms.end())
      throw algebra::Error(fmt::format("leave-out = {}, allowed {}", list, term_names()));
    work.*term->in = false;
  }
  return work;
}

namespace {

/// A setting in words, such as "ozone 300 DU" or "stratospheric aerosol extreme".
std::string in_words(std::string name, const std::string& value) {
  std::string unit;
  for (const auto& [ending, its_unit] : {std::pair{"-km", " km"}, std::pair{"-du", " DU"}})
    if (name.ends_with(ending)) name.resize(name.size() - 3), unit = its_unit;
  std::ranges::replace(name, '-', ' ');
  return name + ' ' + value + unit;
}

}  // namespace

std::string air_in_words(const Parameters& parameters) {
  std::string air = "standard air", changes;
  for (const auto& parameter : parameters) {
    if (parameter.table != "atmosphere" || !parameter.given) continue;
    const auto value = parameter.text();
    if (parameter.name == "atmosphere")
      air = value == "none" ? "no air" : value + " air";
    else if (const auto count = parameter.texts().size(); parameter.parts)
      changes += count == 1 ? ", 1 region" : fmt::format(", {} regions", count);
    else if (value != parameter.usual)
      changes += ", " + in_words(parameter.name, value);
  }
  return air + changes;
}

request::Recipe with_work(const request::Recipe& recipe, const plan::Work& work) {
  const bool photons = plan::traces_photons(work.solver);
  std::vector<request::Setting> knobs;
  const auto add = [&](const char* name, std::string text, bool bare) {
    knobs.push_back({.name = name, .texts = {std::move(text)}, .bare = bare});
  };
  const auto add_number = [&](const char* name, auto number) {
    add(name, fmt::format("{}", number), true);
  };
  add_number("bands", work.bands);
  add_number("rays", work.rays);
  add_number("sun-terms", work.sun_terms);
  add_number("planes", work.planes);
  add_number("place-error", work.place_error);
  add("leave-out", terms_left_out(work), false);
  add("solver",
      work.solver == Solver::literal ? "literal"
      : photons                      ? "photons"
                                     : "quadrature",
      false);
  if (photons) add_number("photons", work.photons);
  auto asked = recipe;
  for (auto& setting : asked)
    if (is_planned(setting)) setting.texts.clear();
  return request::with(std::move(knobs), asked);
}

bool is_planned(const request::Setting& setting) {
  static const auto planned = [] {
    Effort effort;
    LightRequest light;
    Parameters all;
    describe(all, effort);
    describe_knobs(all, light.by_hand);
    describe_solver(all, light);
    std::set<std::string, std::less<>> names;
    for (const auto& parameter : all)
      if (parameter.planned) names.insert(parameter.name);
    return names;
  }();
  return planned.contains(setting.name);
}

std::string photons_recipe(const Parameters& parameters) {
  return text_of(request::recipe_of(parameters, [](const request::Parameter& parameter) {
    return parameter.affects == Affects::photons;
  }));
}

}  // namespace coppermoon::uses
