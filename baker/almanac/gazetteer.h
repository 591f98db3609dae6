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

/// A city of the Earth.
struct City {
  std::string name, region;  ///< region: its state or province
  Observer place;
  std::string time_zone;  ///< a name of the IANA's data, as "America/Chicago"
  bool own = false;       ///< of the user's own file
};

/// A crater, mare, mountain or valley of the Moon.
struct LunarFeature {
  std::string name;
  SelenographicPoint middle;
  algebra::Length diameter;
};

/// Cities of a name, the most populous first. The gazetteer has cities of more than 100 000 inhabitants, capitals,
/// and capitals of provinces. Case and accents are ignored, ä, ö and ü may be written ae, oe and ue, and some
/// cities have alternative names: "Wien" is Vienna. Where no city has exactly this name, cities are returned whose
/// names contain it as whole words: "New York" finds New York City.
///
/// Before all others come cities of the user's own file: $XDG_CONFIG_HOME/coppermoon/cities.csv, else
/// ~/.config/coppermoon/cities.csv, with the columns of data/cities.csv. It is read once.
///
/// Given   name  "Chicago", or with region or country (data/areas.csv) after a slash or comma:
///               "Springfield/Illinois", "Springfield, IL, USA", "Berlin, Germany"
/// Throws  Error  for a line of the own file that is no city
/// Source  GeoNames, CC BY 4.0 (data/cities.csv), places to 0.01°
std::vector<City> cities_named(std::string_view name);

/// First city of cities_named, if any.
std::optional<City> city_named(std::string_view name);

/// Remark on an ambiguous name, as "Springfield is Springfield/Missouri; others are Springfield/Massachusetts,
/// Springfield/Illinois"; also where the city's full name is longer. Empty where the name is unambiguous; far
/// smaller cities are disregarded: "London" is unambiguous.
std::string city_taken(std::string_view name);

/// Reason why a city is not found: "no such city; Springfield is known in Missouri, Massachusetts, Illinois" where
/// the region is wrong, "no such city" otherwise.
std::string no_such_city(std::string_view name);

/// City at the least distance from a place; the user's own count too.
City nearest_city(const Observer& place);

/// Distance of two places along a globe of 6371 km radius.
algebra::Length distance_between(const Observer& a, const Observer& b);

/// Lunar feature of a name, by the same rules as for cities: "Crisium" is Mare Crisium.
///
/// Source  Gazetteer of Planetary Nomenclature, IAU and USGS (data/lunar_features.csv), to 0.01°
std::optional<LunarFeature> lunar_feature_named(std::string_view name);

/// Most populous cities, largest first, without the user's own; at most `count`.
std::vector<City> largest_cities(std::size_t count);

/// All features of the Moon, by name.
std::vector<LunarFeature> lunar_features();

/// Names of all cities, the user's own first, to search for similar ones.
std::vector<std::string> city_names();
std::vector<std::string> lunar_feature_names();

/// A name in small letters of the Latin alphabet, without accents: "sao paulo" for "São Paulo".
std::string plain_name(std::string_view name);

}  // namespace coppermoon::almanac
