// SPDX-License-Identifier: MIT
#include "almanac/stars.h"

#include <erfam.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <optional>

#include "algebra/error.h"
#include "algebra/number.h"
#include "almanac/earth_motion.h"

namespace coppermoon::almanac {
namespace {

constexpr std::size_t header_bytes = 32, star_bytes = 28;

/// Little-endian numbers of a text that is long enough.
std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t k = 4; k-- > 0;)
    number = number << 8 | static_cast<unsigned char>(bytes[at + k]);
  return number;
}

double signed_number_at(std::string_view bytes, std::size_t at) {
  return static_cast<std::int32_t>(number_at(bytes, at));
}

struct Triangle {
  std::array<glm::dvec3, 3> corners;
};

/// In the order of the catalogue.
std::vector<Triangle> icosahedron() {
  const double golden = std::numbers::phi, b = 1 / std::sqrt(1 + golden * golden), a = b * golden;
  const std::array<glm::dvec3, 12> corners{{{a, -b, 0},
                                            {a, b, 0},
                                            {-a, b, 0},
                                            {-a, -b, 0},
                                            {0, a, -b},
                                            {0, a, b},
                                            {0, -a, b},
                                            {0, -a, -b},
                                            {-b, 0, a},
                                            {b, 0, a},
                                            {b, 0, -a},
                                            {-b, 0, -a}}};
  constexpr std::array<std::array<std::size_t, 3>, 20> order{
      {{1, 0, 10}, {0, 1, 9},   {0, 9, 6},  {9, 8, 6},  {0, 7, 10}, {6, 7, 0},   {7, 6, 3},
       {6, 8, 3},  {11, 10, 7}, {7, 3, 11}, {3, 2, 11}, {2, 3, 8},  {10, 11, 4}, {2, 4, 11},
       {5, 4, 2},  {2, 8, 5},   {4, 1, 10}, {4, 5, 1},  {5, 9, 1},  {8, 9, 5}}};
  std::vector<Triangle> triangles;
  for (const auto& [i, j, k] : order) triangles.push_back({{corners[i], corners[j], corners[k]}});
  return triangles;
}

std::vector<Triangle> halved(const std::vector<Triangle>& triangles) {
  std::vector<Triangle> smaller;
  for (const auto& [corners] : triangles) {
    const auto& [c0, c1, c2] = corners;
    const auto e0 = glm::normalize(c1 + c2), e1 = glm::normalize(c2 + c0),
               e2 = glm::normalize(c0 + c1);
    smaller.push_back({{c0, e2, e1}});
    smaller.push_back({{e2, c1, e0}});
    smaller.push_back({{e1, e0, c2}});
    smaller.push_back({{e0, e1, e2}});
  }
  return smaller;
}

/// The plane that touches the sphere in a triangle's middle.
struct Plane {
  glm::dvec3 middle, east, north;

  explicit Plane(const Triangle& triangle)
      : middle(glm::normalize(triangle.corners[0] + triangle.corners[1] + triangle.corners[2])),
        east(glm::normalize(glm::cross(glm::dvec3(0, 0, 1), middle))),
        north(glm::cross(middle, east)) {}

  /// The furthest that a corner lies along either axis, on the plane.
  double reach(const Triangle& triangle) const {
    double most = 0;
    for (const auto& corner : triangle.corners) {
      const double x = glm::dot(corner - middle, east), y = glm::dot(corner - middle, north);
      most = std::max(most, std::max(std::abs(x), std::abs(y)) / std::sqrt(1 - x * x - y * y));
    }
    return most;
  }
};

/// What a catalogue's head says.
struct Head {
  unsigned level;
  double brightest, step;  ///< of magnitudes

  double magnitude(unsigned char number) const { return brightest + step * number; }
};

Head head_of(std::string_view bytes, const std::string& name) {
  constexpr std::uint32_t magic = 0x835f040a, type = 0, version = 0, most_level = 6;
  if (bytes.size() < header_bytes || number_at(bytes, 0) != magic)
    throw algebra::Error(fmt::format("{}: is no star catalogue of Stellarium's", name));
  if (number_at(bytes, 4) != type || number_at(bytes, 8) != version)
    throw algebra::Error(
        fmt::format("{}: star catalogue of type {}, version {}, allowed type 0, version 0", name,
                    number_at(bytes, 4), number_at(bytes, 8)));
  const auto level = number_at(bytes, 16);
  const double steps = number_at(bytes, 28);
  const double brightest = signed_number_at(bytes, 20) / 1000,
               range = signed_number_at(bytes, 24) / 1000;
  if (level > most_level || steps < 1 || steps > 256 || std::abs(brightest) > 30 || range < 0 ||
      range > 30)
    throw algebra::Error(fmt::format("{}: star catalogue with a damaged head", name));
  return {level, brightest, range / steps};
}

