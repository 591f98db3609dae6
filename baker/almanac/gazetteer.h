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

/// The city of that name, the most populous where several bear it: of those with more than 100 000
/// inhabitants, all capitals, and capitals of provinces. Case and accents do not count. Where no city has
/// that very name, it is one whose name holds it as whole words: "New York" is New York City.
///
/// Given   name  "Chicago", or with the region behind a slash: "Springfield/Illinois"
/// Source  GeoNames, CC BY 4.0 (data/cities.csv), places to 0.01°
std::optional<City> city_named(std::string_view name);

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

/// A name in small letters of the Latin alphabet, without accents: "Sao Paulo" for "São Paulo".
std::string plain_name(std::string_view name);

}  // namespace coppermoon::almanac
