// SPDX-License-Identifier: MIT
#include "uses/picture/clear_sky.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "uses/picture/view.h"

namespace coppermoon::uses {
namespace {

algebra::Angle altitude_of(const glm::dvec3& direction) {
  return algebra::radians(std::asin(std::clamp(direction.z, -1., 1.)));
}

algebra::Angle between(const glm::dvec3& a, const glm::dvec3& b) {
  return algebra::radians(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

glm::dvec3 sun_in_sky(const almanac::ObserverView& view, const almanac::SkyState& sky) {
  const auto sun = glm::normalize(sky.sun_m - view.position_m),
             east = glm::normalize(glm::cross(view.north, view.zenith));
  return {glm::dot(sun, east), glm::dot(sun, glm::cross(view.zenith, east)),
          glm::dot(sun, view.zenith)};
}

/// The Sun's altitude, or that of bright twilight by day.
algebra::Angle of_twilight(algebra::Angle sun_altitude) {
  return std::min(sun_altitude, algebra::degrees(5));
}

}  // namespace

ClearSky::ClearSky(const almanac::Observer& place, const almanac::SkyState& sky,
                   const atmosphere::ObserverAir& air, double moon_magnitude)
    : extinction_mag_(atmosphere::visual_extinction_mag(air)),
      moon_{moon_magnitude, almanac::view_from(place, sky).altitude},
      to_sun_(sun_in_sky(almanac::view_from(place, sky), sky)),
      sun_altitude_(altitude_of(to_sun_)),
      twilight_(of_twilight(sun_altitude_), extinction_mag_) {
  const auto seen = apparent_place(place, sky);
  to_moon_ = in_sky(seen.altitude, seen.azimuth);
}

SkyTerms ClearSky::towards(const glm::dvec3& direction) const {
  const auto altitude = altitude_of(direction);
  return {atmosphere::airglow_cd_m2(altitude, extinction_mag_),
          twilight_.luminance_cd_m2({altitude, from_sun(direction)}),
          atmosphere::moonlit_sky_cd_m2(moon_, {altitude, from_moon(direction)}, extinction_mag_)};
}

algebra::Angle ClearSky::from_moon(const glm::dvec3& direction) const {
  return between(direction, to_moon_);
}

algebra::Angle ClearSky::from_sun(const glm::dvec3& direction) const {
  return between(direction, to_sun_);
}

glm::dvec3 in_sky(algebra::Angle altitude, algebra::Angle azimuth) {
  const double a = algebra::in_radians(altitude), b = algebra::in_radians(azimuth);
  return {std::cos(a) * std::sin(b), std::cos(a) * std::cos(b), std::sin(a)};
}

}  // namespace coppermoon::uses
