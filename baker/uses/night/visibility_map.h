// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "almanac/observer.h"
#include "eclipse/contacts.h"

namespace coppermoon::uses {

/// Where the Moon stands in the horizon at a moment: a circle about the place under it.
///
/// Its upper limb is seen within 90° of that place, less the parallax and more the refraction of 34′ and
/// its semidiameter.
///
/// Given     points  how many, evenly around, 3 or more
/// Returned  latitude and longitude [degrees], longitude −180 to 180; no elevation counts
/// Accuracy  0.2°, of a sphere in place of the ellipsoid
std::vector<std::pair<double, double>> horizon_circle(const almanac::Instant& when,
                                                      std::size_t points);

/// Draws where on the Earth an eclipse is seen: the circles of its contacts on a map in plate carrée, the
/// parts that see all and nothing of it, and a place. By gnuplot, whole or not at all.
///
/// Given   picture  .png, .svg or .pdf
/// Throws  Error    for another ending; as write_plot
/// Source  coastlines: Natural Earth 4.1, public domain (data/coastlines.csv)
void write_visibility_map(const std::filesystem::path& picture, const eclipse::Eclipse& eclipse,
                          const std::optional<almanac::Observer>& place = {});

}  // namespace coppermoon::uses
