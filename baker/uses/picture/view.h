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
  /// V magnitude, −5 to 20; if absent, as faint as the catalogue goes, or in a landscape as the naked eye sees.
  std::optional<double> faintest{};
};

/// Observer, air and field for a view of the Moon.
struct ViewRequest {
  std::optional<almanac::Observer> observer{};  ///< if absent, the Earth's centre, without air
  /// If only one of them is given, the paper's value is used for the other. If neither is given, the shorter side of
  /// the frame spans 0.6 degrees, enough for the whole Moon at any distance.
  std::optional<double> focal_length_mm{}, sensor_width_mm{};
  std::optional<double> field_deg{};        ///< angle across the frame, instead of the two lengths
  std::size_t width = 1500, height = 1000;  ///< of the frame [pixels]
  povray_scenes::Up up = povray_scenes::Up::celestial_north;
  bool reddening = true, flattening = true;  ///< by the observer's air
  double observer_ozone_du = 300, observer_aerosol = 0.1;
  /// Apparent place in the picture's middle, for a camera on a tripod; if absent, the Moon.
  std::optional<povray_scenes::HorizonPlace> aim = {};
  StarRequest stars = {};
  /// Luminance of an even sky, 0 for black; if absent, the clear sky over the observer (ClearSky), or none from space.
  std::optional<double> sky_cd_m2 = {};
};

/// A view of the Moon: camera, observer, and the line of sight through the observer's air.
struct View {
  povray_scenes::SceneCamera camera;
  std::optional<almanac::Observer> observer;
  std::optional<atmosphere::Sightline> sightline;  ///< through the air that reddens the Moon
  StarRequest stars = {};
  bool refracted = false;  ///< the observer's air flattens the Moon's disc and moves the stars
  atmosphere::ObserverAir air = {};      ///< over the observer, the source of the sky's light
  std::optional<double> sky_cd_m2 = {};  ///< as in the request
  std::string response = {};  ///< gives stars their colours, as in colour::channel_weights
};

/// Text for a place on Earth: "42.86,-73.77" [degrees], followed by its elevation if it has one [m].
std::string place_text(const almanac::Observer& observer);

/// Apparent place of the Moon in an observer's sky.
povray_scenes::HorizonPlace apparent_place(const almanac::Observer& observer,
                                           const almanac::SkyState& sky);

/// True altitude of a light that appears on the sea horizon as seen from a place.
///
///     h = −34′ − 2.12′ √(H / m)        H: the place's elevation; below sea level it counts as 0
///
/// Omits   mountains, and high land around a high place; weather, which changes refraction by some
///         arcminutes. Above 10 km the altitude is too low: by 0.6 degrees at 100 km
/// Source  Explanatory Supplement to the Ephemeris (1961), on rising and setting: 34′, and 1.17′ √(H / ft)
algebra::Angle horizon_altitude(const almanac::Observer& observer);

/// Altitude of the Moon's upper limb above a place's horizon; below 0, nothing of the Moon is seen.
algebra::Angle above_horizon(const almanac::Observer& observer, const almanac::SkyState& sky);

/// Whether any of the Moon is above the observer's horizon; true without an observer.
bool moon_is_up(const ViewRequest& request, const almanac::SkyState& sky);

/// Axes of an observer's sky in a frame: apparent east, north and up. The frame has the Moon at its place
/// without air, so the Moon's refraction is subtracted from every direction, along the Moon's vertical circle.
///
/// Given     view  with an observer
/// Returned  columns, Moon-fixed
glm::dmat3 axes_as_seen(const View& view, const almanac::SkyState& sky);

/// Removes from a frame what the horizon hides: dims each pixel by its share below the horizon.
///
/// Given  frame  from the view's camera; in space nothing is hidden
void hide_below_horizon(texture::Image& frame, const View& view, const almanac::SkyState& sky);

/// Air above a place, as a request describes it.
///
/// Throws  Error  when one of its quantities is out of range
atmosphere::ObserverAir air_over(const almanac::Observer& observer, const ViewRequest& request);

/// Throws Error when the Moon is wholly below the observer's horizon (the error says by how much), or when the
///        observer's air is out of range
View view_of(const ViewRequest& request, const almanac::SkyState& sky);

/// Moonrise or moonset.
struct Crossing {
  almanac::Instant when;
  bool rises;
};

/// Moonrises and moonsets at a place between two moments, in order of time: zeros of above_horizon, which includes
/// parallax.
///
/// Accuracy  0.1 s, from the Moon's place; weather changes refraction, and so the time by a minute or more
/// Throws    Error  as require_on_earth
std::vector<Crossing> horizon_crossings(const almanac::Observer& place,
                                        const almanac::Instant& from, const almanac::Instant& to);

}  // namespace coppermoon::uses
