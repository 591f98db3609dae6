// SPDX-License-Identifier: MIT
#include "povray_scenes/moon_include.h"

#include <fmt/format.h>

#include <cmath>

#include "algebra/error.h"
#include "povray_scenes/tables.h"

namespace coppermoon::povray_scenes {
namespace {

void require_plain(const std::string& text) {
  if (text.find_first_of("\"\\\n") != std::string::npos)
    throw algebra::Error(fmt::format("{}: allowed without quotes and lines for POV-Ray", text));
}

}  // namespace

std::string moon_include(const MoonInSky& moon) {
  require_plain(moon.texture);
  require_plain(moon.title);
  const auto degrees = [](algebra::Angle angle) { return algebra::in_degrees(angle); };
  const double diameter =
      2 * degrees(algebra::radians(std::asin(almanac::lunar_radius / moon.view.moon_distance)));
  const auto& lux = moon.illuminance_lux;
  return fmt::format(
      R"(// The eclipsed Moon of {}, made by coppermoon: for POV-Ray scenes of your own.
//
//   #version 3.7;
//   global_settings {{ assumed_gamma 1.0 }}
//   #include "moon.inc"
//   camera {{ location 0 look_at Coppermoon_Direction(Moon_Altitude, Moon_Azimuth) angle 30 }}
//   Eclipsed_Sky(1)
//   object {{ Eclipsed_Moon(1, 1e6) }}
//   Eclipsed_Moonlight(1)
//
// eclipse_stars.inc beside it has the stars.
//
// y is up, z north, x east. Luminance is in cd/m2: render to OpenEXR and develop it with `coppermoon develop`.
#include "coppermoon.inc"

// POV-Ray's usual ambient light is 0.1 cd/m2 on white, more than the full Moon gives. From here on there is none.
#default {{ finish {{ ambient 0 }} }}

#declare Moon_Altitude = {:.6f};           // [degrees] as it is seen
#declare Moon_Azimuth = {:.6f};            // [degrees] from north through east
#declare Moon_Diameter = {:.6f};           // [degrees]
#declare Moon_Latitude = {:.6f};           // [degrees] of the middle of the disc
#declare Moon_Longitude = {:.6f};          // [degrees] of the same, east positive
#declare Moon_Axis_Angle = {:.6f};         // [degrees] of the Moon's north pole, from celestial north through east
#declare Moon_Parallactic_Angle = {:.6f};  // [degrees] of the zenith
#declare Moon_Illuminance = rgb <{:.6g}, {:.6g}, {:.6g}>;  // [lux] linear Rec.709, on what faces the Moon
#declare Sun_Altitude = {:.6f};            // [degrees] without refraction; below the horizon less than 0
#declare Sky_Luminance = {:.6g};           // [cd/m2] of the clear sky in the zenith

// The clear night sky of that moment: airglow, twilight, and moonlight that the air scatters. It lights the scene where
// that has radiosity. Call it before Eclipsed_Moon, which then shines through that air.
//   Factor  how many times as bright as it was; 1: as it was
#macro Eclipsed_Sky(Factor)
  #declare Coppermoon_Air = Factor;
  #declare Coppermoon_Sky_Pigment = pigment {{
    image_map {{ exr "{}" map_type 1 interpolate 2 }}
    rotate y*90
    scale <-1, 1, 1>
  }}
  sky_sphere {{
    pigment {{ Coppermoon_Sky_Pigment }}
    emission Factor
  }}
#end

// The Moon in the sky of the origin; translate it by your camera's place. It lights nothing, not even by
// radiosity: its light is Eclipsed_Moonlight.
//   Enlarged  how many times as large as it was; 1: as it was
//   Distance  of its centre, in your scene's units; larger than the scene
#macro Eclipsed_Moon(Enlarged, Distance)
  #ifndef (Coppermoon_Air)
    #local Air = <0, 0, 0>;
  #else
    // light of the air 3 degrees beside the Moon, clear of its aureole
    #local Sky = function {{ pigment {{ Coppermoon_Sky_Pigment }} }};
    #local To = Coppermoon_Direction(Moon_Altitude, Moon_Azimuth + 3/cos(radians(min(Moon_Altitude, 80))));
    #local Seen = Sky(To.x, To.y, To.z);
    #local Air = Coppermoon_Air*<Seen.red, Seen.green, Seen.blue>;
  #end
  object {{
    Coppermoon_Moon_In_Air("{}", Air)
    Coppermoon_In_Sky(Moon_Latitude, Moon_Longitude, Moon_Axis_Angle, Moon_Parallactic_Angle,
                      Moon_Altitude, Moon_Azimuth, Enlarged*Moon_Diameter, Distance)
    no_radiosity{}
  }}
#end

// The Moon's light on the scene: a wall of `pigment {{ rgb 1 }} finish {{ diffuse 1 }}` that faces it gets the
// luminance of illuminance over pi.
//   Factor  how many times as bright as it was; 1: as it was
#macro Eclipsed_Moonlight(Factor)
  light_source {{
    1e6*Coppermoon_Direction(Moon_Altitude, Moon_Azimuth) Factor*Moon_Illuminance/pi
    parallel point_at <0, 0, 0>
  }}
#end
)",
      moon.title, degrees(moon.place.altitude), degrees(moon.place.azimuth), diameter,
      degrees(moon.view.sub_observer.latitude), degrees(moon.view.sub_observer.longitude),
      degrees(moon.axis_position_angle), degrees(moon.view.parallactic_angle), lux[0], lux[1],
      lux[2], degrees(moon.sun_altitude), moon.sky_cd_m2, sky_file, moon.texture,
      moon.up
          ? ""
          : "\n    #if (Moon_Altitude + Enlarged*Moon_Diameter/2 < 0) no_image no_reflection #end");
}

std::string star_include(const std::string& title, std::span<const StarInSky> stars) {
  require_plain(title);
  auto text = fmt::format(
      R"(// Stars and planets of {}, made by coppermoon: for POV-Ray scenes of your own.
//
//   #include "eclipse_stars.inc"
//   object {{ Eclipsed_Moon(1, 1e5) }}
//   Eclipsed_Stars(0, 0.1, 2e5)
//
// y is up, z north, x east, as in moon.inc. The brightest come first.
#include "coppermoon.inc"

// All of them. Each is an object of its own, so that POV-Ray finds its way among them.
//   Eye       your camera's place
//   Diameter  [degrees] that each is given: two pixels of your picture. Their light stays the same
//   Distance  in your scene's units: beyond the Moon; from 1e6 on POV-Ray takes minutes
#macro Eclipsed_Stars(Eye, Diameter, Distance)
)",
      title);
  for (const auto& [place, lux] : stars)
    text += fmt::format(
        "  object {{ Coppermoon_Star({:.4f}, {:.4f}, <{:.4g}, {:.4g}, {:.4g}>, Diameter, Distance) "
        "translate Eye "
        "}}\n",
        algebra::in_degrees(place.altitude), algebra::in_degrees(place.azimuth), lux[0], lux[1],
        lux[2]);
  return text + "#end\n";
}

std::string_view coppermoon_inc() { return tables::coppermoon(); }

}  // namespace coppermoon::povray_scenes
