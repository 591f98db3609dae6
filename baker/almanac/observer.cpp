// SPDX-License-Identifier: MIT
#include "almanac/observer.h"

#include <erfa.h>
#include <erfam.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "algebra/error.h"
#include "almanac/erfa_matrix.h"

namespace coppermoon::almanac {
namespace {

/// Rotation from Earth-fixed to GCRS axes. Polar motion, which is under 0.6″, is left out.
glm::dmat3 gcrs_from_earth_fixed(const SkyState& sky) {
  const Instant ut1 = later(sky.when, -delta_t_s(sky.when));
  double r[3][3], equator_from_gcrs[3][3];
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      equator_from_gcrs[row][column] = sky.equator_from_gcrs[column][row];
  const double sidereal = eraGst06(ut1.tt_day, ut1.tt_fraction, sky.when.tt_day,
                                   sky.when.tt_fraction, equator_from_gcrs);
  eraIr(r);
  eraRz(sidereal, r);
  return glm::transpose(matrix_from_rows(r) * sky.equator_from_gcrs);
}

glm::dvec3 earth_fixed_position_m(const Observer& observer) {
  double xyz[3];
  eraGd2gc(ERFA_WGS84, algebra::in_radians(observer.longitude),
           algebra::in_radians(observer.latitude), algebra::in_metres(observer.elevation), xyz);
  return {xyz[0], xyz[1], xyz[2]};
}

/// Matrix with the unit vectors to a place's north, east and zenith as columns, in Earth-fixed axes, even at the poles.
glm::dmat3 earth_fixed_horizon(const Observer& observer) {
  const double latitude = algebra::in_radians(observer.latitude),
               longitude = algebra::in_radians(observer.longitude);
  const double sin_lat = std::sin(latitude), cos_lat = std::cos(latitude);
  const double sin_lon = std::sin(longitude), cos_lon = std::cos(longitude);
  return {{-sin_lat * cos_lon, -sin_lat * sin_lon, cos_lat},
          {-sin_lon, cos_lon, 0},
          {cos_lat * cos_lon, cos_lat * sin_lon, sin_lat}};
}

}  // namespace

void require_on_earth(const Observer& observer) {
  algebra::require_within("latitude [deg]", algebra::in_degrees(observer.latitude), -90, 90);
  algebra::require_within("longitude [deg]", algebra::in_degrees(observer.longitude), -360, 360);
  algebra::require_within("elevation [m]", algebra::in_metres(observer.elevation), -500, 1e5);
}

ObserverView view_from(const Observer& observer, const SkyState& sky) {
  require_on_earth(observer);
  const glm::dmat3 gcrs_from_earth = gcrs_from_earth_fixed(sky);
  ObserverView view;
  view.position_m = gcrs_from_earth * earth_fixed_position_m(observer);
  const glm::dmat3 gcrs_from_horizon = gcrs_from_earth * earth_fixed_horizon(observer);
  view.zenith = gcrs_from_horizon[2];
  view.north = glm::transpose(sky.equator_from_gcrs)[2];
  const glm::dvec3 to_moon_m = sky.moon_m - view.position_m;
  const glm::dvec3 direction = glm::normalize(to_moon_m);
  view.moon_distance = algebra::metres(glm::length(to_moon_m));
  const glm::dvec3 horizon = glm::transpose(gcrs_from_horizon) * direction;
  view.altitude = algebra::radians(std::atan2(horizon.z, std::hypot(horizon.x, horizon.y)));
  view.azimuth = algebra::within_circle(algebra::radians(std::atan2(horizon.y, horizon.x)));
  view.parallactic_angle = position_angle(direction, view.zenith, view.north);
  view.sub_observer = selenographic_point(sky.selenographic_from_gcrs * -to_moon_m);
  return view;
}

}  // namespace coppermoon::almanac
