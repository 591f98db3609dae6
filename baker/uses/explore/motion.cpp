// SPDX-License-Identifier: MIT
#include "uses/explore/motion.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "algebra/chebyshev.h"
#include "almanac/observer.h"
#include "almanac/sky.h"
#include "eclipse/shadow_axis.h"

namespace coppermoon::uses {
namespace {

using nlohmann::ordered_json;
using std::numbers::pi;

constexpr int nodes = 14;

/// Names of the quantities that are expanded in Chebyshev series in time, and the number of components of each.
const std::vector<std::pair<const char*, int>> parts{
    {"centre", 3}, {"sunDistance", 1}, {"moonFrame", 9}, {"equatorFrame", 9}};

void append(std::vector<double>& all, const glm::dmat3& matrix) {
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) all.push_back(matrix[column][row]);
}

/// Greenwich sidereal time [rad], found as the right ascension of the zenith at latitude 0 and longitude 0.
double sidereal_time(const almanac::SkyState& sky) {
  const auto zenith = sky.equator_from_gcrs * almanac::view_from({}, sky).zenith;
  return std::atan2(zenith.y, zenith.x);
}

/// Values of all components at one moment, in the order of the series in `parts`.
std::vector<double> positions_at(const almanac::Instant& when) {
  const auto sky = almanac::sky_at(when);
  const auto axis = eclipse::shadow_axis(sky);
  const auto centre_m = axis.shadow_from_gcrs * sky.moon_m;
  std::vector<double> all{centre_m.x / 1e3, centre_m.y / 1e3, centre_m.z / 1e3,
                          algebra::in_kilometres(axis.sun_distance)};
  append(all, axis.shadow_from_gcrs * glm::transpose(sky.selenographic_from_gcrs));
  append(all, axis.shadow_from_gcrs * glm::transpose(sky.equator_from_gcrs));
  return all;
}

}  // namespace

ordered_json motion_between(const almanac::Instant& from, const almanac::Instant& to) {
  const double seconds = almanac::seconds_between(from, to);
  std::vector<std::vector<double>> known(nodes);
  tbb::parallel_for(0, nodes, [&](int i) {
    known[static_cast<std::size_t>(i)] =
        positions_at(almanac::later(from, (algebra::chebyshev_node(i, nodes) + 1) / 2 * seconds));
  });
  ordered_json series;
  std::size_t component = 0;
  const auto all = algebra::chebyshev_series(known);
  for (const auto& [name, count] : parts)
    for (int i = 0; i < count; ++i) series[name].push_back(all[component++]);
  const double first = sidereal_time(almanac::sky_at(from)),
               last = sidereal_time(almanac::sky_at(to));
  constexpr double sidereal_day_s = 86164.0905;
  const double about = 2 * pi * seconds / sidereal_day_s;
  const double grown = about + std::remainder(last - first - about, 2 * pi);
  return {{"series", series}, {"siderealTime", {first, grown}}, {"seconds", seconds}};
}

}  // namespace coppermoon::uses
