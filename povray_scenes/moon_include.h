// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "almanac/observer.h"
#include "povray_scenes/camera.h"

namespace coppermoon::povray_scenes {

/// File of the sky beside moon.inc: latitude–longitude, north in the middle, east to the right of it.
inline constexpr const char* sky_file = "eclipse_sky.exr";

/// Eclipsed Moon in an observer's sky, for a scene written by hand.
struct MoonInSky {
  std::string texture;  ///< file name of the .exr beside it
  std::string title;    ///< moment and place, for the file's first line
  almanac::ObserverView view;
  algebra::Angle axis_position_angle;
  HorizonPlace place;                     ///< refraction included
  algebra::Angle sun_altitude;            ///< airless
  double sky_cd_m2 = 0;                   ///< luminance of the clear sky in the zenith
  std::array<double, 3> illuminance_lux;  ///< linear Rec.709, on a surface that faces the Moon
  bool up = true;  ///< else it is not seen, unless it is so much enlarged that some is above
};

/// Star or planet in an observer's sky.
struct StarInSky {
  HorizonPlace place;                     ///< refraction included
  std::array<double, 3> illuminance_lux;  ///< linear Rec.709, on a surface that faces it
};

/// Text of an include file for POV-Ray with stars: Eclipsed_Stars(Eye, Diameter, Distance). It includes coppermoon.inc.
///
/// Given   title  as MoonInSky's; stars: one or more
/// Throws  Error  when the title cannot stand in POV-Ray's text
std::string star_include(const std::string& title, std::span<const StarInSky> stars);

/// Text of an include file for POV-Ray: the Moon as an object in the sky, Eclipsed_Moon(Enlarged, Distance), its
/// light, Eclipsed_Moonlight(Factor), the sky, Eclipsed_Sky(Factor), and their numbers by name. It includes coppermoon.inc.
///
/// Throws  Error  when the texture's or the title's name cannot stand in POV-Ray's text
std::string moon_include(const MoonInSky& moon);

/// Text of coppermoon.inc.
std::string_view coppermoon_inc();

}  // namespace coppermoon::povray_scenes
