// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "almanac/observer.h"
#include "eclipse/contacts.h"

namespace coppermoon::uses {

/// Circle of places where the Moon's upper limb is on the horizon. Its centre is the place where the Moon is at the
/// zenith. Its radius is 90° minus the parallax, plus 34′ for refraction, plus the semidiameter.
///
/// Given     points  number of evenly spaced points, 3 or more
/// Returned  latitudes and longitudes at sea level [degrees], longitudes from −180 to 180
/// Accuracy  0.2°, because the Earth is treated as a sphere
std::vector<std::pair<double, double>> horizon_circle(const almanac::Instant& when,
                                                      std::size_t points);

/// Draws a plate carrée map of where an eclipse is seen. It shows a horizon_circle for each contact, the regions that
/// see all or none of the eclipse, and, if given, a place.
///
/// Given   picture  a file name that ends in .png, .svg or .pdf
/// Throws  Error    if the file name has another ending, or if write_plot throws it
/// Source  coastlines: Natural Earth 4.1, public domain (data/coastlines.csv)
void write_visibility_map(const std::filesystem::path& picture, const eclipse::Eclipse& eclipse,
                          const std::optional<almanac::Observer>& place = {});

}  // namespace coppermoon::uses
