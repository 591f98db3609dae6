// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "almanac/observer.h"
#include "eclipse/contacts.h"

namespace coppermoon::uses {

/// Circle of places that see the Moon's upper limb on the horizon, around the place with the Moon at its zenith.
/// Its radius is 90° less the parallax, plus a refraction of 34′ and the semidiameter.
///
/// Given     points  number of points, evenly spaced, 3 or more
/// Returned  latitude and longitude [degrees], longitude −180 to 180, at sea level
/// Accuracy  0.2°, because the ellipsoid is taken as a sphere
std::vector<std::pair<double, double>> horizon_circle(const almanac::Instant& when,
                                                      std::size_t points);

/// Draws a plate carrée map of where an eclipse is seen: a circle for each contact, the regions that see all or none
/// of the eclipse, and a place.
///
/// Given   picture  .png, .svg or .pdf
/// Throws  Error    for another ending; as write_plot
/// Source  coastlines: Natural Earth 4.1, public domain (data/coastlines.csv)
void write_visibility_map(const std::filesystem::path& picture, const eclipse::Eclipse& eclipse,
                          const std::optional<almanac::Observer>& place = {});

}  // namespace coppermoon::uses
