// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "request/parameter.h"

namespace coppermoon::request {

struct Setting;

/// Settings in the order in which the TOML lists them, each name once.
using Recipe = std::vector<Setting>;

/// What a recipe says about one parameter.
struct Setting {
  std::string name{};
  Texts texts{};                ///< as Parameter::take expects them; empty if there is no value
  std::vector<Recipe> parts{};  ///< of each value that has parts, such as a region of the air
  bool bare = false;            ///< written without quotes in TOML: numbers, true and false
  std::string table{};  ///< table that it belongs to beside values with parts; empty if none
  Affects affects = Affects::ground;
  std::string where{};  ///< place in the file that was read: "moon.toml:3: "

  bool has_value() const { return !texts.empty() || !parts.empty(); }
};

/// Recipe for a request, including the values of parameters that were not given. Names of files to read are made fit
/// to be shared (files::name_to_share).
///
/// Given   chosen          which parameters to include; by default those that belong in recipes (in_recipes)
/// Throws  algebra::Error  if a region cannot be understood
Recipe recipe_of(const Parameters& parameters,
                 const std::function<bool(const Parameter&)>& chosen = in_recipes);

/// Recipe as TOML, one line per setting, followed by the tables of values that have parts.
std::string text_of(const Recipe& recipe);

/// Recipe read from a text in TOML. The key `model` in a table gives the parameter that has the table's name.
///
/// Given   file  name to show in errors: "<file>:<line>: …"
///         bare  names of settings, each on a line of its own, whose texts are not in quotes
/// Throws  algebra::Error  if the text is not TOML, exceeds 1 MiB, or has a zero byte, a name of 17 parts, or the same
///                         name twice
Recipe recipe_in(std::string text, const std::string& file = {}, const Texts& bare = {});

/// Setting with this name; nullptr if there is none.
const Setting* setting_in(const Recipe& recipe, const std::string& name);

/// Recipe with some values replaced or added. These come first, in their own order.
Recipe with(std::vector<Setting> values, const Recipe& recipe);

/// A parameter that differs between two recipes, and its value in each as TOML writes it; "none" if it has no value.
struct Difference {
  std::string name, first, second;
  bool of_parts = false;
};

/// Differences between two recipes, in the order of the first, then settings that only the second has.
///
/// Given  counts  which settings to compare: asked about the second recipe's setting, or the first's if the second
///                has none
std::vector<Difference> differences(
    const Recipe& first, const Recipe& second,
    const std::function<bool(const Setting&)>& counts = [](const Setting&) { return true; });

}  // namespace coppermoon::request
