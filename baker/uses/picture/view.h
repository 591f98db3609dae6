// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "almanac/observer.h"
#include "atmosphere/observer_air.h"
#include "povray_scenes/camera.h"

namespace coppermoon::uses {

/// The camera of Yapo & Cutler (2009).
inline constexpr double paper_focal_length_mm = 1540, paper_sensor_width_mm = 22.7;

/// Stars and planets around the Moon.
struct StarRequest {
  bool shown = true;
  /// V magnitude, −5 to 20; without: as faint as the catalogue is, in a landscape to the naked eye
  std::optional<double> faintest{};
};

/// From where, and through what, the Moon is seen.
struct ViewRequest {
  std::optional<almanac::Observer> observer{};  ///< without: from the Earth's centre, without air
  /// Of a lens; without one of them: that of the paper. Without both: the whole Moon, with some margin,
  /// wherever it is, on a frame of any shape: the shorter side takes in 0.6 degrees.
  std::optional<double> focal_length_mm{}, sensor_width_mm{};
  std::optional<double> field_deg{};        ///< angle across the frame, instead of these two
  std::size_t width = 1500, height = 1000;  ///< of the frame [pixels]
  povray_scenes::Up up = povray_scenes::Up::celestial_north;
  bool reddening = true, flattening = true;  ///< by the observer's air
  double observer_ozone_du = 300, observer_aerosol = 0.1;
  /// where the picture's middle points, as seen; without: to the Moon. Of a camera on a tripod
  std::optional<povray_scenes::HorizonPlace> aim = {};
  StarRequest stars = {};
};

/// A view of the Moon: the camera, and where the Moon stands for who holds it.
struct View {
  povray_scenes::Camera camera;
  std::optional<almanac::Observer> observer;
  std::optional<atmosphere::Sightline> sightline;  ///< through the air that reddens the Moon
  StarRequest stars = {};
  bool refracted = false;  ///< by the observer's air, which flattens a disc and moves stars
};

/// A place on Earth in words: "42.86,-73.77", and its elevation where it has one [degrees, m].
std::string place_text(const almanac::Observer& observer);

/// Where an observer sees the Moon, refraction counted.
povray_scenes::HorizonPlace apparent_place(const almanac::Observer& observer,
                                           const almanac::SkyState& sky);

/// Whether the Moon is above the observer's horizon, refraction counted; true without an observer.
bool moon_is_up(const ViewRequest& request, const almanac::SkyState& sky);

/// Throws Error when the Moon is below the observer's horizon, refraction counted: says by how much;
///        or when the observer's air is not sound
View view_of(const ViewRequest& request, const almanac::SkyState& sky);

}  // namespace coppermoon::uses
