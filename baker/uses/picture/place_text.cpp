// SPDX-License-Identifier: MIT
#include "uses/picture/place_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <limits>
#include <optional>
#include <sstream>
#include <string_view>
#include <vector>

#include "algebra/error.h"
#include "algebra/number.h"
#include "almanac/gazetteer.h"
#include "request/likeness.h"

namespace coppermoon::uses {
namespace {

/// Removes a number and the mark after it (one of the given marks) from the front of a string. Returns the number.
std::optional<double> take_marked(std::string_view& text,
                                  std::initializer_list<std::string_view> marks) {
  for (const auto mark : marks) {
    const auto end = text.find(mark);
    if (end == std::string_view::npos) continue;
    const auto number = algebra::number_in(algebra::without_spaces(text.substr(0, end)));
    text = algebra::without_spaces(text.substr(end + mark.size()));
    return number;
  }
  return std::nullopt;
}

/// Reads degrees such as "42.86", "-73.77", "73.77W" or "157°52′12″W"; nothing for any other text.
///
/// Given  senses  letters for the positive and the negative direction, such as "EW"
std::optional<double> degrees_in(std::string_view text, std::string_view senses) {
  text = algebra::without_spaces(text);
  const bool sensed = !text.empty() && senses.find(text.back()) != std::string_view::npos;
  const bool negative = text.starts_with('-') || (sensed && text.back() == senses[1]);
  if (sensed && text.find_first_of("+-") == 0) return std::nullopt;
  if (sensed) text = algebra::without_spaces(text.substr(0, text.size() - 1));
  if (text.find("°") == std::string_view::npos) {
    const auto number = algebra::number_in(text);
    return number && sensed && negative ? -*number : number;
  }
  if (text.find_first_of("+-") == 0) text.remove_prefix(1);
  const auto degrees = take_marked(text, {"°"});
  const auto minutes = text.empty() ? 0 : take_marked(text, {"′", "’", "'"});
  const auto seconds = text.empty() ? 0 : take_marked(text, {"″", "”", "\"", "''"});
  const auto fits = [](const std::optional<double>& part) {
    return part && *part >= 0 && *part < 60;
  };
  if (!degrees || !(*degrees >= 0) || !fits(minutes) || !fits(seconds) || !text.empty())
    return std::nullopt;
  return (negative ? -1 : 1) * (*degrees + *minutes / 60 + *seconds / 3600);
}

/// Reads "42.86,-73.77,120", "42.86N, 73.77W" or "21°18′N 157°52′W": degrees north and east, and any numbers after
/// them; empty for any other text.
std::vector<double> place_numbers(const std::string& text) {
  auto separated = text;
  if (const auto north_ends = text.find_first_of("NS");
      text.find(',') == std::string::npos && north_ends != std::string::npos)
    separated.insert(north_ends + 1, ",");
  if (separated.ends_with(',')) return {};
  std::vector<double> numbers;
  std::istringstream parts(separated);
  for (std::string part; std::getline(parts, part, ',');) {
    const auto number = numbers.empty()       ? degrees_in(part, "NS")
                        : numbers.size() == 1 ? degrees_in(part, "EW")
                                              : algebra::number_in(algebra::without_spaces(part));
    if (!number) return {};
    numbers.push_back(*number);
  }
  return numbers;
}

/// The name with the most similar spelling, ignoring case and accents. The first letter is rarely wrong, so an error
/// in it counts as three. Only the first 64 letters are compared, because no name is longer.
std::string name_like(std::string_view text, const std::vector<std::string>& names) {
  const auto wanted = almanac::plain_name(text.substr(0, 64));
  std::string nearest;
  auto least = std::numeric_limits<std::size_t>::max();
  for (const auto& name : names) {
    const auto plain = almanac::plain_name(name);
    const std::size_t first = plain.substr(0, 1) == wanted.substr(0, 1) ? 0 : 2;
    const auto [shorter, longer] = std::minmax({plain.size(), wanted.size()});
    if (longer - shorter + first >= least) continue;  // cannot be closer than the best so far
    if (const auto apart = request::letters_apart(wanted, plain) + first; apart < least)
      least = apart, nearest = name;
  }
  return nearest;
}

[[noreturn]] void throw_no_city(const std::string& text) {
  auto why = almanac::no_such_city(text);
  const auto name = text.substr(0, text.find_first_of("/,"));
  if (almanac::cities_named(name).empty())
    why += "; the nearest name is " + name_like(name, almanac::city_names());
  throw algebra::Error(
      fmt::format("place = {}: {}. Allowed is LATITUDE,LONGITUDE too, as 42.86,-73.77", text, why));
}

}  // namespace

almanac::Observer observer_from(const std::string& text) {
  const bool lettered = text.find_first_not_of("0123456789+-., ") != std::string::npos;
  if (lettered)
    if (const auto city = almanac::city_named(text)) return city->place;
  if (!text.empty() && text.find_first_of("0123456789") == std::string::npos) throw_no_city(text);
  const auto numbers = place_numbers(text);
  if (numbers.size() < 2 || numbers.size() > 3)
    throw algebra::Error(
        fmt::format("place = {}, allowed LATITUDE,LONGITUDE[,ELEVATION] in degrees (north, east) "
                    "and metres, as 42.86,-73.77 or 42°52'N,73°46'W, or the name of a city",
                    text));
  const almanac::Observer observer{algebra::degrees(numbers[0]), algebra::degrees(numbers[1]),
                                   algebra::metres(numbers.size() == 3 ? numbers[2] : 0)};
  almanac::require_on_earth(observer);
  return observer;
}

std::string exact_text(const almanac::Observer& place) {
  constexpr int fewest = 7, most = 17;
  const auto numbers = [](const almanac::Observer& o) {
    return std::array{algebra::in_degrees(o.latitude), algebra::in_degrees(o.longitude),
                      algebra::in_metres(o.elevation)};
  };
  const auto [latitude, longitude, elevation_m] = numbers(place);
  for (int digits = fewest;; ++digits) {
    auto text = fmt::format("{:.{}g},{:.{}g}", latitude, digits, longitude, digits);
    if (elevation_m != 0) text += fmt::format(",{:.{}g}", elevation_m, digits);
    if (digits == most || numbers(observer_from(text)) == numbers(place)) return text;
  }
}

almanac::SelenographicPoint feature_from(const std::string& text) {
  if (!text.empty() && text.find_first_of("0123456789") == std::string::npos) {
    if (const auto feature = almanac::lunar_feature_named(text)) return feature->middle;
    throw algebra::Error(
        fmt::format("place on the Moon = {}: no such feature; the nearest name is {}. Allowed is "
                    "LATITUDE,LONGITUDE too, as -43.3,-11.2",
                    text, name_like(text, almanac::lunar_feature_names())));
  }
  const auto numbers = place_numbers(text);
  if (numbers.size() != 2)
    throw algebra::Error(
        fmt::format("place on the Moon = {}, allowed LATITUDE,LONGITUDE in degrees (north, east), "
                    "as -43.3,-11.2, or the name of a feature, as Tycho",
                    text));
  algebra::require_within("lunar latitude [deg]", numbers[0], -90, 90);
  algebra::require_within("lunar longitude [deg]", numbers[1], -360, 360);
  return {algebra::degrees(numbers[0]), algebra::degrees(numbers[1])};
}

povray_scenes::HorizonPlace aim_from(const std::string& text) {
  const auto numbers = algebra::numbers_in(text).value_or(std::vector<double>{});
  if (numbers.size() != 2)
    throw algebra::Error(
        fmt::format("aim = {}, allowed ALTITUDE,AZIMUTH in degrees, as 30,120", text));
  algebra::require_within("altitude of the aim [degrees]", numbers[0], -89, 89);
  algebra::require_within("azimuth of the aim [degrees]", numbers[1], -360, 360);
  return {algebra::degrees(numbers[0]), algebra::degrees(numbers[1])};
}

}  // namespace coppermoon::uses
