// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "almanac/observer.h"
#include "povray_scenes/scene_camera.h"

namespace coppermoon::povray_scenes {

/// The file with the sky, beside moon.inc: a latitude–longitude image with north in the middle and east to its right.
inline constexpr const char* sky_file = "eclipse_sky.exr";

/// The eclipsed Moon in an observer's sky, for a scene written by hand.
struct MoonInSky {
  std::string texture;  ///< file name of the .exr beside it
  std::string title;    ///< moment and place, for the file's first line
  almanac::ObserverView view;
  algebra::Angle axis_position_angle;
  HorizonPlace place;                     ///< with refraction
  algebra::Angle sun_altitude;            ///< airless
  double sky_cd_m2 = 0;                   ///< luminance of the clear sky at the zenith
  std::array<double, 3> illuminance_lux;  ///< linear Rec.709, on a surface that faces the Moon
  bool up = true;  ///< if false, hidden unless enlarged until some of it is above the horizon
};

/// A star or planet in an observer's sky.
struct StarInSky {
  HorizonPlace place;                     ///< with refraction
  std::array<double, 3> illuminance_lux;  ///< linear Rec.709, on a surface that faces it
};

/// The text of an include file for POV-Ray that shows stars with Eclipsed_Stars(Eye, Diameter, Distance). It includes
/// coppermoon.inc.
///
/// Given   title  as in MoonInSky
///         stars  one or more
/// Throws  Error  if the title cannot stand in POV-Ray's text
std::string star_include(const std::string& title, std::span<const StarInSky> stars);

/// The text of an include file for POV-Ray with the Moon as an object in the sky, Eclipsed_Moon(Enlarged, Distance),
/// its light, Eclipsed_Moonlight(Factor), and the sky, Eclipsed_Sky(Factor), with named constants for their numbers. It
/// includes coppermoon.inc.
///
/// Throws  Error  if the texture's name or the title cannot stand in POV-Ray's text
std::string moon_include(const MoonInSky& moon);

/// The text of coppermoon.inc.
std::string_view coppermoon_inc();

}  // namespace coppermoon::povray_scenes
