// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "almanac/observer.h"
#include "povray_scenes/scene_camera.h"

namespace coppermoon::povray_scenes {

/// File name of the image of the sky, in the same folder as moon.inc. It is a latitude–longitude image with north in
/// the middle and east to the right of north.
inline constexpr const char* sky_file = "eclipse_sky.exr";

/// The eclipsed Moon in an observer's sky, for a scene written by hand.
struct MoonInSky {
  std::string texture;  ///< file name of the .exr in the same folder
  std::string title;    ///< moment and place, for the first line of the include file
  almanac::ObserverView view;
  algebra::Angle axis_position_angle;
  HorizonPlace place;                     ///< the Moon's place, with refraction
  algebra::Angle sun_altitude;            ///< the Sun's altitude, without refraction
  double sky_cd_m2 = 0;                   ///< luminance of the clear sky at the zenith
  std::array<double, 3> illuminance_lux;  ///< linear Rec.709, on a surface that faces the Moon
  bool up = true;  ///< false if the whole disc is below the horizon, where only enlarging shows it
};

/// A star or planet in an observer's sky.
struct StarInSky {
  HorizonPlace place;                     ///< the star's place, with refraction
  std::array<double, 3> illuminance_lux;  ///< linear Rec.709, on a surface that faces the star
};

/// The text of an include file for POV-Ray with the macro Eclipsed_Stars(Eye, Diameter, Distance), which shows stars.
/// The file includes coppermoon.inc.
///
/// Given   title  moment and place, for the first line
///         stars  one or more stars
/// Throws  Error  if the title has characters that are not allowed in POV-Ray's text
std::string star_include(const std::string& title, std::span<const StarInSky> stars);

/// Text of an include file for POV-Ray with the macros Eclipsed_Moon(Enlarged, Distance), Eclipsed_Moonlight(Factor)
/// and Eclipsed_Sky(Factor), and with constants that hold the values in `moon`. The file includes coppermoon.inc.
///
/// Throws  Error  if the texture's name or the title has characters that are not allowed in POV-Ray's text
std::string moon_include(const MoonInSky& moon);

/// The text of coppermoon.inc.
std::string_view coppermoon_inc();

}  // namespace coppermoon::povray_scenes
