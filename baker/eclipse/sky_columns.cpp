// SPDX-License-Identifier: MIT
#include "eclipse/sky_columns.h"

#include <glm/geometric.hpp>

#include "atmosphere/astronomical_refraction.h"
#include "eclipse/shadow_axis.h"

namespace coppermoon::eclipse {

using algebra::in_degrees, algebra::in_kilometres;

const std::vector<algebra::Column<almanac::SkyState>>& sky_columns() {
  using Sky = almanac::SkyState;
  static const std::vector<algebra::Column<Sky>> all{
      {"delta_t_s", [](const Sky& s) { return almanac::delta_t_s(s.when); }, "TT - UT1 [s]"},
      {"moon_ra_deg",
       [](const Sky& s) { return in_degrees(equatorial_place(s, s.moon_m).right_ascension); },
       "apparent right ascension of the Moon, of date [degrees]"},
      {"moon_dec_deg",
       [](const Sky& s) { return in_degrees(equatorial_place(s, s.moon_m).declination); },
       "apparent declination of the Moon, of date [degrees]"},
      {"moon_distance_km",
       [](const Sky& s) { return in_kilometres(equatorial_place(s, s.moon_m).distance); },
       "distance of the Moon from the Earth's centre [km]"},
      {"sun_distance_au",
       [](const Sky& s) { return glm::length(s.sun_m) / almanac::astronomical_unit_m; },
       "distance of the Sun [au]"},
      {"sub_earth_latitude_deg", [](const Sky& s) { return in_degrees(s.sub_earth.latitude); },
       "latitude of the place on the Moon under the Earth: libration [degrees]"},
      {"sub_earth_longitude_deg", [](const Sky& s) { return in_degrees(s.sub_earth.longitude); },
       "longitude of the place on the Moon under the Earth: libration [degrees]"},
      {"sub_solar_latitude_deg", [](const Sky& s) { return in_degrees(s.sub_solar.latitude); },
       "latitude of the place on the Moon under the Sun [degrees]"},
      {"sub_solar_longitude_deg", [](const Sky& s) { return in_degrees(s.sub_solar.longitude); },
       "longitude of the place on the Moon under the Sun [degrees]"},
      {"axis_position_angle_deg", [](const Sky& s) { return in_degrees(s.axis_position_angle); },
       "position angle of the Moon's north pole, from north through east [degrees]"},
      {"axis_distance_km",
       [](const Sky& s) {
         return in_kilometres(place_in_shadow(shadow_axis(s), s.moon_m).axis_distance);
       },
       "distance of the Moon's centre from the axis of the Earth's shadow [km]"}};
  return all;
}

const std::vector<algebra::Column<almanac::ObserverView>>& view_columns() {
  using View = almanac::ObserverView;
  static const std::vector<algebra::Column<View>> all{
      {"altitude_deg",
       [](const View& v) { return in_degrees(atmosphere::apparent_altitude(v.altitude)); },
       "altitude of the Moon's centre as the place sees it, raised by refraction [degrees]"},
      {"geometric_altitude_deg", [](const View& v) { return in_degrees(v.altitude); },
       "altitude of the Moon's centre at the place, without refraction [degrees]"},
      {"azimuth_deg", [](const View& v) { return in_degrees(v.azimuth); },
       "azimuth of the Moon's centre, from north through east [degrees]"},
      {"parallactic_angle_deg", [](const View& v) { return in_degrees(v.parallactic_angle); },
       "angle at the Moon from celestial north to the zenith, through east [degrees]"},
      {"observer_moon_distance_km", [](const View& v) { return in_kilometres(v.moon_distance); },
       "distance of the Moon's centre from the place [km]"},
      {"sub_observer_latitude_deg",
       [](const View& v) { return in_degrees(v.sub_observer.latitude); },
       "latitude of the place on the Moon under the observer [degrees]"},
      {"sub_observer_longitude_deg",
       [](const View& v) { return in_degrees(v.sub_observer.longitude); },
       "longitude of the place on the Moon under the observer [degrees]"}};
  return all;
}

}  // namespace coppermoon::eclipse
