// SPDX-License-Identifier: MIT
#include "almanac/gazetteer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>

#include "algebra/error.h"
#include "algebra/number.h"
#include "algebra/table.h"
#include "almanac/tables.h"

namespace coppermoon::almanac {
namespace {

using Rows = std::vector<std::vector<std::string>>;

/// The rows of a table, without its header. Each row gets a last cell with its name in lower case, without accents.
Rows rows_of(std::string_view text, std::size_t name_column = 0) {
  auto rows = algebra::parse_text_table(text);
  rows.erase(rows.begin());
  for (auto& row : rows) row.push_back(plain_name(row[name_column]));
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

/// The path of the file with the user's own cities; an empty path if the user has no home folder.
std::filesystem::path own_cities_file() {
  const auto variable = [](const char* name) -> std::filesystem::path {
    const char* const value = std::getenv(name);
    return value == nullptr ? "" : value;
  };
  if (const auto xdg = variable("XDG_CONFIG_HOME"); xdg.is_absolute())
    return xdg / "coppermoon" / "cities.csv";
  if (const auto windows = variable("APPDATA"); windows.is_absolute())
    return windows / "coppermoon" / "cities.csv";
  const auto home = variable("HOME");
  return home.empty() ? home : home / ".config" / "coppermoon" / "cities.csv";
}

/// Reads and checks the rows of the user's own file of cities. The file may or may not have a heading.
Rows own_rows() {
  const auto path = own_cities_file();
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  const auto text = bytes.str();
  auto rows = algebra::parse_text_table(algebra::utf8_text(text, path.string()));
  std::erase_if(rows, [](const auto& row) { return row[0] == "name"; });
  for (auto& row : rows) {
    const bool sound = row.size() == 6 && !row[0].empty() && algebra::number_in(row[2]) &&
                       algebra::number_in(row[3]) && algebra::number_in(row[4]) && !row[5].empty();
    if (!sound)
      throw algebra::Error(fmt::format(
          "{}: \"{}\" is no city, allowed name,region,latitude,longitude,elevation,zone in degrees "
          "and metres, as My garden,Berlin,52.52,13.41,43,Europe/Berlin",
          path.string(), fmt::join(row, ",")));
    try {
      require_on_earth(city_in(row).place);
    } catch (const algebra::Error& error) {
      throw algebra::Error(fmt::format("{}: {}: {}", path.string(), row[0], error.what()));
    }
  }
  return rows;
}

const Rows& own_cities() {
  static const Rows rows = own_rows();
  return rows;
}

City own_city_in(const std::vector<std::string>& row) {
  auto city = city_in(row);
  city.own = true;
  return city;
}

LunarFeature feature_in(const std::vector<std::string>& row) {
  return {row[0],
          {algebra::degrees(number(row[1])), algebra::degrees(number(row[2]))},
          algebra::kilometres(number(row[3]))};
}

/// A name with ä, ö and ü written as ae, oe and ue.
std::string without_umlauts(std::string_view name) {
  constexpr std::pair<std::string_view, std::string_view> umlauts[] = {
      {"ä", "ae"}, {"ö", "oe"}, {"ü", "ue"}, {"Ä", "ae"}, {"Ö", "oe"}, {"Ü", "ue"}};
  std::string text(name);
  for (const auto& [letter, spelt] : umlauts)
    for (auto at = text.find(letter); at != std::string::npos; at = text.find(letter))
      text.replace(at, letter.size(), spelt);
  return text;
}

bool is_name(const std::string& known, std::string_view name) {
  const auto plain = plain_name(known);
  return plain == plain_name(name) || plain == plain_name(without_umlauts(name));
}

/// A region, state or country.
struct Area {
  std::vector<std::string> regions;  ///< plain names of the regions in this area
  std::string time_zones = " ";      ///< IANA names, with a space before and after each
};

/// The area with a given name, which may be a region's name or a name in areas.csv. Dots, as in "D.C.", are ignored.
Area area_named(std::string_view name) {
  static const Rows rows = rows_of(tables::areas());
  const auto plain = plain_name(name);
  auto undotted = plain;
  std::erase(undotted, '.');
  Area area{{plain}};
  for (const auto& row : rows) {
    if (("/" + row.back() + "/").find("/" + undotted + "/") == std::string::npos) continue;
    if (!row[1].empty()) area.regions.push_back(plain_name(row[1]));
    if (!row[2].empty()) area.time_zones += row[2] + " ";
  }
  return area;
}

/// Reads the areas that follow a city's name: one area, or several separated by commas, as in "Illinois, USA".
std::vector<Area> areas_in(std::string_view text) {
  std::vector<Area> areas;
  std::istringstream parts{std::string(text)};
  for (std::string part; std::getline(parts, part, ',');)
    areas.push_back(area_named(algebra::without_spaces(part)));
  return areas;
}

bool is_in(const std::vector<Area>& areas, const std::vector<std::string>& city) {
  return std::ranges::all_of(areas, [&](const Area& area) {
    return std::ranges::find(area.regions, plain_name(city[1])) != area.regions.end() ||
           area.time_zones.find(" " + city[5] + " ") != std::string::npos;
  });
}

/// The rows with a given name or, if there are none, the rows whose names contain it as whole words.
///
/// Given  areas  the city must be in all of these areas
Rows rows_named(const Rows& rows, std::string_view name, const std::vector<Area>& areas = {}) {
  const auto wanted = plain_name(name), spelt = plain_name(without_umlauts(name)),
             whole_words = " " + wanted + " ";
  if (wanted.empty()) return {};
  Rows all, parts;
  for (const auto& row : rows) {
    if (!is_in(areas, row)) continue;
    const auto& plain = row.back();
    if (plain == wanted || plain == spelt) all.push_back(row);
    if ((" " + plain + " ").find(whole_words) != std::string::npos) parts.push_back(row);
  }
  return all.empty() ? parts : all;
}

/// The name that the gazetteer uses for a city, such as "Vienna" for "Wien".
std::string known_name(std::string_view name) {
  static const Rows others = rows_of(tables::city_other_names(), 1);
  const auto plain = plain_name(name);
  for (const auto& row : others)
    if (row.back() == plain) return row[0];
  return std::string(name);
}

/// Splits a string at its first slash or comma into a city's name and its areas. If there is neither a slash nor a
/// comma, the areas are empty.
std::pair<std::string_view, std::string_view> name_and_region(std::string_view text) {
  const auto end = text.find_first_of("/,");
  if (end == std::string_view::npos) return {algebra::without_spaces(text), {}};
  return {algebra::without_spaces(text.substr(0, end)),
          algebra::without_spaces(text.substr(end + 1))};
}

std::string as_written(const City& city) { return city.name + "/" + city.region; }

/// A list of at most the first five words, separated by commas, followed by the number of words that are left out.
std::string listed(std::vector<std::string> words) {
  constexpr std::size_t most = 5;
  const auto left = words.size() > most ? words.size() - most : 0;
  words.resize(words.size() - left);
  return fmt::format("{}{}", fmt::join(words, ", "),
                     left > 0 ? fmt::format(" and {} more", left) : "");
}

std::vector<std::string> names_in(const Rows& rows) {
  std::vector<std::string> names;
  for (const auto& row : rows) names.push_back(row[0]);
  return names;
}

/// Cosine of the angle between two places, as seen from the Earth's centre.
double nearness(const Observer& a, const Observer& b) {
  const double north_a = algebra::in_radians(a.latitude), north_b = algebra::in_radians(b.latitude);
  const double apart = algebra::in_radians(a.longitude) - algebra::in_radians(b.longitude);
  return std::sin(north_a) * std::sin(north_b) +
         std::cos(north_a) * std::cos(north_b) * std::cos(apart);
}

}  // namespace

std::string plain_name(std::string_view name) {
  // the letters from U+00C0 to U+017F without their accents
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
    } else if (byte == 0xC8 && i + 1 < name.size() && name[i + 1] >= '\x98' &&
               name[i + 1] <= '\x9B') {
      text += "sstt"[static_cast<unsigned char>(name[++i]) - 0x98];  // Romanian s, t with a comma
    } else if ((byte == 0xCC || byte == 0xCD) && i + 1 < name.size()) {
      ++i;  // skip a combining accent, which follows its letter
    } else {
      text += byte >= 'A' && byte <= 'Z' ? static_cast<char>(byte - 'A' + 'a') : name[i];
    }
  }
  return text;
}

