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
};

/// A crater, mare, mountain or valley of the Moon.
struct LunarFeature {
  std::string name;
  SelenographicPoint middle;
  algebra::Length diameter;
};

/// The cities of that name, the most populous first: of those with more than 100 000 inhabitants, all
/// capitals, and capitals of provinces. Case and accents do not count, ä, ö and ü may be ae, oe and ue, and
/// some cities have other names too: "Wien" is Vienna. Where no city has that very name, they are those
/// whose names hold it as whole words: "New York" is New York City.
///
/// Given   name  "Chicago", or with the region behind a slash or comma: "Springfield/Illinois"
/// Source  GeoNames, CC BY 4.0 (data/cities.csv), places to 0.01°
std::vector<City> cities_named(std::string_view name);

/// The first of them.
std::optional<City> city_named(std::string_view name);

/// "Springfield is Springfield/Missouri; others are Springfield/Massachusetts, Springfield/Illinois", where
/// several cities may be meant by the name, or one whose name is longer; empty where there is no doubt. Cities
/// far smaller than the one of that very name are not meant: "London" is no doubt.
std::string city_taken(std::string_view name);

/// Why there is no such city: "no such city; Springfield is known in Missouri, Massachusetts, Illinois" where
/// the region is wrong, "no such city" otherwise.
std::string no_such_city(std::string_view name);

/// The city that is the fewest degrees away.
City nearest_city(const Observer& place);

/// The feature of that name, found as a city is: "Crisium" is Mare Crisium.
///
/// Source  Gazetteer of Planetary Nomenclature, IAU and USGS (data/lunar_features.csv), to 0.01°
std::optional<LunarFeature> lunar_feature_named(std::string_view name);

/// The most populous cities, largest first; all that are known where fewer are.
std::vector<City> largest_cities(std::size_t count);

/// All features of the Moon, by name.
std::vector<LunarFeature> lunar_features();

/// All names, for whoever looks for one that is like another.
std::vector<std::string> city_names();
std::vector<std::string> lunar_feature_names();

/// A name in small letters of the Latin alphabet, without accents: "sao paulo" for "São Paulo".
std::string plain_name(std::string_view name);

}  // namespace coppermoon::almanac
