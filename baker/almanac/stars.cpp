// SPDX-License-Identifier: MIT
#include "almanac/stars.h"

#include <erfam.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <numbers>
#include <string_view>

#include "almanac/earth_motion.h"
#include "almanac/tables.h"

namespace coppermoon::almanac {
namespace {

/// Reads a signed little-endian integer of up to four bytes.
double number_in(std::string_view bytes) {
  std::uint32_t number = 0;
  for (std::size_t k = bytes.size(); k-- > 0;)
    number = number << 8 | static_cast<unsigned char>(bytes[k]);
  const auto unused = 32 - 8 * bytes.size();
  return static_cast<std::int32_t>(number << unused) >> unused;
}

/// Reads a star from a record of the catalogue, whose format is described in data/make_stars.py.
Star star_of(std::string_view record) {
  constexpr double step_rad = std::numbers::pi / 2147483648.,  // half a turn divided by 2^31
      motion_step_rad = 1e-5 * ERFA_DAS2R;
  const double ascension = step_rad * number_in(record.substr(0, 4)),
               declination = step_rad * number_in(record.substr(4, 4));
  const glm::dvec3 place(std::cos(declination) * std::cos(ascension),
                         std::cos(declination) * std::sin(ascension), std::sin(declination));
  const glm::dvec3 east(-std::sin(ascension), std::cos(ascension), 0);
  return {place, -2 + 0.05 * static_cast<unsigned char>(record[14]),
          -0.5 + 4. / 127 * static_cast<unsigned char>(record[15]),
          motion_step_rad * (number_in(record.substr(8, 3)) * east +
                             number_in(record.substr(11, 3)) * glm::cross(place, east))};
}

std::vector<Star> read_stars() {
  constexpr std::size_t record_bytes = 16;
  const auto table = tables::stars();
  std::vector<Star> stars;
  stars.reserve(table.size() / record_bytes);
  for (std::size_t at = 0; at < table.size(); at += record_bytes)
    stars.push_back(star_of(table.substr(at, record_bytes)));
  return stars;
}

}  // namespace

const std::vector<Star>& stars() {
  static const std::vector<Star> all = read_stars();
  return all;
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
