// SPDX-License-Identifier: MIT
#include "verbs/flags/view_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <vector>

#include "algebra/error.h"
#include "algebra/number.h"
#include "almanac/gazetteer.h"
#include "verbs/flags/known_words.h"
#include "verbs/flags/number_list.h"

namespace coppermoon::verbs {
namespace {

constexpr const char* view_group = "Who looks, and through what";
constexpr const char* whole_moon = "moon";

/// Nothing for the whole Moon, or what a lens shows.
std::optional<double> field_from(const std::string& text) {
  if (text == whole_moon) return std::nullopt;
  const auto degrees = algebra::number_in(text);
  if (!degrees)
    throw algebra::Error(
        fmt::format("field of view [degrees] = {}, allowed moon or 1e-8 to 179.9", text));
  return degrees;
}

/// "on", "off", or the V magnitude of the faintest.
uses::StarRequest stars_from(const std::string& text) {
  if (text == "on" || text == "off") return {.shown = text == "on"};
  const auto faintest = algebra::number_in(text);
  if (!faintest)
    throw algebra::Error(fmt::format("stars = {}, allowed on, off or a magnitude, -5 to 20", text));
  return {.shown = true, .faintest = faintest};
}

/// "42.86,-73.77,120" or "42.86N,73.77W": numbers north and east; none for any other text.
std::vector<double> place_numbers(const std::string& text) {
  std::string signed_text;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const char sense = part.empty() ? ' ' : part.back();
    const bool north_south = signed_text.empty();
    if (north_south ? sense == 'N' || sense == 'S' : sense == 'E' || sense == 'W') {
      part.pop_back();
      if (sense == 'S' || sense == 'W') part.insert(part.begin(), '-');
    }
    signed_text += (signed_text.empty() ? "" : ",") + part;
  }
  if (text.ends_with(',')) return {};
  return number_list(signed_text).value_or(std::vector<double>{});
}

/// The name that is spelt most alike, whatever case and accents. A first letter is seldom mistaken: it
/// counts as three.
std::string name_like(std::string_view text, const std::vector<std::string>& names) {
  const auto wanted = almanac::plain_name(text.substr(0, 100));
  return *std::ranges::min_element(names, {}, [&](const std::string& name) {
    const auto plain = almanac::plain_name(name);
    return letters_apart(wanted, plain) + (plain.substr(0, 1) == wanted.substr(0, 1) ? 0 : 2);
  });
}

[[noreturn]] void throw_no_city(const std::string& text) {
  auto why = almanac::no_such_city(text);
  const auto name = text.substr(0, text.find_first_of("/,"));
  if (almanac::cities_named(name).empty())
    why += "; the nearest name is " + name_like(name, almanac::city_names());
  throw algebra::Error(fmt::format(
      "place = {}: {}. Allowed is LATITUDE,LONGITUDE too, as 42.86,-73.77", text, why));
}

}  // namespace

almanac::Observer observer_from(const std::string& text) {
  if (!text.empty() && text.find_first_of("0123456789") == std::string::npos) {
    const auto city = almanac::city_named(text);
    if (!city) throw_no_city(text);
    if (const auto taken = almanac::city_taken(text); !taken.empty())
      fmt::print(stderr, "coppermoon: {}\n", taken);
    return city->place;
  }
  const auto numbers = place_numbers(text);
  if (numbers.size() < 2 || numbers.size() > 3)
    throw algebra::Error(
        fmt::format("place = {}, allowed LATITUDE,LONGITUDE[,ELEVATION] in degrees (north, east) "
                    "and metres, as 42.86,-73.77 or 42.86N,73.77W, or the name of a city",
                    text));
  const almanac::Observer observer{algebra::degrees(numbers[0]), algebra::degrees(numbers[1]),
                                   algebra::metres(numbers.size() == 3 ? numbers[2] : 0)};
  almanac::require_on_earth(observer);
  return observer;
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
  const auto numbers = number_list(text).value_or(std::vector<double>{});
  if (numbers.size() != 2)
    throw algebra::Error(
        fmt::format("aim = {}, allowed ALTITUDE,AZIMUTH in degrees, as 30,120", text));
  algebra::require_within("altitude of the aim [degrees]", numbers[0], -89, 89);
  algebra::require_within("azimuth of the aim [degrees]", numbers[1], -360, 360);
  return {algebra::degrees(numbers[0]), algebra::degrees(numbers[1])};
}

void add_observer_options(CLI::App& verb, uses::ViewRequest& request) {
  const std::string group = view_group;
  add_parsed(
      verb, "--at", [&](const std::string& text) { request.observer = observer_from(text); },
      "place of the observer: a city, as Chicago or Springfield/Illinois, or LAT,LON[,ELEV] "
      "[degrees north and east, metres]; default: the Earth's centre")
      .in(group);
  add_on_off(verb, "--reddening", request.reddening, "reddening and dimming by the observer's air")
      .in(group);
  add_flag(verb, "--observer-ozone-du", request.observer_ozone_du,
           "vertical column of ozone above the observer [DU], 0 to 1000")
      .in(group);
  add_flag(verb, "--observer-aerosol", request.observer_aerosol,
           "vertical optical depth of the aerosol above the observer at 550 nm, 0 to 10")
      .in(group);
}

void add_view_options(CLI::App& verb, uses::ViewRequest& request) {
  using povray_scenes::Up;
  const std::string group = view_group;
  add_observer_options(verb, request);
  add_on_off(verb, "--flattening", request.flattening,
             "flattening of a low Moon by refraction in the observer's air")
      .in(group);
  add_flag(verb, "--focal-length", request.focal_length_mm,
           "focal length of the telescope or lens [mm]; without camera, lens or --field the frame "
           "holds the whole Moon")
      .in(group);
  add_flag(verb, "--sensor-width", request.sensor_width_mm,
           "width of the sensor [mm]; 22.7 unless the camera says another")
      .in(group);
  add_parsed(
      verb, "--field", [&](const std::string& text) { request.field_deg = field_from(text); },
      "angle across the frame [degrees], in place of a lens; moon: the whole Moon with some "
      "margin, "
      "or what the lens shows",
      whole_moon)
      .in(group);
  add_flag(verb, "--width", request.width, "width of the frame [pixels]").not_negative().in(group);
  add_flag(verb, "--height", request.height, "height of the frame [pixels]")
      .not_negative()
      .in(group);
  add_choice<Up>(verb, "--up", request.up,
                 {{"celestial-north", Up::celestial_north},
                  {"zenith", Up::zenith},
                  {"moon-north", Up::moon_north}},
                 "direction that is up in the frame")
      .in(group);
  add_parsed(
      verb, "--stars", [&](const std::string& text) { request.stars = stars_from(text); },
      "stars and planets: on, off, or the V magnitude of the faintest; on: to magnitude 9 "
      "within 10 degrees of the ecliptic, to 6.5 elsewhere",
      "on")
      .in(group);
}

}  // namespace coppermoon::verbs
