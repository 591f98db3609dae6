// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "request/parameter.h"

namespace coppermoon::request {

struct Setting;

/// The settings in a recipe, in the order of the TOML file. No name occurs twice.
using Recipe = std::vector<Setting>;

/// What a recipe says about one parameter.
struct Setting {
  std::string name{};
  Texts texts{};                ///< values as Parameter::take expects them; empty if there are none
  std::vector<Recipe> parts{};  ///< values that have parts, such as regions of the air
  bool bare = false;            ///< whether TOML needs no quotes: for numbers, true and false
  std::string table{};  ///< TOML table in which the setting stands; empty if it stands in none
  Affects affects = Affects::ground;
  std::string where{};  ///< file and line of the setting, such as "moon.toml:3: "

  bool has_value() const { return !texts.empty() || !parts.empty(); }
};

/// Makes the recipe for a request, including the values of parameters that were not given. Names of input files lose
/// the user's private folders (files::name_to_share).
///
/// Given   chosen          which parameters to include; by default those that belong in recipes (in_recipes)
/// Throws  algebra::Error  if the text for a region of the air cannot be parsed
Recipe recipe_of(const Parameters& parameters,
                 const std::function<bool(const Parameter&)>& chosen = in_recipes);

/// A recipe as TOML: one line per setting, then the tables for values that have parts.
std::string text_of(const Recipe& recipe);

/// Reads a recipe from TOML. In a table, the key `model` sets the parameter that has the same name as the table.
///
/// Given   file  name to show in errors: "<file>:<line>: …"
///         bare  names of settings whose values are not in quotes; each is on a line of its own
/// Throws  algebra::Error  if the text is not TOML, exceeds 1 MiB, or has a zero byte, a name of more than 16 parts, or
///                         the same name twice
Recipe recipe_in(std::string text, const std::string& file = {}, const Texts& bare = {});

/// The setting with a given name; nullptr if there is none.
const Setting* setting_in(const Recipe& recipe, const std::string& name);

/// A recipe in which some settings are replaced or added. The new settings come first, in the given order.
Recipe with(std::vector<Setting> values, const Recipe& recipe);

/// A parameter that differs between two recipes, with its values as TOML writes them; "none" stands for no value.
struct Difference {
  std::string name, first, second;
  bool of_parts = false;
};

/// Differences between two recipes, in the order of the first recipe. Settings that are only in the second come last.
///
/// Given  counts  whether to compare a setting; called with the second recipe's setting if there is one, otherwise with
///                the first recipe's
std::vector<Difference> differences(
    const Recipe& first, const Recipe& second,
    const std::function<bool(const Setting&)>& counts = [](const Setting&) { return true; });

}  // namespace coppermoon::request
