// SPDX-License-Identifier: MIT
#pragma once

#include <glm/mat3x3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "almanac/instant.h"
#include "almanac/observer.h"
#include "atmosphere/observer_air.h"
#include "povray_scenes/scene_camera.h"
#include "texture/image.h"

namespace coppermoon::uses {

/// The camera of Yapo & Cutler (2009).
inline constexpr double paper_focal_length_mm = 1540, paper_sensor_width_mm = 22.7;

/// Stars and planets around the Moon.
struct StarRequest {
  bool shown = true;
  /// V magnitude, −5 to 20; if absent, the limit of the catalogue or, in a landscape, of the naked eye.
  std::optional<double> faintest{};
};

/// Observer, air and field for a view of the Moon.
struct ViewRequest {
  std::optional<almanac::Observer> observer{};  ///< if absent, the Earth's centre, without air
  /// If only one is given, the other is that of Yapo & Cutler's camera. If neither is given, the shorter side of
  /// the frame spans 0.6 degrees, enough for the whole Moon at any distance.
  std::optional<double> focal_length_mm{}, sensor_width_mm{};
  std::optional<double> field_deg{};        ///< angle across the frame, instead of the two lengths
  std::size_t width = 1500, height = 1000;  ///< of the frame [pixels]
  povray_scenes::Up up = povray_scenes::Up::celestial_north;
  bool reddening = true, flattening = true;  ///< whether the air has these effects
  double observer_ozone_du = 300, observer_aerosol = 0.1;
  /// The apparent place at which a camera on a tripod points. If absent, the Moon is in the middle of the picture.
  std::optional<povray_scenes::HorizonPlace> aim = {};
  StarRequest stars = {};
  /// Luminance of an even sky, 0 for black. If absent, the clear sky over the observer (ClearSky), or black from space.
  std::optional<double> sky_cd_m2 = {};
};

/// A view of the Moon: camera, observer, and the line of sight through the observer's air.
struct View {
  povray_scenes::SceneCamera camera;
  std::optional<almanac::Observer> observer;
  std::optional<atmosphere::Sightline> sightline;  ///< through the air that reddens the Moon
  StarRequest stars = {};
  bool refracted = false;  ///< whether the air flattens the Moon's disc and moves the stars
  atmosphere::ObserverAir air = {};      ///< air over the observer, the source of the sky's light
  std::optional<double> sky_cd_m2 = {};  ///< luminance of an even sky, as in ViewRequest
  std::string response = {};  ///< response for the stars' colours, as in colour::channel_weights
};

/// Text for a place on Earth: "42.86,-73.77" [degrees], followed by its elevation if it has one [m].
std::string place_text(const almanac::Observer& observer);

/// Apparent place of the Moon in an observer's sky.
povray_scenes::HorizonPlace apparent_place(const almanac::Observer& observer,
                                           const almanac::SkyState& sky);

/// True altitude of an object that appears on the sea horizon as seen from a place.
///
///     h = −34′ − 2.12′ √(H / m)        H: the place's elevation; below sea level it counts as 0
///
/// Omits   mountains, and high land around a high place; weather, which changes refraction by some
///         arcminutes. Above 10 km the result is too low: by 0.6 degrees at 100 km
/// Source  Explanatory Supplement to the Ephemeris (1961), on rising and setting: 34′, and 1.17′ √(H / ft)
algebra::Angle horizon_altitude(const almanac::Observer& observer);

/// Altitude of the Moon's upper limb above a place's horizon. If it is negative, the whole Moon is below the horizon.
algebra::Angle above_horizon(const almanac::Observer& observer, const almanac::SkyState& sky);

/// Whether any of the Moon is above the observer's horizon; true without an observer.
bool moon_is_up(const ViewRequest& request, const almanac::SkyState& sky);

/// Axes of an observer's sky in a frame: apparent east, north and up. A frame shows the Moon at its place
/// without air, so the Moon's refraction is subtracted from every direction, along the Moon's vertical circle.
///
/// Given     view  must have an observer
/// Returned  the axes as columns, in Moon-fixed coordinates
glm::dmat3 axes_as_seen(const View& view, const almanac::SkyState& sky);

/// Removes from a frame what lies below the horizon: each pixel is dimmed by its share below the horizon.
///
/// Given  frame  as the view's camera sees it; nothing is hidden from a camera in space
void hide_below_horizon(texture::Image& frame, const View& view, const almanac::SkyState& sky);

/// Air above a place, as a request describes it.
///
/// Throws  Error  when one of its quantities is out of range
atmosphere::ObserverAir air_over(const almanac::Observer& observer, const ViewRequest& request);

/// Throws Error when the whole Moon is below the observer's horizon (the message states by how much), or when the
///        observer's ozone, aerosol or elevation is out of range
View view_of(const ViewRequest& request, const almanac::SkyState& sky);

/// A moonrise or a moonset.
struct Crossing {
  almanac::Instant when;
  bool rises;
};

/// Moonrises and moonsets at a place between two moments, in order of time: when above_horizon, which includes
/// parallax, is zero.
///
/// Accuracy  0.1 s for the Moon's motion; but weather changes refraction, and with it the time by a minute or more
/// Throws    Error  when require_on_earth does
std::vector<Crossing> horizon_crossings(const almanac::Observer& place,
                                        const almanac::Instant& from, const almanac::Instant& to);

}  // namespace coppermoon::uses
