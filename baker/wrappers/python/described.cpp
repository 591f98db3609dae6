// SPDX-License-Identifier: MIT
#include "wrappers/python/described.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "algebra/number.h"
#include "uses/light/light_parameters.h"
#include "uses/picture/picture_parameters.h"

namespace coppermoon::python {
namespace {

using request::Kind, request::Parameter, request::Parameters;

/// Parameters that have a different name in Python.
const std::map<std::string, std::string, std::less<>> renamed{
    {"region", "regions"}, {"spectral", "spectral_nm"}, {"texture-width", "width"}};

/// Parameters whose type has a name of its own in the type stub.
const std::map<std::string, std::string, std::less<>> aliases{
    {"space", "Space"}, {"stratospheric-aerosol", "Stratosphere"}};

bool are_numbers(const request::Texts& words) {
  return !words.empty() && std::ranges::all_of(words, [](const std::string& word) {
    return request::fault_in(Kind::whole, word).empty();
  });
}

std::string quoted(const std::string& text) {
  std::string literal = "'";
  for (const char c : text)
    literal += c == '\'' || c == '\\' ? std::string{'\\', c} : std::string{c};
  return literal + "'";
}

std::string float_literal(const std::string& number) {
  return number.find_first_of(".en") == std::string::npos ? number + ".0" : number;
}

std::string plain_type(const Parameter& parameter) {
  if (parameter.parts) return "list[Region]";
  if (const auto alias = aliases.find(parameter.name); alias != aliases.end()) return alias->second;
  switch (parameter.kind) {
    case Kind::number:
      return "float";
    case Kind::whole:
    case Kind::natural:
      return "int";
    case Kind::on_off:
    case Kind::presence:
      return "bool";
    case Kind::word:
      break;
    default:
      return "str";
  }
  if (are_numbers(parameter.words))
    return fmt::format("Literal[{}]", fmt::join(parameter.words, ", "));
  return fmt::format("Literal[\"{}\"]", fmt::join(parameter.words, "\", \""));
}

std::string python_word(std::string word) {
  if (const auto other = renamed.find(word); other != renamed.end()) return other->second;
  std::ranges::replace(word, '-', '_');
  return word;
}

/// Python type, as written in the type stub, for a value of the given kind.
std::string type_named(result::Kind kind, const result::Field& field) {
  using result::Kind;
  switch (kind) {
    case Kind::truth:
      return "bool";
    case Kind::whole:
      return "int";
    case Kind::number:
      return "float";
    case Kind::word:
      return fmt::format("Literal[\"{}\"]", fmt::join(field.words, "\", \""));
    case Kind::instant:
      return "datetime";
    case Kind::numbers:
      return "NDArray[np.float64]";
    case Kind::list:
      return fmt::format("list[{}]", type_named(field.of, field));
    case Kind::by_name:
      return fmt::format("dict[str, {}]", type_named(field.of, field));
    case Kind::object:
      return field.type;
    default:
      return "str";
  }
}

Parameters without_some(Parameters all, const std::function<bool(const Parameter&)>& dropped) {
  Parameters left;
  for (auto& parameter : all)
    if (!dropped(parameter)) left.keep(std::move(parameter));
  return left;
}

Parameters without(Parameters all, std::string_view name) {
  return without_some(std::move(all), [=](const Parameter& each) { return each.name == name; });
}

}  // namespace

Parameters parameters_of(uses::Air& air) {
  Parameters all;
  describe(all, air);
  return all;
}

Parameters parameters_of(uses::AirRegion& region) {
  Parameters all;
  describe(all, region);
  return all;
}

Parameters parameters_of(uses::LightRequest& light) {
  Parameters all;
  all.add(request::parameter("--tolerance", light.wish.tolerance,
                             "largest relative error of luminance on the disc, 1e-4 to 0.5"))
      .within(1e-4, 0.5)
      .usual.clear();  // no default, because users may set a time budget instead
  all.add(request::parameter("--budget-s", light.wish.budget_s,
                             "time that the light may take [s], 1e-3 to 1e7"))
      .within(1e-3, 1e7);
  uses::describe_knobs(all, light.by_hand);
  uses::describe_sunlight(all, light);
  uses::describe_solver(all, light);
  return all;
}

Parameters fit_keywords(TextureKeywords& keywords) {
  Parameters all;
  uses::describe_map(all, keywords.moon);
  uses::describe_response(all, keywords.moon.response);
  return all;
}

Parameters brightness_keywords(TextureKeywords& keywords) {
  auto all = fit_keywords(keywords);
  uses::describe_unshadowed(all, keywords.moon);
  uses::describe_observer(all, keywords.view);
  return without(without(std::move(all), "at"), "response");
}

Parameters bake_keywords(TextureKeywords& keywords) {
  Parameters all;
  uses::describe_width(all, keywords.moon);
  describe(all, keywords.content);
  uses::describe_response(all, keywords.moon.response);
  for (auto& parameter : brightness_keywords(keywords)) all.keep(std::move(parameter));
  return without(std::move(all), "type");
}

Parameters dome_keywords(DomeKeywords& keywords) {
  Parameters all;
  describe(all, keywords.dome);
  uses::describe_stars(all, keywords.moon.view);
  for (auto& parameter : brightness_keywords(keywords.moon)) all.keep(std::move(parameter));
  return without(std::move(all), "type");
}

std::string name_of(const Parameter& parameter) { return python_word(parameter.name); }

bool may_be_none(const Parameter& parameter) {
  return parameter.usual.empty() && !parameter.many && parameter.kind != Kind::presence;
}

std::string type_of(const Parameter& parameter) {
  return plain_type(parameter) + (may_be_none(parameter) ? " | None" : "");
}

std::string literal_of(const Parameter& parameter) {
  const auto text = parameter.text();
  if (parameter.parts) {
    std::vector<std::string> all;
    for (const auto& each : parameter.texts())
      all.push_back(text_of("Region", uses::region_from(each)));
    return fmt::format("[{}]", fmt::join(all, ", "));
  }
  if (parameter.kind == Kind::presence) return text == "true" ? "True" : "False";
  if (text.empty()) return "None";
  switch (parameter.kind) {
    case Kind::on_off:
      return text == "on" ? "True" : "False";
    case Kind::whole:
    case Kind::natural:
      return std::string(text);
    case Kind::number:
      return float_literal(text);
    case Kind::word:
      return are_numbers(parameter.words) ? text : quoted(text);
    case Kind::text:
      return algebra::number_in(text) ? float_literal(text) : quoted(text);
    default:
      return quoted(text);
  }
}

std::string meaning_of(const Parameter& parameter) {
  if (parameter.parts)
    return "parts of the Earth's limb with air of their own; the first that holds a place counts";
  std::string meaning, text = parameter.meaning;
  if (parameter.has_value()) text.resize(std::min(text.find("; default: "), text.size()));
  const bool named = std::ranges::all_of(parameter.words, [&](const std::string& word) {
    return text.find(word) != std::string::npos;
  });
  if (!named && parameter.kind == Kind::word)
    text += fmt::format(": {}", fmt::join(parameter.words, ", "));
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!text.substr(i).starts_with("--")) {
      meaning += text[i];
      continue;
    }
    std::string name;
    for (i += 2; i < text.size() && (std::islower(text[i]) || text[i] == '-'); ++i) name += text[i];
    meaning += python_word(name);
    --i;
  }
  return meaning;
}

