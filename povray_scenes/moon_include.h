// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "almanac/observer.h"
#include "povray_scenes/camera.h"

namespace coppermoon::povray_scenes {

/// An eclipsed Moon over a place, for a scene written by hand.
struct MoonInSky {
  std::string texture;  ///< file name of the .exr beside it
  std::string title;    ///< the moment and the place, for the file's head
  almanac::ObserverView view;
  algebra::Angle axis_position_angle;
  HorizonPlace place;                     ///< as it is seen, refraction counted
  std::array<double, 3> illuminance_lux;  ///< linear Rec.709, on a surface that faces the Moon
};

/// A star or planet over a place.
struct StarInSky {
  HorizonPlace place;                     ///< as it is seen, refraction counted
  std::array<double, 3> illuminance_lux;  ///< linear Rec.709, on a surface that faces it
};

/// A file that a scene includes: some stars, Eclipsed_Stars(Eye, Diameter, Distance). It
/// includes coppermoon.inc.
///
/// Given   title  as MoonInSky's; stars: one or more
/// Throws  Error  when the title cannot stand in POV-Ray's text
std::string star_include(const std::string& title, std::span<const StarInSky> stars);

/// A file that a scene includes: the Moon as an object in the sky, Eclipsed_Moon(Enlarged, Distance), its
/// light, Eclipsed_Moonlight(Factor), and all numbers of it by name. It includes coppermoon.inc.
///
/// Throws  Error  when the texture's or the title's name cannot stand in POV-Ray's text
std::string moon_include(const MoonInSky& moon);

/// The text of coppermoon.inc.
std::string_view coppermoon_inc();

}  // namespace coppermoon::povray_scenes
