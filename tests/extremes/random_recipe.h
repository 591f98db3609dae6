// SPDX-License-Identifier: MIT
// Random recipes, drawn from what the program says of its parameters (coppermoon describe --json).
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "algebra/random.h"

namespace coppermoon::extremes {

using algebra::Random;
using Value = std::function<std::string(Random&)>;  ///< a value as TOML spells it

inline double between(Random& random, double low, double high) {
  return low + (high - low) * random.uniform();
}

template <typename List>
auto one_of(Random& random, const List& list) {
  return list[static_cast<std::size_t>(random.uniform() * static_cast<double>(std::size(list)))];
}

/// A number of a range: often an end of it, seldom beyond; of one that spans decades, evenly in its logarithm.
inline Value number(double low, double high) {
  return [low, high](Random& random) {
    const double which = random.uniform();
    if (which < 0.06) return fmt::format("{}", low);
    if (which < 0.12) return fmt::format("{}", high);
    if (which < 0.13) return fmt::format("{}", low - 1 - std::abs(low));
    if (which < 0.14) return fmt::format("{}", 2 * std::abs(high) + 1);
    if (low > 0 && high > 100 * low)
      return fmt::format("{}", low * std::pow(high / low, random.uniform()));
    return fmt::format("{}", between(random, low, high));
  };
}

inline Value integer(double low, double high) {
  return [low, high](Random& random) {
    return fmt::format("{:.0f}", std::stod(number(low, high)(random)));
  };
}

inline Value word(std::vector<std::string> words) {
  return [words = std::move(words)](Random& random) {
    return fmt::format("\"{}\"", one_of(random, words));
  };
}

/// Near the middle of an eclipse; seldom any moment.
inline std::string random_instant(Random& random) {
  constexpr std::array days{"1963-12-30T11:0", "1982-07-06T07:3", "1992-12-09T23:4",
                            "2000-07-16T13:5", "2004-10-28T03:0", "2007-03-03T23:2",
                            "2008-02-21T03:2", "2009-02-09T14:3", "2010-12-21T08:1",
                            "2011-06-15T20:1", "2015-09-28T02:4", "2018-07-27T20:2",
                            "2021-11-19T09:0", "2029-12-20T22:4", "2048-01-01T06:5"};
  if (random.uniform() < 0.03)
    return fmt::format("{:04.0f}-{:02.0f}-{:02.0f}T{:02.0f}:00:00Z", between(random, 1, 3000),
                       between(random, 0, 13), between(random, 0, 32), between(random, 0, 24));
  return fmt::format("{}{:.0f}:{:02.0f}Z", one_of(random, days), between(random, -0.5, 9.4),
                     between(random, 0, 59));
}

inline std::string number_or(Random& random, double low, double high,
                             std::vector<std::string> words) {
  return random.uniform() < 0.5 ? word(std::move(words))(random)
                                : fmt::format("\"{}\"", number(low, high)(random));
}

/// Keys whose values the description does not tell, or for all of which a sweep has no time.
inline const std::map<std::string, Value>& values_by_hand() {
  static const std::map<std::string, Value> all{
      {"instant", random_instant},
      {"zone", word({"local", "Europe/Berlin", "-10:00", "Moon/Tycho"})},
      {"at",
       [](Random& r) {
         return fmt::format("\"{},{}\"", number(-90, 90)(r), number(-180, 180)(r));
       }},
      {"stratospheric-aerosol",
       [](Random& r) {
         return number_or(r, 0, 2, {"dated", "none", "background", "moderate", "high", "extreme"});
       }},
      {"glow", [](Random& r) { return number_or(r, 0, 0.5, {"auto"}); }},
      {"sky",
       [](Random& r) {
         return number_or(r, 0, 30, {"auto", "off", "dark"});
       }},
      {"stars",
       [](Random& r) {
         return number_or(r, -5, 20, {"on", "off"});
       }},
      {"field", [](Random& r) { return number_or(r, 1e-8, 179.9, {"moon"}); }},
      {"time",
       [](Random& r) {
         return number_or(r, 1e-6, 1e6, {"auto", "follow", "composite", "1/30"});
       }},
      {"tolerance",
       [](Random& r) { return fmt::format("\"{}%\"", std::pow(10., between(r, 0, 1.69))); }},
      {"budget", word({"1ms", "50ms", "0.3s", "0.01min", "1 fortnight"})},
      {"quality", word({"draft", "standard", "the best"})},
      {"leave-out",
       word({"none", "ellipsoid", "refracted-light", "regions,scattered-light", "the-moon"})},
      {"rays", integer(2, 1500)},
      {"place-error", number(1e-3, 1)},
      {"seed", integer(0, 1e9)},
      {"step-km", number(0.3, 100)},
      {"ring-km", number(10, 2000)},
      {"albedo-map", word({"built-in"})},
      {"width", integer(8, 64)},
      {"height", integer(8, 64)},
      {"texture-width",
       [](Random& r) { return fmt::format("{}", 2 * std::stoi(integer(2, 32)(r))); }},
      {"space", word({"lin_rec709", "acescg", "lin_ciexyzd65_scene", "srgb"})},
      {"spectral",
       [](Random& r) {
         return one_of(r, std::array{"1", "7", "10", "40", "100", "400"});
       }},
      {"camera", word({"paper", "400mm", "schmidt-cassegrain", "refractor", "pinhole"})},
      {"response",
       word({"colorimetric", "luminance", "canon-300d", "canon-6d", "canon-5d3", "sony-a7r2",
             "canon-eos-600d", "sony-ilce-7sm2", "fujifilm-x-t3", "eye", "lost.csv"})},
      {"black-level", number(0, 2000)},
      {"noise-seed", integer(0, 1e9)},
      {"view", word({"Hue-preserving", "Un-tone-mapped", "Filmic", "Raw", "Sepia"})},
      {"display", word({"sRGB", "Rec.1886 Rec.709 - Display", "Paper"})},
      {"wavelengths", word({"550", "450,550,650", "380,780", "380,379"})},
      {"axis-distances", word({"0", "0,2000,4000", "4700", "4000,0"})},
      {"dust-extinction", number(1e-9, 0.01)},
  };
  return all;
}

/// Keys that no recipe draws by itself, and why.
inline const std::map<std::string, std::string>& keys_left_out() {
  static const std::map<std::string, std::string> all{
      {"config", "names a file; end_to_end/personal_settings and extremes/inputs try many"},
      {"config-space", "needs a config"},
      {"from", "of a light curve; end_to_end/json and uses/picture/brightness have many"},
      {"to", "as from"},
      {"solver", "drawn with photons, in a number that a sweep has time for"},
      {"photons", "drawn with solver"},
      {"region", "drawn as tables of its parts"},
  };
  return all;
}

/// How often a key is drawn, where it is not `usual_chance`.
inline double chance_of(const std::string& key) {
  constexpr double usual_chance = 0.12;
  static const std::map<std::string, double> others{
      {"instant", 1},     {"albedo-map", 1},   {"texture-width", 1}, {"width", 1},
      {"height", 1},      {"tolerance", 0.85}, {"atmosphere", 0.5},  {"quality", 0.03},
      {"calendar", 0.03}, {"zone", 0.03},      {"danjon", 0.06},     {"budget", 0.06},
      {"camera", 0.6}};
  const auto found = others.find(key);
  return found == others.end() ? usual_chance : found->second;
}

/// Value of a parameter by hand, else from its words or range; without either, none.
inline Value value_of(const nlohmann::json& parameter) {
  const auto kind = parameter.at("kind").get<std::string>();
  if (const auto found = values_by_hand().find(parameter.at("name"));
      found != values_by_hand().end())
    return found->second;
  if (kind == "presence") return [](Random&) { return std::string("true"); };
  if (parameter.contains("words"))
    return word(parameter.at("words").get<std::vector<std::string>>());
  if (!parameter.contains("range")) return {};
  const double low = parameter.at("range")[0], high = parameter.at("range")[1];
  return kind == "number" ? number(low, high) : integer(low, high);
}

inline bool is_drawn(const nlohmann::json& parameter) {
  return parameter.at("recipe").get<bool>() && !keys_left_out().contains(parameter.at("name"));
}

/// A command of the sweep, and what it makes.
struct Command {
  const char *name, *output;
  double chance;
};

constexpr std::array commands{Command{"bake", "moon.exr", 0.6},   Command{"brightness", "", 0.1},
                              Command{"shadow", "", 0.12},        Command{"scene", "folder", 0.07},
                              Command{"still", "moon.png", 0.08}, Command{"plan", "", 0.03}};

struct RandomRecipe {
  Command command;
  std::string text;
  /// Parameters that it gives, those of regions as "region.to-latitude"
  std::set<std::string> keys;
};

/// Recipes of the parameters that a program describes.
class RandomRecipes {
 public:
  /// Given  description  what `coppermoon describe --json` says
  explicit RandomRecipes(const nlohmann::json& description) {
    for (const auto& command : description.at("commands"))
      parameters_[command.at("name")] = command.at("parameters");
  }

