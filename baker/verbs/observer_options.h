// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "almanac/observer.h"
#include "atmosphere/observer_air.h"
#include "povray_scenes/camera.h"
#include "verbs/flags.h"

namespace coppermoon::verbs {

/// A place on Earth as written on the command line: "LAT,LON" or "LAT,LON,ELEVATION" in degrees and
/// metres.
///
/// Throws Error when the text is no such place
almanac::Observer observer_from(const std::string& text);

/// From where, and through what, the Moon is seen.
struct ViewOptions {
  std::string at;  ///< empty: from the Earth's centre, without air
  std::optional<double> focal_length_mm, sensor_width_mm;  ///< without: 1540 mm, 22.7 mm
  std::optional<double> field_deg;
  std::size_t width = 1500, height = 1000;
  std::string up = "celestial-north", reddening = "on", flattening = "on";
  double observer_ozone_du = 300, observer_aerosol = 0.1;
  /// where the picture's middle points, as seen; without: to the Moon. Of a camera on a tripod
  std::optional<povray_scenes::HorizonPlace> aim = {};
};

void add_view_options(CLI::App& verb, ViewOptions& options);

/// A view of the Moon: the camera, and where the Moon stands for who holds it.
struct View {
  povray_scenes::Camera camera;
  std::optional<almanac::Observer> observer;
  std::optional<atmosphere::Sightline> sightline;  ///< through the air that reddens the Moon
};

/// Where the Moon is to be seen, refraction counted.
///
/// Throws Error as observer_from
povray_scenes::HorizonPlace apparent_place(const ViewOptions& options,
                                           const almanac::SkyState& sky);

/// "ALTITUDE,AZIMUTH" in degrees, from the horizon up, and from north through east.
///
/// Throws Error when the text is no such place
povray_scenes::HorizonPlace aim_from(const std::string& text);

/// Whether the Moon is above the observer's horizon, refraction counted; true without an observer.
bool moon_is_up(const ViewOptions& options, const almanac::SkyState& sky);

/// Throws Error when the Moon is below the observer's horizon, refraction counted: says by how much;
///        or when the observer's air is not sound
View view_of(const ViewOptions& options, const almanac::SkyState& sky);

}  // namespace coppermoon::verbs
