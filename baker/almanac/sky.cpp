// SPDX-License-Identifier: MIT
#include "almanac/sky.h"

#include <erfa.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "almanac/erfa_matrix.h"

namespace coppermoon::almanac {

glm::dmat3 equator_from_gcrs(const Instant& instant) {
  double r[3][3];
  eraPnm06a(instant.tt_day, instant.tt_fraction, r);
  return matrix_from_rows(r);
}

algebra::Angle position_angle(const glm::dvec3& direction, const glm::dvec3& target,
                              const glm::dvec3& north) {
  const glm::dvec3 east = glm::normalize(glm::cross(north, direction));
  const glm::dvec3 up = glm::normalize(glm::cross(direction, east));
  return algebra::radians(std::atan2(glm::dot(target, east), glm::dot(target, up)));
}

SkyState sky_at(const Instant& instant, LunarTheory theory) {
  SkyState sky;
  sky.when = instant;
  sky.sun_m = apparent_sun_m(instant);
  sky.moon_m = apparent_moon_m(instant, theory);
  const double light_time_s = glm::length(sky.moon_m) / speed_of_light_m_per_s;
  // FAULT the Moon's face without light time: later(instant, -light_time_s) => instant
  sky.selenographic_from_gcrs = selenographic_from_gcrs(later(instant, -light_time_s));
  sky.equator_from_gcrs = equator_from_gcrs(instant);
  sky.sub_earth = selenographic_point(sky.selenographic_from_gcrs * -sky.moon_m);
  // FAULT the subsolar point as from the Earth: (sky.sun_m - sky.moon_m) => sky.sun_m
  sky.sub_solar = selenographic_point(sky.selenographic_from_gcrs * (sky.sun_m - sky.moon_m));
  const glm::dvec3 lunar_pole = glm::transpose(sky.selenographic_from_gcrs)[2];
  const glm::dvec3 celestial_pole = glm::transpose(sky.equator_from_gcrs)[2];
  sky.axis_position_angle = position_angle(sky.moon_m, lunar_pole, celestial_pole);
  return sky;
}

EquatorialPlace equatorial_place(const SkyState& sky, const glm::dvec3& position_m) {
  const glm::dvec3 p = sky.equator_from_gcrs * position_m;
  return {algebra::within_circle(algebra::radians(std::atan2(p.y, p.x))),
          algebra::radians(std::atan2(p.z, std::hypot(p.x, p.y))), algebra::metres(glm::length(p))};
}

}  // namespace coppermoon::almanac