std::vector<City> cities_named(std::string_view name) {
  const auto [city, region] = name_and_region(name);
  const auto areas = areas_in(region);
  std::vector<City> all;
  for (const auto& row : own_cities())
    if (is_name(row[0], city) && is_in(areas, row)) all.push_back(own_city_in(row));
  for (const auto& row : rows_named(cities(), known_name(city), areas)) all.push_back(city_in(row));
  return all;
}

std::optional<City> city_named(std::string_view name) {
  const auto all = cities_named(name);
  return all.empty() ? std::nullopt : std::optional(all.front());
}

/// Rank of a city by population; the largest city has rank 1.
static std::ptrdiff_t rank_of(const City& city) {
  const auto found = std::ranges::find_if(
      cities(), [&](const auto& row) { return row[0] == city.name && row[1] == city.region; });
  return found - cities().begin() + 1;
}

std::string city_taken(std::string_view name) {
  constexpr int far_smaller = 10;  // ratio of ranks; population is roughly proportional to 1 / rank
  auto all = cities_named(name);
  if (all.empty() || all.front().own) return {};
  const auto known = known_name(name_and_region(name).first);
  if (is_name(all.front().name, known)) {
    const auto least = far_smaller * rank_of(all.front());
    std::erase_if(all, [&](const City& city) { return rank_of(city) > least; });
    if (all.size() == 1) return {};
  }
  std::vector<std::string> others;
  for (std::size_t i = 1; i < all.size(); ++i) others.push_back(as_written(all[i]));
  return fmt::format("{} is {}{}", name, as_written(all.front()),
                     others.empty() ? "" : "; others are " + listed(others));
}

std::string no_such_city(std::string_view name) {
  const auto [city, region] = name_and_region(name);
  std::vector<std::string> regions;
  for (const auto& known : cities_named(city)) regions.push_back(known.region);
  return regions.empty() ? "no such city"
                         : fmt::format("no such city; {} is known in {}", city, listed(regions));
}

City nearest_city(const Observer& place) {
  const auto near = [&](const auto& row) { return nearness(place, city_in(row).place); };
  const auto& nearest = *std::ranges::max_element(cities(), {}, near);
  const auto own = std::ranges::max_element(own_cities(), {}, near);
  return own != own_cities().end() && near(*own) > near(nearest) ? own_city_in(*own)
                                                                 : city_in(nearest);
}

algebra::Length distance_between(const Observer& a, const Observer& b) {
  return algebra::kilometres(6371 * std::acos(std::clamp(nearness(a, b), -1., 1.)));
}

std::optional<LunarFeature> lunar_feature_named(std::string_view name) {
  const auto rows = rows_named(features(), name);
  return rows.empty() ? std::nullopt : std::optional(feature_in(rows.front()));
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

std::vector<std::string> city_names() {
  auto names = names_in(own_cities());
  const auto others = names_in(cities());
  names.insert(names.end(), others.begin(), others.end());
  return names;
}

std::vector<std::string> lunar_feature_names() { return names_in(features()); }

}  // namespace coppermoon::almanac
