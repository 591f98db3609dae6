// SPDX-License-Identifier: MIT
#include "uses/film/fixed_view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "algebra/quantity.h"

namespace coppermoon::uses {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// Direction in axes of the horizon: north, east, zenith.
glm::dvec3 direction_of(const povray_scenes::HorizonPlace& place) {
  const double h = algebra::in_radians(place.altitude), a = algebra::in_radians(place.azimuth);
  return {std::cos(h) * std::cos(a), std::cos(h) * std::sin(a), std::sin(h)};
}

povray_scenes::HorizonPlace place_of(double altitude, double azimuth) {
  return {algebra::radians(altitude), algebra::radians(azimuth)};
}

/// Apparent Moons, and the picture's shape.
struct Moons {
  std::vector<glm::dvec3> directions;
  double sine_of_radius;  ///< of the largest disc
  double width_over_height;
};

/// Half of the field across the picture that holds a whole Moon; π / 2 where none does.
///
///     angle to the plane of a side, through the camera: at least the Moon's radius
double half_field_for(const Moons& moons, const glm::dvec3& moon,
                      const povray_scenes::HorizonPlace& aim) {
  const auto ahead = direction_of(aim);
  const auto across = glm::normalize(glm::cross(glm::dvec3(0, 0, 1), ahead));
  const auto half = [&](const glm::dvec3& side) {
    const double a = glm::dot(moon, ahead), b = std::abs(glm::dot(moon, side));
    return std::min(
        std::numbers::pi / 2,
        std::atan2(b, a) + std::asin(std::min(1., moons.sine_of_radius / std::hypot(a, b))));
  };
  const double upright = half(glm::cross(ahead, across));
  if (upright >= std::numbers::pi / 2) return upright;
  return std::max(half(across), std::atan(std::tan(upright) * moons.width_over_height));
}

/// The same for all Moons.
double half_field_for(const Moons& moons, const povray_scenes::HorizonPlace& aim) {
  double most = 0;
  for (const auto& moon : moons.directions) most = std::max(most, half_field_for(moons, moon, aim));
  return most;
}

/// Aim that needs the narrowest field, in steps of 0.1 degrees: a search by ever smaller steps from the middle of all
/// Moons on.
povray_scenes::HorizonPlace best_aim(const Moons& moons) {
  constexpr double tenth = 0.1 * degree, highest = 89 * degree;
  glm::dvec3 sum(0);
  for (const auto& moon : moons.directions) sum += moon;
  const auto stepped = [](double angle) { return std::round(angle / tenth) * tenth; };
  double altitude = stepped(std::atan2(sum.z, std::hypot(sum.x, sum.y))),
         azimuth = stepped(std::atan2(sum.y, sum.x));
  altitude = std::min(altitude, highest);
  double narrowest = half_field_for(moons, place_of(altitude, azimuth));
  for (double step = 12.8 * degree; step > tenth / 2;) {
    const double from_altitude = altitude, from_azimuth = azimuth, before = narrowest;
    for (const int up : {-1, 0, 1})
      for (const int right : {-1, 0, 1}) {
        const double h = std::clamp(from_altitude + up * step, -highest, highest),
                     a = from_azimuth + right * step;
        const double half = half_field_for(moons, place_of(h, a));
        if (half < narrowest) altitude = h, azimuth = a, narrowest = half;
      }
    if (narrowest == before) step /= 2;
  }
  const double turn = 2 * std::numbers::pi;
  return place_of(altitude, azimuth - turn * std::floor(azimuth / turn));
}

}  // namespace

FixedView fixed_view(const Film& film) {
  const auto& observer = *film.view.observer;
  const auto& frames = film.moments;
  const std::size_t step = std::max<std::size_t>(1, frames.frames.size() / 240);
  Moons moons{{}, 0, static_cast<double>(film.view.width) / static_cast<double>(film.view.height)};
  double half_field = 0;
  for (auto frame = frames.first_frame; frame <= frames.last_frame(); frame += step) {
    const auto sky = film.sky(frame);
    if (!moon_is_up(film.view, sky)) continue;
    if (half_field == 0)
      half_field = algebra::in_radians(view_of(film, sky).camera.horizontal_field) / 2;
    moons.directions.push_back(direction_of(apparent_place(observer, sky)));
    const auto seen = almanac::view_from(observer, sky);
    moons.sine_of_radius =
        std::max(moons.sine_of_radius, almanac::lunar_radius / seen.moon_distance);
  }
  FixedView view{.looked_at = moons.directions.size()};
  view.outside =
      static_cast<std::size_t>(std::ranges::count_if(moons.directions, [&](const glm::dvec3& moon) {
        return half_field_for(moons, moon, *film.view.aim) > half_field;
      }));
  if (view.outside == 0) return view;
  constexpr double widest_deg = 179;
  const auto aim = best_aim(moons);
  const double half = half_field_for(moons, aim), field_deg = half <= half_field
                                                                  ? 2 * half_field / degree
                                                                  : std::ceil(2 * half / degree);
  if (field_deg > widest_deg) return view;
  view.aim = aim;
  view.field_deg = field_deg;
  return view;
}

}  // namespace coppermoon::uses
