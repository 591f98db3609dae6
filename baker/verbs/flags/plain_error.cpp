// SPDX-License-Identifier: MIT
#include "verbs/flags/plain_error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <sstream>
#include <string_view>
#include <vector>

#include "algebra/number.h"

namespace coppermoon::verbs {
namespace {

using Text = std::string;

/// Text before and behind another text in it.
struct Cut {
  Text before, behind;
};

std::optional<Cut> cut_at(const Text& text, std::string_view at) {
  const auto place = text.find(at);
  if (place == Text::npos) return std::nullopt;
  return Cut{text.substr(0, place), text.substr(place + at.size())};
}

/// "0" for "0.000000".
Text short_number(const Text& text) {
  const auto number = algebra::number_in(text);
  return number ? fmt::format("{:g}", *number) : text;
}

Text unexpected(const Text& arguments) {
  std::istringstream list(arguments);
  std::vector<Text> words{std::istream_iterator<Text>(list), {}};
  std::ranges::reverse(words);  // as they were typed
  return fmt::format("{}: unexpected argument{}", fmt::join(words, " "),
                     words.size() > 1 ? "s" : "");
}

/// "--quality: best not in {a,b}".
std::optional<Text> of_words(const Text& error) {
  const auto cut = cut_at(error, " not in {");
  const auto flag = cut ? cut_at(cut->before, ": ") : std::nullopt;
  if (!flag || !cut->behind.ends_with('}')) return std::nullopt;
  Text words;
  for (const char letter : cut->behind.substr(0, cut->behind.size() - 1))
    words += letter == ',' ? Text(", ") : Text(1, letter);
  return fmt::format("{} = {}, allowed {}", flag->before, flag->behind, words);
}

/// "--threads: Value 9999 not in range 0 to 512"; a range that ends nowhere is one of sizes.
std::optional<Text> of_range(const Text& error) {
  const auto value = cut_at(error, ": Value ");
  const auto range = value ? cut_at(value->behind, " not in range ") : std::nullopt;
  const auto ends = range ? cut_at(range->behind, " to ") : std::nullopt;
  if (!ends) return std::nullopt;
  const auto allowed = ends->behind.size() > 100
                           ? "a number, 0 or more"
                           : short_number(ends->before) + " to " + short_number(ends->behind);
  return fmt::format("{} = {}, allowed {}", value->before, range->before, allowed);
}

/// Error message for a missing option; positional ones go by their names in the help.
Text missing(const Text& flag) {
  if (flag == "--instant") return "INSTANT: missing; a moment is needed, as 2026-03-03";
  if (flag == "--eclipse") return "ECLIPSE: missing; a day is needed, as 2026-03-03";
  return flag + ": missing";
}

}  // namespace

Text plain_error(const Text& error) {
  if (const auto cut = cut_at(error, "not expected: ")) return unexpected(cut->behind);
  if (const auto text = of_range(error)) return *text;
  if (const auto text = of_words(error)) return *text;
  if (error.ends_with(" is required"))
    return missing(error.substr(0, error.size() - Text(" is required").size()));
  if (const auto cut = cut_at(error, ": 1 required "); cut && cut->behind.ends_with(" missing"))
    return cut->before + ": a value is missing";
  if (const auto cut = cut_at(error, " excludes "))
    return fmt::format("{} and {}: allowed one of the two", cut->before, cut->behind);
  if (const auto cut = cut_at(error, "Could not convert: "))
    return fmt::format("{}, allowed a number", cut->behind);
  if (const auto cut = cut_at(error, ", allowed "))  // "--width: -5, allowed …"
    if (const auto flag = cut_at(cut->before, ": ");
        flag && flag->before.starts_with("--") && flag->behind.find(' ') == Text::npos)
      return fmt::format("{} = {}, allowed {}", flag->before, flag->behind, cut->behind);
  return error;
}

}  // namespace coppermoon::verbs
