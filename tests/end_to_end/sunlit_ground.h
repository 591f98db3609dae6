// SPDX-License-Identifier: MIT
// Which ground of an eclipsed Moon a frame's pixels show, and how much of the Sun is in view from
// there: circles alone, none of the program's light.
#pragma once

#include <cmath>
#include <glm/matrix.hpp>
#include <map>
#include <numbers>
#include <vector>

#include "eclipse/shadow_axis.h"
#include "povray_scenes/scene_camera.h"

namespace coppermoon::end_to_end {

/// Radii, and the height of the air, as in the paper.
constexpr double sun_km = 6.955e5, earth_km = 6378, moon_km = 1737, air_km = 42;

/// Area that two circles have in common, of the first one's.
inline double share_covered(double radius, double other, double distance) {
  if (distance >= radius + other) return 0;
  if (distance <= other - radius) return 1;
  const double a = radius * radius, b = other * other, s = distance * distance;
  const double first = a * std::acos((s + a - b) / (2 * distance * radius));
  const double second = b * std::acos((s + b - a) / (2 * distance * other));
  const double kite = std::sqrt(4 * s * a - (s + a - b) * (s + a - b)) / 2;
  return (first + second - kite) / (std::numbers::pi * a);
}

/// How the bodies stand.
struct Bodies {
  double depth_km, sun_distance_km;

  /// The part of the Sun's disc that a body as large as the Earth leaves in view.
  double sunlight(double axis_km, double body_km) const {
    const double sun_radius = sun_km / (sun_distance_km + depth_km);
    const double apart = axis_km / depth_km - axis_km / (sun_distance_km + depth_km);
    return 1 - share_covered(sun_radius, body_km / depth_km, apart);
  }

  /// Where the last of the Sun is lost behind the bare Earth.
  double umbra_km() const { return earth_km - depth_km * (sun_km - earth_km) / sun_distance_km; }
};

/// A pixel that the Moon's ground fills.
struct Ground {
  std::size_t row, column;
  double axis_km;
};

/// The Moon in the shadow, and where it is in a frame.
struct Scene {
  Bodies bodies;
  double moon_axis_km;
  std::vector<Ground> ground;
};

/// Distances from the shadow axis [km] of all pixels that hold ground, by row and column.
inline std::map<std::pair<std::size_t, std::size_t>, double> axis_distances(
    const almanac::SkyState& sky, const povray_scenes::SceneCamera& camera) {
  const auto axis = eclipse::shadow_axis(sky);
  std::map<std::pair<std::size_t, std::size_t>, double> all;
  constexpr double step_deg = 0.5;  // 15 km of ground
  for (double latitude = -90; latitude <= 90; latitude += step_deg)
    for (double longitude = -100; longitude <= 100; longitude += step_deg) {
      const almanac::SelenographicPoint place{algebra::degrees(latitude),
                                              algebra::degrees(longitude)};
      const auto pixel = povray_scenes::pixel_of(camera, place);
      if (!pixel) continue;
      const auto place_m = sky.moon_m + 1e3 * moon_km *
                                            (glm::transpose(sky.selenographic_from_gcrs) *
                                             almanac::selenographic_direction(place));
      all[{static_cast<std::size_t>(pixel->y), static_cast<std::size_t>(pixel->x)}] =
          in_metres(eclipse::place_in_shadow(axis, place_m).axis_distance) / 1e3;
    }
  return all;
}

/// Given     camera  its pixels 30 km or more on the Moon, which is whole and off the frame's edges
/// Returned  without the pixels at the limb, with sky in them or beside them
inline Scene scene_at(const almanac::SkyState& sky, const povray_scenes::SceneCamera& camera) {
  const auto axis = eclipse::shadow_axis(sky);
  const auto moon = eclipse::place_in_shadow(axis, sky.moon_m);
  Scene scene{{in_metres(moon.depth) / 1e3, in_metres(axis.sun_distance) / 1e3},
              in_metres(moon.axis_distance) / 1e3,
              {}};
  const auto all = axis_distances(sky, camera);
  for (const auto& [pixel, axis_km] : all) {
    const auto [row, column] = pixel;
    bool inside = true;
    for (const std::size_t r : {row - 1, row, row + 1})
      for (const std::size_t c : {column - 1, column, column + 1}) inside &= all.contains({r, c});
    if (inside) scene.ground.push_back({row, column, axis_km});
  }
  return scene;
}

}  // namespace coppermoon::end_to_end
