// SPDX-License-Identifier: MIT
#include "surface/features.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

#include "algebra/error.h"
#include "algebra/random.h"
#include "algebra/table.h"

namespace coppermoon::surface {
namespace {

using algebra::Error;
using std::numbers::pi;

constexpr double radius_km = 1737.4;
constexpr std::size_t old_crater_count = 9000;

using Cells = std::vector<std::string>;
enum Column : std::size_t { name_, kind, latitude, longitude, east, north, turn, albedo, reach };
constexpr std::size_t column_count = 9;

/// A line of the table with what to call it in errors.
struct Line {
  const Cells& cells;
  std::string where;

  double operator[](Column column) const {
    const auto& cell = cells[column];
    double value = 0;
    const auto* end = cell.data() + cell.size();
    if (cell.empty() || std::from_chars(cell.data(), end, value).ptr != end)
      throw Error(fmt::format("{}: \"{}\" is no number", where, cell));
    return value;
  }
};

float angle(double across_km) { return static_cast<float>(across_km / 2 / radius_km); }

Site site_of(const Line& line) {
  return site(line[latitude] * pi / 180, line[longitude] * pi / 180);
}

Patch patch(const Line& line, float softness) {
  const double turned = line[turn] * pi / 180;
  return {site_of(line),
          angle(line[east]),
          angle(line[north]),
          static_cast<float>(std::cos(turned)),
          static_cast<float>(std::sin(turned)),
          static_cast<float>(line[albedo]),
          softness};
}

/// Rays in random directions, few of them long.
std::vector<Ray> rays(double reach_rad, float radius_rad, std::uint64_t crater) {
  algebra::Random random(1, crater);
  std::vector<Ray> found(static_cast<std::size_t>(reach_rad > 0 ? 11 + 16 * reach_rad : 0));
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double even =
        (static_cast<double>(i) + 1.3 * random.uniform()) / static_cast<double>(found.size());
    const double shortened = 0.4 + 0.6 * std::pow(random.uniform(), 1.4);
    const double azimuth = 2 * pi * even;
    found[i] = {static_cast<float>(std::sin(azimuth)), static_cast<float>(std::cos(azimuth)),
                static_cast<float>(reach_rad * shortened),
                static_cast<float>((0.018 + 0.03 * random.uniform()) * std::sqrt(radius_rad)),
                static_cast<float>(0.45 + 0.55 * random.uniform())};
  }
  return found;
}

RayCrater ray_crater(const Line& line, std::uint64_t number) {
  const float radius = angle(line[east]);
  return {site_of(line), radius, static_cast<float>(line[albedo]),
          rays(line[reach] / radius_km, radius, number)};
}

/// Uniform over the sphere; as many wider than some width as its inverse square, 7 to 70 km.
std::vector<OldCrater> old_craters() {
  std::vector<OldCrater> found;
  for (std::size_t i = 0; i < old_crater_count; ++i) {
    algebra::Random random(2, i);
    const double z = 2 * random.uniform() - 1, around = 2 * pi * random.uniform();
    const double across_km = std::min(7 / std::sqrt(1 - random.uniform()), 140.0);
    const double contrast =
        (0.03 + 0.2 * std::pow(random.uniform(), 3)) * std::pow(across_km / 7, -0.45);
    found.push_back(
        {site(std::asin(z), around - pi), angle(across_km), static_cast<float>(contrast)});
  }
  return found;
}

void add(Features& features, const Line& line) {
  const auto& what = line.cells[kind];
  if (what == "ground") {
    features.patches.push_back(patch(line, 0.7F));
  } else if (what == "mare") {
    features.patches.push_back(patch(line, 0.11F));
  } else if (what == "island") {
    features.patches.push_back(patch(line, 0.45F));
  } else if (what == "crater") {
    features.ray_craters.push_back(ray_crater(line, features.ray_craters.size()));
  } else {
    throw Error(
        fmt::format("{}: kind \"{}\", allowed ground, mare, island, crater", line.where, what));
  }
}

}  // namespace

Site site(double latitude_rad, double longitude_rad) {
  const double c = std::cos(latitude_rad), s = std::sin(latitude_rad);
  const double cl = std::cos(longitude_rad), sl = std::sin(longitude_rad);
  return {latitude_rad, longitude_rad, glm::vec3(c * cl, c * sl, s), glm::vec3(-sl, cl, 0),
          glm::vec3(-s * cl, -s * sl, c)};
}

Features features(std::string_view table, std::string_view name) {
  const auto rows = algebra::parse_text_table(table);
  Features found;
  for (std::size_t r = 1; r < rows.size(); ++r) {
    const Line line{rows[r], fmt::format("{}:row {}", name, r)};
    if (rows[r].size() != column_count)
      throw Error(
          fmt::format("{}: {} cells, allowed {}", line.where, rows[r].size(), column_count));
    add(found, line);
  }
  found.old_craters = old_craters();
  return found;
}

}  // namespace coppermoon::surface
