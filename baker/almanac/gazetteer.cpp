// SPDX-License-Identifier: MIT
#include "almanac/gazetteer.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "algebra/number.h"
#include "algebra/table.h"
#include "almanac/tables.h"

namespace coppermoon::almanac {
namespace {

using Rows = std::vector<std::vector<std::string>>;

/// A table without its heading.
Rows rows_of(std::string_view text) {
  auto rows = algebra::parse_text_table(text);
  rows.erase(rows.begin());
  return rows;
}

const Rows& cities() {
  static const Rows rows = rows_of(tables::cities());
  return rows;
}

const Rows& features() {
  static const Rows rows = rows_of(tables::lunar_features());
  return rows;
}

double number(const std::string& cell) { return algebra::number_in(cell).value(); }

City city_in(const std::vector<std::string>& row) {
  return {row[0],
          row[1],
          {algebra::degrees(number(row[2])), algebra::degrees(number(row[3])),
           algebra::metres(number(row[4]))},
          row[5]};
}

LunarFeature feature_in(const std::vector<std::string>& row) {
  return {row[0],
          {algebra::degrees(number(row[1])), algebra::degrees(number(row[2]))},
          algebra::kilometres(number(row[3]))};
}

bool holds_words(const std::string& name, const std::string& words) {
  return (" " + name + " ").find(" " + words + " ") != std::string::npos;
}

/// The first row of that name, or else the first that holds it as whole words.
///
/// Given  region  the second cell that the row must have; empty: any
const std::vector<std::string>* row_named(const Rows& rows, std::string_view name,
                                          std::string_view region = {}) {
  const auto wanted = plain_name(name), in = plain_name(region);
  if (wanted.empty()) return nullptr;
  const std::vector<std::string>* part = nullptr;
  for (const auto& row : rows) {
    if (!in.empty() && plain_name(row[1]) != in) continue;
    const auto plain = plain_name(row[0]);
    if (plain == wanted) return &row;
    if (part == nullptr && holds_words(plain, wanted)) part = &row;
  }
  return part;
}

std::vector<std::string> names_in(const Rows& rows) {
  std::vector<std::string> names;
  for (const auto& row : rows) names.push_back(row[0]);
  return names;
}

/// Cosine of the angle between two places at the Earth's centre.
double nearness(const Observer& a, const Observer& b) {
  const double north_a = algebra::in_radians(a.latitude), north_b = algebra::in_radians(b.latitude);
  const double apart = algebra::in_radians(a.longitude) - algebra::in_radians(b.longitude);
  return std::sin(north_a) * std::sin(north_b) +
         std::cos(north_a) * std::cos(north_b) * std::cos(apart);
}

}  // namespace

std::string plain_name(std::string_view name) {
  // letters of U+00C0 to U+017F without their accents
  constexpr std::string_view plain =
      "aaaaaaaceeeeiiiidnooooo-ouuuuytsaaaaaaaceeeeiiiidnooooo-ouuuuyty"
      "aaaaaaccccccccddddeeeeeeeeeegggggggghhhhiiiiiiiiiiiijjkkkllllllllll"
      "nnnnnnnnnoooooooorrrrrrssssssssttttttuuuuuuuuuuuuwwyyyzzzzzzs";
  std::string text;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto byte = static_cast<unsigned char>(name[i]);
    if (byte >= 0xC3 && byte <= 0xC5 && i + 1 < name.size()) {
      const auto next = static_cast<unsigned char>(name[++i]);
      text += plain.substr((byte - 0xC3U) * 64 + (next & 0x3FU)).front();
    } else {
      text += byte >= 'A' && byte <= 'Z' ? static_cast<char>(byte - 'A' + 'a') : name[i];
    }
  }
  return text;
}

std::optional<City> city_named(std::string_view name) {
  const auto slash = std::min(name.find('/'), name.size());
  const auto region = slash < name.size() ? name.substr(slash + 1) : std::string_view();
  const auto* row = row_named(cities(), name.substr(0, slash), region);
  return row != nullptr ? std::optional(city_in(*row)) : std::nullopt;
}

City nearest_city(const Observer& place) {
  return city_in(*std::ranges::max_element(
      cities(), {}, [&](const auto& row) { return nearness(place, city_in(row).place); }));
}

std::optional<LunarFeature> lunar_feature_named(std::string_view name) {
  const auto* row = row_named(features(), name);
  return row != nullptr ? std::optional(feature_in(*row)) : std::nullopt;
}

std::vector<City> largest_cities(std::size_t count) {
  std::vector<City> largest;
  for (std::size_t i = 0; i < std::min(count, cities().size()); ++i)
    largest.push_back(city_in(cities()[i]));
  return largest;
}

std::vector<LunarFeature> lunar_features() {
  std::vector<LunarFeature> all;
  for (const auto& row : features()) all.push_back(feature_in(row));
  return all;
}

std::vector<std::string> city_names() { return names_in(cities()); }

std::vector<std::string> lunar_feature_names() { return names_in(features()); }

}  // namespace coppermoon::almanac
