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
  std::string name, region;  ///< region: the state or province
  Observer place;
  std::string time_zone;  ///< IANA name, such as "America/Chicago"
  bool own = false;       ///< whether it is from the user's own file
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
/// Cities from the user's own file come before all others. That file is $XDG_CONFIG_HOME/coppermoon/cities.csv, or, if
/// this variable is not set, ~/.config/coppermoon/cities.csv. It has the columns of data/cities.csv, and is read once.
///
/// Given   name  such as "Chicago"; a region or country (data/areas.csv) may follow after a slash or comma:
///               "Springfield/Illinois", "Springfield, IL, USA", "Berlin, Germany"
/// Throws  Error  if a line in the user's own file is not a city
/// Source  GeoNames, CC BY 4.0 (data/cities.csv); positions are rounded to 0.01°
std::vector<City> cities_named(std::string_view name);

/// The first city that cities_named finds, if any.
std::optional<City> city_named(std::string_view name);

/// Message about the city that an ambiguous name was taken for: "Springfield is Springfield/Missouri; others are
/// Springfield/Massachusetts, Springfield/Illinois". There is also a message if the city's full name is longer than
/// `name`; otherwise the string is empty. Far smaller cities do not make a name ambiguous: "London" is the one in
/// England.
std::string city_taken(std::string_view name);

/// Message that says why a city was not found. If only the region is wrong, the message lists the regions that have a
/// city of this name: "no such city; Springfield is known in Missouri, Massachusetts, Illinois".
std::string no_such_city(std::string_view name);

/// The city nearest to a place, including the user's own cities.
City nearest_city(const Observer& place);

/// Distance between two places along the surface of a globe with a radius of 6371 km.
algebra::Length distance_between(const Observer& a, const Observer& b);

/// Finds a lunar feature by its name, with the same rules as for cities: "Crisium" finds Mare Crisium.
///
/// Source  Gazetteer of Planetary Nomenclature, IAU and USGS (data/lunar_features.csv), rounded to 0.01°
std::optional<LunarFeature> lunar_feature_named(std::string_view name);

/// The most populous cities, largest first; at most `count` of them. The user's own cities are left out.
std::vector<City> largest_cities(std::size_t count);

/// All lunar features in the gazetteer.
std::vector<LunarFeature> lunar_features();

/// Names of all cities, the user's own first. They are used to suggest a similar name for a misspelt one.
std::vector<std::string> city_names();
std::vector<std::string> lunar_feature_names();

/// A name in lower-case Latin letters without accents: "sao paulo" for "São Paulo".
std::string plain_name(std::string_view name);

}  // namespace coppermoon::almanac
