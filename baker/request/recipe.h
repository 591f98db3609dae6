// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "request/parameter.h"

namespace coppermoon::request {

struct Setting;

/// Settings in the order in which TOML lists them, each name once.
using Recipe = std::vector<Setting>;

/// What a recipe says of one parameter.
struct Setting {
  std::string name{};
  Texts texts{};                ///< as Parameter::take has them; none: no value
  std::vector<Recipe> parts{};  ///< of each value, where values have parts, as regions of the air
  bool bare = false;            ///< in TOML without quotes: numbers, true and false
  std::string table{};          ///< that it is in, or would be in beside values with parts; empty: none
  Affects affects = Affects::ground;
  std::string where{};  ///< "moon.toml:3: " of a recipe that was read

  bool has_value() const { return !texts.empty() || !parts.empty(); }
};

/// Recipe of a request, with the values of parameters that were not given too. Names of files that are read are in
/// their form for sharing (files::name_to_share).
///
/// Given   chosen          parameters that it holds; without: those that recipes hold (in_recipes)
/// Throws  algebra::Error  when a region cannot be understood
Recipe recipe_of(const Parameters& parameters,
                 const std::function<bool(const Parameter&)>& chosen = in_recipes);

/// Recipe in TOML, one line a setting; behind them, where values have parts, the table that these are in.
std::string text_of(const Recipe& recipe);

/// Recipe that a text in TOML holds. A table's key `model` is the parameter of the table's name.
///
/// Given   file  for errors: "<file>:<line>: …"
///         bare  names of settings, each on a line of its own, whose texts are without quotes
/// Throws  algebra::Error  for a text that is no TOML, has more than 1 MiB, a zero byte or a name of 17 parts; for a
///                         name that is there twice
Recipe recipe_in(std::string text, const std::string& file = {}, const Texts& bare = {});

/// Setting of that name; null: none.
const Setting* setting_in(const Recipe& recipe, const std::string& name);

/// Recipe with values in place of those that it has of the same names: first, in their order.
Recipe with(std::vector<Setting> values, const Recipe& recipe);

/// A parameter that differs between two recipes, and its value in each as TOML writes it; "none" where one has none.
struct Difference {
  std::string name, first, second;
  bool of_parts = false;
};

/// Differences of two recipes, in the order of the first, then those in the second alone.
///
/// Given  counts  which settings do: asked of the second's, of the first's where the second has none
std::vector<Difference> differences(
    const Recipe& first, const Recipe& second,
    const std::function<bool(const Setting&)>& counts = [](const Setting&) { return true; });

}  // namespace coppermoon::request
