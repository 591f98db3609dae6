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

/// Which direction is up in the picture.
enum class Up {
  celestial_north,  ///< as on a chart: north up, east to the left
  zenith,           ///< as an observer who stands upright sees it
  moon_north        ///< with the Moon's own north pole up
};

/// A pinhole camera with square pixels.
struct SceneCamera {
  glm::dvec3 position;              ///< Moon-fixed axes (X 0°, Y 90° E, Z north), lunar radii
  glm::dvec3 up;                    ///< Moon-fixed, of any length, not along the line of sight
  algebra::Angle horizontal_field;  ///< angle across the picture
  std::size_t width, height;        ///< in pixels
  double flattening = 1;            ///< height of the refracted disc divided by its width
  /// Direction of the zenith, along which refraction flattens the disc; Moon-fixed, any length; 0 for no flattening.
  glm::dvec3 zenith{0, 0, 0};
  /// Direction to the middle of the picture, in Moon-fixed axes, any length; 0 means towards the Moon's centre.
  glm::dvec3 direction{0, 0, 0};
};

/// The field of a camera and the size of its picture.
struct Picture {
  algebra::Angle field;       ///< angle across the width; the Moon's disc is about 0.52 degrees
  std::size_t width, height;  ///< in pixels
};

/// A place in an observer's sky, as it appears with refraction.
struct HorizonPlace {
  algebra::Angle altitude, azimuth;  ///< azimuth is counted from north through east
};

/// The field of view across the width of a sensor.
///
///     2 atan(w / 2f)
///
/// Given   focal_length  f;  sensor_width  w
/// Throws  Error  if the focal length or the width is not above 0
algebra::Angle field_of_view(algebra::Length focal_length, algebra::Length sensor_width);

/// A camera at a place on the Earth that points at the Moon. East is to the left if north is up.
///
/// Given   sky, view  the sky at the moment of the picture, and the Moon as seen from the place
/// Omits   refraction, which lifts the Moon and flattens it near the horizon; the caller can set `flattening`
/// Throws  Error  if require_sound does not accept the camera
SceneCamera camera_at(const almanac::SkyState& sky, const almanac::ObserverView& view, Up up,
                      const Picture& picture);

/// A camera at the Earth's centre that points at the Moon.
///
/// Throws  Error  if require_sound rejects the camera, or for Up::zenith, because the Earth's centre has no zenith
SceneCamera camera_at(const almanac::SkyState& sky, Up up, const Picture& picture);

/// A camera on a tripod, with the zenith up. The Moon moves through the picture as it does through the sky.
///
/// Given   sky, view  the sky at the moment of the picture, and the Moon as seen from the place
///         aim        apparent place of the picture's middle; altitude -90 to 90 degrees, azimuth -360 to 360 degrees
/// Returned  a camera at the observer's place. The aim and the zenith are turned downwards by as much as refraction
///           lifts the Moon, so that the Moon is at its apparent place in the picture
/// Omits   the horizon, so that the Moon is shown even if it is below; flattening, as in camera_at
/// Throws  Error  if the aim is out of range or is the zenith, or if require_sound does not accept the camera
SceneCamera camera_fixed(const almanac::SkyState& sky, const almanac::ObserverView& view,
                         const HorizonPlace& aim, const Picture& picture);

/// The unit vector from the camera towards the middle of the picture, in Moon-fixed axes.
///
/// Given  camera  a camera that require_sound accepts
glm::dvec3 line_of_sight(const SceneCamera& camera);

/// The matrix that flattens the round Moon as refraction does, by compression towards a plane through its centre.
///
///     I + (k − 1) v vᵀ        k: the flattening;  v: unit vector towards the zenith, perpendicular to
///                             the line from the camera to the Moon's centre
///
/// Returned  a matrix for Moon-fixed axes; the identity if the camera's zenith is 0 or in line with the Moon's centre
/// Throws    Error  if require_sound does not accept the camera
glm::dmat3 flattened_by_air(const SceneCamera& camera);

/// The pixel that shows a place on the Moon (a sphere flattened by refraction).
///
/// Given     place     a place with any longitude, even beyond 360 degrees
/// Returned  x to the right and y down, in pixels from the upper left corner; the first pixel's centre is (0.5, 0.5).
///           The pixel may be outside the frame. nullopt if the place is behind the Moon's limb or behind the camera
/// Accuracy  0.25 pixels, compared with POV-Ray's frames with fields of 0.02 to 120 degrees
/// Throws    Error  if require_sound does not accept the camera
std::optional<glm::dvec2> pixel_of(const SceneCamera& camera,
                                   const almanac::SelenographicPoint& place);

/// Checks that all values of a camera are within their ranges. The Moon need not be in the picture.
///
/// Throws  Error  unless the camera is outside the Moon and within 1e6 lunar radii, its field is 1e-8 to 179.9 degrees,
///                its width and height are 1 to 65535 pixels, its flattening is 0.8 to 1, its direction has a length of
///                0 or 1e-100 to 1e100, and `up` differs from the line of sight by at least 1e-6 radians
void require_sound(const SceneCamera& camera);

/// Lines of sight from a camera: corner + x across + y down for pixel (x, y), in Moon-fixed axes and lunar radii.
struct Sight {
  glm::dvec3 position, corner, across, down;
  glm::dmat3 round_from_flattened;  ///< inverse of flattened_by_air
};

/// The lines of sight through all pixels of a camera.
///
/// Throws  Error  if require_sound does not accept the camera
Sight sight_of(const SceneCamera& camera);

/// The place on the Moon that a pixel shows: the inverse of pixel_of.
///
/// Given     pixel  x and y from the upper left corner, y down; the first pixel's centre is (0.5, 0.5)
/// Returned  unit vector in Moon-fixed axes; nullopt if the pixel does not show the Moon
std::optional<glm::dvec3> ground_at(const Sight& sight, const glm::dvec2& pixel);

}  // namespace coppermoon::povray_scenes