  const nlohmann::json& parameters(const std::string& command) const {
    return parameters_.at(command);
  }

  RandomRecipe recipe(std::uint64_t seed, std::uint64_t index) const {
    Random random(seed, index);
    double which = random.uniform();
    std::size_t chosen = 0;
    while (chosen + 1 < commands.size() && which >= commands[chosen].chance)
      which -= commands[chosen++].chance;
    RandomRecipe made{commands[chosen], {}, {}};
    const bool in_table = random.uniform() < 0.4;
    std::string air;
    bool without_camera = false;  // what a camera has stands behind it
    for (const auto& parameter : parameters(made.command.name)) {
      if (without_camera && parameter.value("table", "") == "camera") continue;
      add(random, parameter, in_table, made, air);
      if (parameter.at("name") == "camera") without_camera = !made.keys.contains("camera");
    }
    if (random.uniform() < 0.15) add_photons(random, made);
    if (in_table && made.keys.contains("atmosphere"))
      made.text += "[atmosphere]\n" + air;
    else
      made.text += air;
    if (!in_table && made.keys.contains("atmosphere")) return made;  // either a word or a table
    while (random.uniform() < 0.35) add_region(random, made);
    return made;
  }

 private:
  static void add(Random& random, const nlohmann::json& parameter, bool in_table,
                  RandomRecipe& made, std::string& air) {
    const std::string name = parameter.at("name");
    if (!is_drawn(parameter) || random.uniform() >= chance_of(name)) return;
    const auto value = value_of(parameter);
    if (!value) return;
    const bool of_air = parameter.value("table", "") == "atmosphere";
    const auto key = of_air && in_table && name == "atmosphere" ? "model" : name;
    (of_air ? air : made.text) += fmt::format("{} = {}\n", key, value(random));
    made.keys.insert(name);
  }

