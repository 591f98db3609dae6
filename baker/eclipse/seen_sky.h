// SPDX-License-Identifier: MIT
#pragma once

#include <glm/geometric.hpp>
#include <optional>

#include "algebra/described.h"
#include "almanac/observer.h"
#include "almanac/sky.h"
#include "atmosphere/astronomical_refraction.h"
#include "eclipse/shadow_axis.h"

namespace coppermoon::eclipse {

/// Sun, Moon and shadow at a moment, and the Moon as seen from a place.
struct SeenSky {
  almanac::SkyState sky;
  std::optional<almanac::ObserverView> view;  ///< view from a place; empty without a place
};

/// Lists the numbers that describe the Sun, the Moon and the shadow, with their units and meanings.
template <class Field>
void describe_sky(Field&& is, const almanac::SkyState& sky) {
  namespace unit = algebra::unit;
  const auto moon = [&] { return equatorial_place(sky, sky.moon_m); };
  is(
      "delta_t_s", [&] { return almanac::delta_t_s(sky.when); }, unit::seconds, "TT - UT1");
  is(
      "moon_ra_deg", [&] { return moon().right_ascension; }, unit::degrees,
      "apparent right ascension of the Moon, of date");
  is(
      "moon_dec_deg", [&] { return moon().declination; }, unit::degrees,
      "apparent declination of the Moon, of date");
  is(
      "moon_distance_km", [&] { return in_kilometres(moon().distance); }, unit::kilometres,
      "distance of the Moon from the Earth's centre");
  is("sun_distance_au", glm::length(sky.sun_m) / almanac::astronomical_unit_m, unit::au,
     "distance of the Sun");
  is("sub_earth_latitude_deg", sky.sub_earth.latitude, unit::degrees,
     "latitude of the place on the Moon under the Earth: libration");
  is("sub_earth_longitude_deg", sky.sub_earth.longitude, unit::degrees,
     "longitude of the place on the Moon under the Earth: libration");
  is("sub_solar_latitude_deg", sky.sub_solar.latitude, unit::degrees,
     "latitude of the place on the Moon under the Sun");
  is("sub_solar_longitude_deg", sky.sub_solar.longitude, unit::degrees,
     "longitude of the place on the Moon under the Sun");
  is("axis_position_angle_deg", sky.axis_position_angle, unit::degrees,
     "position angle of the Moon's north pole, from north through east");
  is(
      "axis_distance_km",
      [&] { return in_kilometres(place_in_shadow(shadow_axis(sky), sky.moon_m).axis_distance); },
      unit::kilometres, "distance of the Moon's centre from the axis of the Earth's shadow");
}

/// Lists the numbers that describe the Moon as seen from a place. They are absent if no place is given.
template <class Field>
void describe_view(Field&& is, const std::optional<almanac::ObserverView>& view) {
  namespace unit = algebra::unit;
  const auto of_place = [&](auto read) {
    return algebra::if_any(view ? std::optional(read(*view)) : std::nullopt);
  };
  using View = almanac::ObserverView;
  is("altitude_deg",
     of_place([](const View& v) { return atmosphere::apparent_altitude(v.altitude); }),
     unit::degrees, "altitude of the Moon's centre as the place sees it, raised by refraction");
  is("geometric_altitude_deg", of_place([](const View& v) { return v.altitude; }), unit::degrees,
     "altitude of the Moon's centre at the place, without refraction");
  is("azimuth_deg", of_place([](const View& v) { return v.azimuth; }), unit::degrees,
     "azimuth of the Moon's centre, from north through east");
  is("parallactic_angle_deg", of_place([](const View& v) { return v.parallactic_angle; }),
     unit::degrees, "angle at the Moon from celestial north to the zenith, through east");
  is("observer_moon_distance_km",
     of_place([](const View& v) { return in_kilometres(v.moon_distance); }), unit::kilometres,
     "distance of the Moon's centre from the place");
  is("sub_observer_latitude_deg", of_place([](const View& v) { return v.sub_observer.latitude; }),
     unit::degrees, "latitude of the place on the Moon under the observer");
  is("sub_observer_longitude_deg", of_place([](const View& v) { return v.sub_observer.longitude; }),
     unit::degrees, "longitude of the place on the Moon under the observer");
}

template <class Field>
void describe(Field&& is, const SeenSky& seen) {
  is.a("Sky", "Sun, Moon and shadow at one moment, and how the Moon is turned.");
  is("instant", seen.sky.when, "the moment, UTC");
  describe_sky(is, seen.sky);
  describe_view(is, seen.view);
}

}  // namespace coppermoon::eclipse