std::string signature_of(const Parameters& parameters) {
  std::string text;
  for (const auto& parameter : parameters)
    text +=
        fmt::format("{}{}={}", text.empty() ? "" : ", ", name_of(parameter), literal_of(parameter));
  return text;
}

std::string lines_of(const Parameters& parameters) {
  std::string text;
  for (const auto& parameter : parameters)
    text += fmt::format("{}: {}\n", name_of(parameter), meaning_of(parameter));
  return text;
}

std::string type_of(const result::Field& field) {
  return type_named(field.kind, field) + (field.may_be_none ? " | None" : "");
}

std::string lines_of(const result::Fields& fields) {
  std::string text;
  for (const auto& field : fields.all)
    text += fmt::format("{}: {}\n", field.key, result::meaning_of(field));
  return text;
}

template <class Request>
std::string text_of(const std::string& type, Request request) {
  Request fresh;
  const auto defaults = parameters_of(fresh);
  return fmt::format("{}({})", type,
                     signature_of(without_some(parameters_of(request), [&](const Parameter& each) {
                       return each.texts() == defaults.find(each.name)->texts();
                     })));
}

template std::string text_of(const std::string&, uses::Air);
template std::string text_of(const std::string&, uses::AirRegion);
template std::string text_of(const std::string&, uses::LightRequest);

}  // namespace coppermoon::python
