// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <glm/vec3.hpp>

#include "povray_scenes/scene_camera.h"

namespace coppermoon::povray_scenes {

constexpr double moon_distance_m = 384400e3, earth_radius_m = 6371e3;

/// A sky made by hand: the Moon on the celestial equator at right ascension 0, its north pole to
/// the north, longitude 0 towards the Earth's centre. Its 90° E is then west in the sky.
inline almanac::SkyState moon_at_the_equinox() {
  almanac::SkyState sky{};
  sky.moon_m = {moon_distance_m, 0, 0};
  sky.sun_m = {-1.496e11, 0, 0};
  sky.selenographic_from_gcrs = {{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
  sky.equator_from_gcrs = glm::dmat3(1);
  return sky;
}

/// A place on a round Earth that has this Moon on its meridian: due south of it or due north.
inline almanac::ObserverView on_the_meridian(algebra::Angle latitude) {
  almanac::ObserverView view{};
  const double l = in_radians(latitude);
  view.zenith = {std::cos(l), 0, std::sin(l)};
  view.position_m = earth_radius_m * view.zenith;
  view.north = {0, 0, 1};
  return view;
}

/// An observer at the Earth's centre with a horizon such that this Moon is due east.
inline almanac::ObserverView moon_in_the_east(algebra::Angle true_altitude) {
  almanac::ObserverView view{};
  const double h = in_radians(true_altitude);
  view.zenith = {std::sin(h), 0, std::cos(h)};
  view.north = {0, 1, 0};
  return view;
}

inline almanac::SelenographicPoint place(double latitude_deg, double longitude_deg) {
  return {algebra::degrees(latitude_deg), algebra::degrees(longitude_deg)};
}

}  // namespace coppermoon::povray_scenes
