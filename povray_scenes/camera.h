// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "algebra/quantity.h"
#include "almanac/observer.h"
#include "almanac/sky.h"

namespace coppermoon::povray_scenes {

/// Direction that is up in the picture.
enum class Up {
  celestial_north,  ///< as on a chart: north up, east to the left
  zenith,           ///< as an observer standing there sees it
  moon_north        ///< the Moon's own north pole up
};

/// A pinhole camera, pixels square.
struct SceneCamera {
  glm::dvec3 position;              ///< Moon-fixed (X to 0°, Y to 90° E, Z north), in lunar radii
  glm::dvec3 up;                    ///< Moon-fixed, any length; not along the line of sight
  algebra::Angle horizontal_field;  ///< angle across the picture
  std::size_t width, height;        ///< in pixels
  double flattening = 1;            ///< of the disc by refraction: height over width
  glm::dvec3 zenith{0, 0, 0};       ///< Moon-fixed, any length: direction of flattening; 0: none
  glm::dvec3 direction{0, 0, 0};    ///< Moon-fixed, any length: of the picture's middle; 0: the
                                    ///< Moon's centre
};

/// Field of a camera and size of its picture.
struct Picture {
  algebra::Angle field;       ///< across the width; the Moon's disc is about 0.52 degrees
  std::size_t width, height;  ///< in pixels
};

/// Apparent place in an observer's sky, refraction included.
struct HorizonPlace {
  algebra::Angle altitude, azimuth;  ///< above the horizon; from north through east
};

/// Field of view across a sensor.
///
///     2 atan(w / 2f)
///
/// Given   focal_length  f, above 0;  sensor_width  w, above 0
/// Throws  Error  when either is not above 0
algebra::Angle field_of_view(algebra::Length focal_length, algebra::Length sensor_width);

/// Camera at a place on Earth, directed to the Moon; east is to the left when north is up.
///
/// Given   sky, view  the moment, and that place's view of it
/// Omits   refraction in the observer's air, which lifts the Moon and flattens it near the horizon: the caller sets
///         `flattening`
/// Throws  Error  when the camera would not be sound (see require_sound)
SceneCamera camera_at(const almanac::SkyState& sky, const almanac::ObserverView& view, Up up,
                      const Picture& picture);

/// Camera at the Earth's centre, directed to the Moon.
///
/// Throws  Error  also for Up::zenith, which the Earth's centre does not have
SceneCamera camera_at(const almanac::SkyState& sky, Up up, const Picture& picture);

/// Camera on a tripod, the zenith up: the Moon moves through its picture as through the sky.
///
/// Given   sky, view  the moment, and that place's view of it
///         aim        apparent place in the picture's middle; altitude -90 to 90 degrees, azimuth -360 to 360
/// Returned  at the observer's place; aim and zenith are turned down along the Moon's vertical by the Moon's
///           refraction, so that the Moon appears at its apparent place
/// Omits   the horizon: a Moon below it is shown none the less; flattening, as camera_at
/// Throws  Error  when the aim is out of its range, or the camera would not be sound, as with the
///                aim in the zenith (see require_sound)
SceneCamera camera_fixed(const almanac::SkyState& sky, const almanac::ObserverView& view,
                         const HorizonPlace& aim, const Picture& picture);

/// Unit vector from the camera to the picture's middle, Moon-fixed.
///
/// Given  camera  sound
glm::dvec3 line_of_sight(const SceneCamera& camera);

/// Map from the round Moon to the one flattened by refraction: a compression towards a plane through the centre.
///
///     I + (k − 1) v vᵀ        k: the flattening;  v: towards the zenith, across the line from the
///                             camera to the Moon's centre
///
/// Returned  Moon-fixed axes; nothing is moved along that line. The identity where the zenith is along it, or nowhere
/// Throws    Error  when the camera is not sound
glm::dmat3 flattened_by_air(const SceneCamera& camera);

/// Pixel of a place on the Moon (a sphere, flattened by refraction).
///
/// Given     place     of any longitude, also beyond 360 degrees
/// Returned  x to the right, y down, in pixels from the upper left corner: the first pixel's centre is (0.5, 0.5); also
///           outside the frame. Nothing for a place behind the limb or behind the camera
/// Accuracy  0.25 pixel against POV-Ray's own frames, fields of 0.02 to 120 degrees
/// Throws    Error  when the camera is not sound
std::optional<glm::dvec2> pixel_of(const SceneCamera& camera,
                                   const almanac::SelenographicPoint& place);

/// Refuses a camera outside its ranges.
///
/// Throws  Error  unless the camera stands outside the Moon and within 1e6 lunar radii, its field is 1e-8 to 179.9
///                degrees, its sides 1 to 65535 pixels, its flattening 0.8 to 1, its direction 0 or 1e-100 to 1e100
///                long, and `up` is off the line of sight by at least 1e-6 radians. The Moon need not be in the picture
void require_sound(const SceneCamera& camera);

/// Lines of sight of a camera, Moon-fixed, in lunar radii: corner + x across + y down.
struct Sight {
  glm::dvec3 position, corner, across, down;
  glm::dmat3 round_from_flattened;  ///< inverse of flattened_by_air
};

/// Throws  Error  when the camera is not sound
Sight sight_of(const SceneCamera& camera);

/// Place on the Moon that a pixel shows: inverse of pixel_of.
///
/// Given     pixel  from the upper left corner, y down, the first pixel's centre at (0.5, 0.5)
/// Returned  unit vector, Moon-fixed; nothing beside the Moon
std::optional<glm::dvec3> ground_at(const Sight& sight, const glm::dvec2& pixel);

}  // namespace coppermoon::povray_scenes
