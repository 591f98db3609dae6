// SPDX-License-Identifier: MIT
#pragma once

#include <glm/mat3x3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "almanac/instant.h"
#include "almanac/observer.h"
#include "atmosphere/observer_air.h"
#include "povray_scenes/camera.h"
#include "texture/image.h"

namespace coppermoon::uses {

/// The camera of Yapo & Cutler (2009).
inline constexpr double paper_focal_length_mm = 1540, paper_sensor_width_mm = 22.7;

/// Stars and planets around the Moon.
struct StarRequest {
  bool shown = true;
  /// V magnitude, −5 to 20; without: as faint as the catalogue is, in a landscape to the naked eye
  std::optional<double> faintest{};
};

/// Observer, air and field of a view of the Moon.
struct ViewRequest {
  std::optional<almanac::Observer> observer{};  ///< without: from the Earth's centre, without air
  /// Of a lens; without one of them: that of the paper. Without both: the shorter side of the frame is 0.6 degrees,
  /// enough for the whole Moon at any distance.
  std::optional<double> focal_length_mm{}, sensor_width_mm{};
  std::optional<double> field_deg{};        ///< angle across the frame, instead of these two
  std::size_t width = 1500, height = 1000;  ///< of the frame [pixels]
  povray_scenes::Up up = povray_scenes::Up::celestial_north;
  bool reddening = true, flattening = true;  ///< by the observer's air
  double observer_ozone_du = 300, observer_aerosol = 0.1;
  /// Apparent place in the picture's middle, for a camera on a tripod; without: the Moon.
  std::optional<povray_scenes::HorizonPlace> aim = {};
  StarRequest stars = {};
  /// Luminance of an even sky, 0: black; without: the clear sky over the observer (ClearSky), from space none
  std::optional<double> sky_cd_m2 = {};
};

/// View of the Moon: camera, observer, and the Moon's place in the observer's sky.
struct View {
  povray_scenes::SceneCamera camera;
  std::optional<almanac::Observer> observer;
  std::optional<atmosphere::Sightline> sightline;  ///< through the air that reddens the Moon
  StarRequest stars = {};
  bool refracted = false;  ///< by the observer's air, which flattens a disc and moves stars
  atmosphere::ObserverAir air = {};      ///< over the observer, which shines
  std::optional<double> sky_cd_m2 = {};  ///< as the request's
  std::string response = {};  ///< by which stars have their colours, as in colour::channel_weights
};

/// Text of a place on Earth: "42.86,-73.77" [degrees], with its elevation where it has one [m].
std::string place_text(const almanac::Observer& observer);

/// Apparent place of the Moon in an observer's sky.
povray_scenes::HorizonPlace apparent_place(const almanac::Observer& observer,
                                           const almanac::SkyState& sky);

/// True altitude of a light that appears on the sea's horizon, seen from a place.
///
///     h = −34′ − 2.12′ √(H / m)        H: the place's elevation; one below the sea counts as 0
///
/// Omits   mountains, and that land around a high place may be high too; weather, which changes refraction
///         by some minutes. Above 10 km it is too low: by 0.6 degrees at 100 km
/// Source  Explanatory Supplement to the Ephemeris (1961), on rising and setting: 34′, and 1.17′ √(H / ft)
algebra::Angle horizon_altitude(const almanac::Observer& observer);

/// Altitude of the Moon's upper limb above a place's horizon; below 0 nothing of the Moon is seen.
algebra::Angle above_horizon(const almanac::Observer& observer, const almanac::SkyState& sky);

/// Whether some of the Moon is above the observer's horizon; true without an observer.
bool moon_is_up(const ViewRequest& request, const almanac::SkyState& sky);

/// Axes of an observer's sky in a frame: east, north and up as they are seen. The frame holds the Moon at its place
/// without air, so the Moon's refraction is taken from every direction, along the Moon's vertical.
///
/// Given     view  with an observer
/// Returned  columns, Moon-fixed
glm::dmat3 axes_as_seen(const View& view, const almanac::SkyState& sky);

/// Removes from a frame what the horizon hides: each pixel by its share below the horizon.
///
/// Given  frame  of the view's camera; from space nothing is hidden
void hide_below_horizon(texture::Image& frame, const View& view, const almanac::SkyState& sky);

/// Air above a place, as a request has it.
///
/// Throws  Error  when a term of it is outside its range
atmosphere::ObserverAir air_over(const almanac::Observer& observer, const ViewRequest& request);

/// Throws Error when nothing of the Moon is above the observer's horizon: says by how much; or when the
///        observer's air is not sound
View view_of(const ViewRequest& request, const almanac::SkyState& sky);

/// Moonrise or moonset.
struct Crossing {
  almanac::Instant when;
  bool rises;
};

/// Moonrises and moonsets of a place between two moments, in order of time: zeros of above_horizon, which has parallax.
///
/// Accuracy  0.1 s, by the Moon's place; weather changes refraction, and so the time by a minute or more
/// Throws    Error  as require_on_earth
std::vector<Crossing> horizon_crossings(const almanac::Observer& place,
                                        const almanac::Instant& from, const almanac::Instant& to);

}  // namespace coppermoon::uses
