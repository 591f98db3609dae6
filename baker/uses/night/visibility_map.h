// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "almanac/observer.h"
#include "eclipse/contacts.h"

namespace coppermoon::uses {

/// Circle of places that have the Moon's upper limb in the horizon, about the place that has the Moon in its zenith.
/// Its radius is 90° less the parallax, plus a refraction of 34′ and the semidiameter.
///
/// Given     points  how many, evenly around, 3 or more
/// Returned  latitude and longitude [degrees], longitude −180 to 180; no elevation counts
/// Accuracy  0.2°, of a sphere in place of the ellipsoid
std::vector<std::pair<double, double>> horizon_circle(const almanac::Instant& when,
                                                      std::size_t points);

/// Draws a map, in plate carrée, of where an eclipse is seen: a circle for each contact, the regions that see all or
/// nothing of the eclipse, and a place.
///
/// Given   picture  .png, .svg or .pdf
/// Throws  Error    for another ending; as write_plot
/// Source  coastlines: Natural Earth 4.1, public domain (data/coastlines.csv)
void write_visibility_map(const std::filesystem::path& picture, const eclipse::Eclipse& eclipse,
                          const std::optional<almanac::Observer>& place = {});

}  // namespace coppermoon::uses