  /// Photons in a number that a sweep has time for.
  void add_photons(Random& random, RandomRecipe& made) const {
    const auto& all = parameters(made.command.name);
    const auto known =
        std::ranges::any_of(all, [](const auto& one) { return one.at("name") == "photons"; });
    if (!known) return;
    const std::string solver = one_of(random, std::array{"literal", "photons"});
    made.text += fmt::format("solver = \"{}\"\nphotons = {}\n", solver,
                             number(1, solver == "literal" ? 2e3 : 2e4)(random));
    made.keys.insert({"solver", "photons"});
  }

  /// A region with both edges of a latitude or a position angle, seldom one; and some air.
  void add_region(Random& random, RandomRecipe& made) const {
    const auto& all = parameters(made.command.name);
    const auto region =
        std::ranges::find_if(all, [](const auto& one) { return one.at("name") == "region"; });
    const bool by_latitude = random.uniform() < 0.5;
    made.text += "[[atmosphere.region]]\n";
    for (const auto& part : region->at("parts")) {
      const std::string name = part.at("name");
      const bool edge = name.ends_with("-latitude") || name.ends_with("-position-angle"),
                 chosen = name.ends_with("-latitude") == by_latitude;
      if (random.uniform() >= (edge ? (chosen ? 0.99 : 0.01) : chance_of(name))) continue;
      const auto value = value_of(part);
      if (!value) continue;
      made.text += fmt::format("{} = {}\n", name, value(random));
      made.keys.insert("region." + name);
    }
    made.keys.insert("region");
  }

  std::map<std::string, nlohmann::json> parameters_;
};

}  // namespace coppermoon::extremes