/// Given  unit  of places on the plane
Star star_at(std::string_view bytes, std::size_t at, const Head& head, const Plane& plane,
             double unit) {
  constexpr double colour_step = 4. / 127, bluest = -0.5;
  const glm::dvec3 on_plane = plane.middle + unit * (signed_number_at(bytes, at + 4) * plane.east +
                                                     signed_number_at(bytes, at + 8) * plane.north);
  return {number_at(bytes, at) & 0xffffff, glm::normalize(on_plane),
          head.magnitude(static_cast<unsigned char>(bytes[at + 13])),
          bluest + colour_step * static_cast<unsigned char>(bytes[at + 12])};
}

/// Proper motion [mas a year].
struct Motion {
  double east = 0, north = 0;
};

/// By Hipparcos' number.
using Motions = std::vector<Motion>;

void read_motion(Motions& motions, std::string_view line, const std::string& name) {
  std::array<std::optional<double>, 3> numbers;
  for (auto rest = line; auto& number : numbers) {
    const auto tab = std::min(rest.find('\t'), rest.size());
    number = algebra::number_in(rest.substr(0, tab));
    rest.remove_prefix(std::min(tab + 1, rest.size()));
  }
  constexpr double most_motion = 2e4;
  const auto& [star, east, north] = numbers;
  if (!star || !east || !north || !(*star >= 1 && *star < static_cast<double>(motions.size())) ||
      !(std::abs(*east) <= most_motion && std::abs(*north) <= most_motion))
    throw algebra::Error(
        fmt::format("{}: '{}', allowed a Hipparcos number and two motions within {} mas a year",
                    name, line.substr(0, 40), most_motion));
  motions[static_cast<std::size_t>(*star)] = {*east, *north};
}

}  // namespace

std::vector<Star> stars_in(std::string_view bytes, const std::string& name) {
  const Head head = head_of(bytes, name);
  auto triangles = icosahedron();
  for (unsigned level = 0; level < head.level; ++level) triangles = halved(triangles);
  std::size_t at = header_bytes + 4 * triangles.size();
  std::uint64_t stars = 0;
  if (bytes.size() >= at)
    for (std::size_t t = 0; t < triangles.size(); ++t)
      stars += number_at(bytes, header_bytes + 4 * t);
  if (bytes.size() < at || bytes.size() - at != stars * star_bytes)
    throw algebra::Error(fmt::format("{}: star catalogue of {} bytes, its head says {}", name,
                                     bytes.size(), at + stars * star_bytes));
  double reach = 0;
  std::vector<Plane> planes;
  for (const auto& triangle : triangles)
    reach = std::max(reach, planes.emplace_back(triangle).reach(triangle));
  const double unit = reach / std::numeric_limits<std::int32_t>::max();
  std::vector<Star> found;
  found.reserve(stars);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (auto left = number_at(bytes, header_bytes + 4 * t); left > 0; --left, at += star_bytes)
      found.push_back(star_at(bytes, at, head, planes[t], unit));
  return found;
}

void add_proper_motions(std::vector<Star>& stars, std::string_view text, const std::string& name) {
  constexpr std::size_t last_number = 120416;
  constexpr double mas = 1e-3 * ERFA_DAS2R;
  Motions motions(last_number + 1);
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size());
    if (const auto line = text.substr(0, end); !line.empty() && !line.starts_with('#'))
      read_motion(motions, line, name);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  for (auto& star : stars) {
    if (star.hipparcos > last_number) continue;
    const auto& [east, north] = motions[star.hipparcos];
    const glm::dvec3 eastward = glm::normalize(glm::cross(glm::dvec3(0, 0, 1), star.place));
    star.motion_per_year = mas * (east * eastward + north * glm::cross(star.place, eastward));
  }
}

std::vector<glm::dvec3> apparent_directions(const std::vector<Star>& stars,
                                            const Instant& instant) {
  const double years = ((instant.tt_day - ERFA_DJ00) + instant.tt_fraction) / ERFA_DJY;
  const EarthMotion earth = earth_at(instant);
  std::vector<glm::dvec3> directions;
  directions.reserve(stars.size());
  for (const auto& star : stars)
    directions.push_back(
        aberrated(glm::normalize(star.place + years * star.motion_per_year), earth));
  return directions;
}

}  // namespace coppermoon::almanac
