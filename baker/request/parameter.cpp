// SPDX-License-Identifier: MIT
#include "request/parameter.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <sstream>
#include <system_error>

#include "algebra/error.h"
#include "algebra/number.h"

namespace coppermoon::request {
namespace {

/// Result of parsing a string as a whole number.
template <class Whole>
struct Read {
  Whole value{};
  bool whole = false, too_large = false;
};

template <class Whole>
Read<Whole> whole_in(const std::string& text) {
  const auto end = text.data() + text.size();
  Read<Whole> read;
  const auto [rest, failed] = std::from_chars(text.data() + text.starts_with('+'), end, read.value);
  read.whole = failed == std::errc() && rest == end;
  read.too_large = failed == std::errc::result_out_of_range;
  return read;
}

template <class Whole>
std::string fault_of(const std::string& text) {
  const auto read = whole_in<Whole>(text);
  if (read.whole) return {};
  const bool number = algebra::number_in(text).has_value();
  if (std::is_unsigned_v<Whole> && number && text.starts_with('-'))
    return fmt::format("{}, allowed whole numbers, 0 or more", text);
  if (read.too_large)
    return fmt::format("{}, allowed {} to {}", text, std::numeric_limits<Whole>::min(),
                       std::numeric_limits<Whole>::max());
  return fmt::format("{}, allowed {}", text, number ? "whole numbers" : "a number");
}

/// A parameter's name as error messages show it: "step [km]" for "step-km", "cloud cover" for "cloud-cover".
std::string title_of(const Parameter& parameter) {
  auto title = parameter.name;
  const auto unit = unit_of(parameter);
  for (const auto* ending : {"-km", "-du"})
    if (!unit.empty() && title.ends_with(ending)) title.resize(title.size() - 3);
  std::ranges::replace(title, '-', ' ');
  return unit.empty() ? title : fmt::format("{} [{}]", title, unit);
}

bool is_part(const std::string& list, const std::string& value) {
  std::istringstream parts(list);
  for (std::string part; std::getline(parts, part, ',');)
    if (part == value) return true;
  return false;
}

bool holds(const Condition& condition, const Parameter& other) {
  const auto texts = other.texts();
  if (condition.values.empty()) return !texts.empty();
  return std::ranges::any_of(texts, [&](const std::string& text) {
    return std::ranges::any_of(condition.values, [&](const std::string& value) {
      return value.starts_with('.') ? text.ends_with(value) : is_part(text, value);
    });
  });
}

/// A condition in words, such as "--solver photons or literal".
std::string in_words(const Condition& condition, const std::string& name) {
  return condition.values.empty() ? name
                                  : fmt::format("{} {}", name, fmt::join(condition.values, " or "));
}

}  // namespace

std::string Parameter::text() const {
  const auto all = texts();
  return all.empty() ? std::string() : all.back();
}

void Parameter::take(const Texts& texts) {
  Texts alike;
  for (const auto& text : texts) {
    const auto fault = respelt ? "" : fault_in(kind, text);
    if (!fault.empty()) throw UnknownWord(fmt::format("{} = {}", name, fault));
    if (!words.empty() && !respelt) word_in(words, name, text);
    if (kind == Kind::presence && text == "false") continue;
    alike.push_back(respelt ? respelt(text) : spelt(kind, text));
    if (const auto number = algebra::number_in(alike.back()); range && number && is_number(kind))
      algebra::require_within(title_of(*this), *number, range->low, range->high);
  }
  write(alike);
  given = std::move(alike);
}

void Parameter::reset() {
  if (given) restore();
  given.reset();
}

std::string unit_of(const Parameter& parameter) {
  const auto& text = parameter.meaning;
  const auto begin = text.find('['), end = text.find(']');
  if (!is_number(parameter.kind) || begin == std::string::npos || end < begin) return {};
  return text.substr(begin + 1, end - begin - 1);
}

std::string fault_in(Kind kind, const std::string& text) {
  if (kind == Kind::whole) return fault_of<int>(text);
  if (kind == Kind::natural) return fault_of<std::size_t>(text);
  if (kind == Kind::number && !algebra::number_in(text))
    return fmt::format("{}, allowed a number", text);
  if (kind == Kind::presence && text != "true" && text != "false")
    return fmt::format("{}, allowed true or false", text);
  return {};
}

std::string spelt(Kind kind, const std::string& text) {
  if (kind == Kind::number)  // adding 0 turns -0 into 0, because TOML has no integer -0
    if (const auto number = algebra::number_in(text)) return fmt::format("{}", *number + 0.);
  if (kind == Kind::whole) return text_of(whole_in<int>(text).value);
  if (kind == Kind::natural) return text_of(whole_in<std::size_t>(text).value);
  return text;
}

std::string text_of(double value) { return fmt::format("{}", value); }
std::string text_of(int value) { return fmt::format("{}", value); }
std::string text_of(std::size_t value) { return fmt::format("{}", value); }
void read_text(const std::string& text, double& value) { value = algebra::number_in(text).value(); }
void read_text(const std::string& text, int& value) { value = whole_in<int>(text).value; }
void read_text(const std::string& text, std::size_t& value) {
  value = whole_in<std::size_t>(text).value;
}

std::string name_in(std::string_view spelling) {
  const auto dashes = spelling.rfind("--");
  return std::string(dashes == std::string_view::npos ? spelling : spelling.substr(dashes + 2));
}

std::size_t word_in(const Texts& words, const std::string& name, const std::string& text) {
  const auto found = std::ranges::find(words, text);
  if (found == words.end())
    throw UnknownWord(fmt::format("{} = {}, allowed {}", name, text, fmt::join(words, ", ")));
  return static_cast<std::size_t>(found - words.begin());
}

Parameter presence(const std::string& spelling, bool& value, std::string meaning) {
  Parameter made{.name = name_in(spelling),
                 .spelling = spelling,
                 .kind = Kind::presence,
                 .meaning = std::move(meaning)};
  made.read = [&value] { return value ? Texts{"true"} : Texts{}; };
  made.write = [&value](const Texts& texts) { value = !texts.empty() && texts.back() == "true"; };
  made.restore = [&value, first = value] { value = first; };
  return made;
}

void Parameters::begin(std::string heading, std::string table, Affects affects) {
  heading_ = std::move(heading);
  table_ = std::move(table);
  affects_ = affects;
}

Parameter& Parameters::add(Parameter parameter) {
  parameter.heading = heading_;
  parameter.table = table_;
  parameter.affects = affects_;
  if (!parameter.many) parameter.usual = parameter.text();
  return all_.emplace_back(std::move(parameter));
}

Parameter* Parameters::find(std::string_view name) {
  const auto found = std::ranges::find(all_, name, &Parameter::name);
  return found == all_.end() ? nullptr : &*found;
}

const Parameter* Parameters::find(std::string_view name) const {
  const auto found = std::ranges::find(all_, name, &Parameter::name);
  return found == all_.end() ? nullptr : &*found;
}

namespace {

/// Why a parameter has no effect, such as "without --camera" or "beside --unshadowed". Empty if it has an effect.
std::string reason_of(const Parameters& all, const Parameter& parameter,
                      const std::function<std::string(const Parameter&)>& spelt) {
  for (const auto& [needed, conditions, of] : parameter.relations) {
    if (!of.empty() && std::ranges::find(of, parameter.text()) == of.end()) continue;
    if (needed && conditions.empty()) return "in this command";
    std::vector<std::string> missing;
    bool met = false;
    for (const auto& condition : conditions) {
      const auto* other = all.find(condition.name);
      if (other == nullptr) continue;
      const auto words = in_words(condition, spelt(*other));
      if (holds(condition, *other)) {
        if (!needed) return "beside " + words;
        met = true;
      }
      missing.push_back(words);
    }
    if (needed && !met && !missing.empty())
      return fmt::format("without {}", fmt::join(missing, " or "));
  }
  return {};
}

}  // namespace

std::vector<std::string> without_effect(const Parameters& parameters,
                                        const std::function<std::string(const Parameter&)>& spelt,
                                        const std::function<bool(const Parameter&)>& asked) {
  std::vector<std::pair<std::string, std::string>> names;  // each reason with its parameters
  for (const auto& parameter : parameters) {
    if (!parameter.given || !asked(parameter)) continue;
    const auto reason = reason_of(parameters, parameter, spelt);
    if (reason.empty()) continue;
    auto known = std::ranges::find(names, reason, &std::pair<std::string, std::string>::first);
    if (known == names.end())
      names.emplace_back(reason, spelt(parameter));
    else
      known->second += ", " + spelt(parameter);
  }
  std::vector<std::string> lines;
  for (const auto& [reason, which] : names)
    lines.push_back(fmt::format("{}: no effect {}", which, reason));
  return lines;
}

void take_parts(Parameters& parts, const std::string& text) {
  for (auto& part : parts) part.reset();
  std::istringstream pairs(text);
  for (std::string pair; std::getline(pairs, pair, ',');) {
    const auto sign = pair.find('=');
    auto* part = parts.find(pair.substr(0, sign));
    if (part == nullptr) throw algebra::Error(fmt::format("{}: there is no such part", pair));
    if (sign == std::string::npos || sign + 1 == pair.size())
      throw algebra::Error(fmt::format("{}: a value is missing", part->name));
    part->take({pair.substr(sign + 1)});
  }
}

}  // namespace coppermoon::request
