// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "almanac/lunar_orientation.h"
#include "almanac/observer.h"

namespace coppermoon::almanac {

/// A city on the Earth.
struct City {
  std::string name, region;  ///< region: its state or province
  Observer place;
  std::string time_zone;  ///< its IANA name, such as "America/Chicago"
  bool own = false;       ///< from the user's own file
};

/// A crater, mare, mountain or valley on the Moon.
struct LunarFeature {
  std::string name;
  SelenographicPoint middle;
  algebra::Length diameter;
};

/// Cities with a given name, the most populous first. The gazetteer has cities of more than 100 000 inhabitants,
/// capitals and provincial capitals. Case and accents are ignored; ä, ö and ü may be written ae, oe and ue. Some
/// cities have alternative names: "Wien" is Vienna. If no city has exactly this name, those whose names contain it as
/// whole words are returned: "New York" finds New York City.
///
/// Cities from the user's own file come before all others. That file is $XDG_CONFIG_HOME/coppermoon/cities.csv, or else
/// ~/.config/coppermoon/cities.csv, with the same columns as data/cities.csv. It is read once.
///
/// Given   name  "Chicago", or with a region or country (data/areas.csv) after a slash or comma:
///               "Springfield/Illinois", "Springfield, IL, USA", "Berlin, Germany"
/// Throws  Error  if a line in the user's own file is not a city
/// Source  GeoNames, CC BY 4.0 (data/cities.csv), places to 0.01°
std::vector<City> cities_named(std::string_view name);

/// The first city that cities_named finds, if any.
std::optional<City> city_named(std::string_view name);

/// Remark on an ambiguous name, such as "Springfield is Springfield/Missouri; others are Springfield/Massachusetts,
/// Springfield/Illinois". There is also a remark if the city's full name is longer. Empty if the name is
/// unambiguous; far smaller cities do not count, so "London" is unambiguous.
std::string city_taken(std::string_view name);

/// Reason why a city is not found: "no such city; Springfield is known in Missouri, Massachusetts, Illinois" if only
/// the region is wrong, otherwise "no such city".
std::string no_such_city(std::string_view name);

/// The city nearest to a place, including the user's own cities.
City nearest_city(const Observer& place);

/// Distance between two places along the surface of a globe with a radius of 6371 km.
algebra::Length distance_between(const Observer& a, const Observer& b);

/// Finds a lunar feature by name, with the same rules as for cities: "Crisium" is Mare Crisium.
///
/// Source  Gazetteer of Planetary Nomenclature, IAU and USGS (data/lunar_features.csv), to 0.01°
std::optional<LunarFeature> lunar_feature_named(std::string_view name);

/// The `count` most populous cities at most, largest first, without the user's own.
std::vector<City> largest_cities(std::size_t count);

/// All features on the Moon, with their names.
std::vector<LunarFeature> lunar_features();

/// Names of all cities, the user's own first, for suggesting similar ones.
std::vector<std::string> city_names();
std::vector<std::string> lunar_feature_names();

/// A name in lower-case Latin letters without accents: "sao paulo" for "São Paulo".
std::string plain_name(std::string_view name);

}  // namespace coppermoon::almanac
