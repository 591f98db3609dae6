// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "request/parameter.h"

namespace coppermoon::request {

/// A parameter's value as one line of a recipe, "ozone-du = 300"; empty: no value.
std::string recipe_line(const Parameter& parameter);

/// Parameters as a recipe, in TOML, with the values of those that were not given too. Names of files that are
/// read stand in their form for sharing (files::name_to_share).
///
/// Given   chosen          parameters that it holds; without: those that recipes hold (in_recipes)
/// Throws  algebra::Error  when a region cannot be understood
std::string recipe_of(const Parameters& parameters,
                      const std::function<bool(const Parameter&)>& chosen = in_recipes);

/// A recipe, as recipe_of writes it, without some of the parameters that stand above its tables.
std::string without(const std::string& recipe,
                    const std::function<bool(const std::string& name)>& dropped);

/// A recipe with a texture's width in place of any that it has.
std::string with_width(const std::string& recipe, std::size_t width);

/// A parameter that differs between two recipes, and its value in each; "none" where one says nothing.
struct Difference {
  std::string name, first, second;
};

/// Differences of two recipes, in the order of the first, then those in the second alone. All regions count as one
/// value, that of "regions".
std::vector<Difference> differences(const std::string& first, const std::string& second);

/// Text in TOML that stays on its line.
std::string quoted(const std::string& text);

}  // namespace coppermoon::request
