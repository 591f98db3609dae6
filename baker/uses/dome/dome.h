// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "algebra/described.h"
#include "povray_scenes/scene_camera.h"
#include "request/parameter.h"
#include "texture/image.h"
#include "uses/picture/baked_moon.h"
#include "uses/picture/view.h"

namespace coppermoon::uses {

/// Settings for a picture of the whole sky.
struct DomeRequest {
  std::size_t width = 2048;  ///< a multiple of 4, 16 to 16384 texels; half as many rows
  TextureContent content{};  ///< colour space and number type
  bool moon = false;         ///< whether to include the Moon itself, as a uniform disc
  double ground_albedo = 0;  ///< below the horizon, 0 to 1; 0: black
};

/// Describes a dome's parameters: width, Moon, ground, space and type.
void describe(request::Parameters& is, DomeRequest& dome);

/// Throws  Error  when one of the dome's numbers is outside its range
void require_sound(const DomeRequest& dome);

/// What a dome shows, in numbers.
struct DomeFigures {
  double zenith_cd_m2 = 0;  ///< without stars
  double sky_lx = 0;        ///< from the sky and stars on level ground, without the Moon itself
  double moon_lx = 0;       ///< from the Moon, on a surface that faces it
  povray_scenes::HorizonPlace moon;  ///< apparent place, with refraction
  algebra::Angle sun_altitude;       ///< airless
  double extinction_mag = 0;
};

template <class Field>
void describe(Field&& is, const DomeFigures& sky) {
  namespace unit = algebra::unit;
  is.a("DomeFigures", "What a dome shows, in numbers.");
  is("zenith_luminance_cd_m2", sky.zenith_cd_m2, unit::luminance,
     "luminance of the zenith, without stars");
  is("sky_illuminance_lx", sky.sky_lx, unit::illuminance,
     "illuminance by the sky and the stars on level ground, without the Moon itself");
  is("moon_illuminance_lx", sky.moon_lx, unit::illuminance,
     "illuminance by the Moon on a surface that faces it");
  is("moon_altitude_deg", sky.moon.altitude, unit::degrees, "altitude of the Moon, as seen");
  is("moon_azimuth_deg", sky.moon.azimuth, unit::degrees,
     "azimuth of the Moon, from north through east");
  is("sun_geometric_altitude_deg", sky.sun_altitude, unit::degrees,
     "altitude of the Sun, without refraction");
  is("extinction_mag", sky.extinction_mag, unit::mag,
     "magnitudes by which the air dims the zenith");
}

/// Luminance of the night sky in all directions.
struct Dome {
  texture::Image light;            ///< in the requested colour space [cd/m²]
  texture::Attributes attributes;  ///< for a file's header
  DomeFigures figures{};
};

/// Clear night sky over an observer as a latitude–longitude picture: zenith at the top, horizon half-way down,
/// north in the middle column, and east to its right, at three quarters of the width. It is seen from inside, and not
/// mirrored.
///
/// Luminance comes from ClearSky. Stars and planets are points: each spreads its light over the four texels around
/// it, so that luminance times solid angle adds up to its illuminance through the air. The Moon, if asked for, is a
/// uniform disc with the illuminance from brightness_of; leave it out if the scene has a Moon as geometry. The ground
/// is diffuse and lit by sky, stars and Moon.
///
/// Colours: moonlight as scattered by air (ScatteredColour), from a Moon with the eclipse's B − V and V − R; twilight
/// as in atmosphere::TwilightSky; airglow with B − V = 1.03 and V − R = 0.74 (Patat 2003); stars as in StarLights.
///
/// Given     moon      at any moment; below the horizon it lights nothing
///           view      its observer, air and stars (to V = 6.5 unless it says how faint)
/// Returned  [cd/m²]   finite and not below 0 in every direction
/// Accuracy  as ClearSky; 1e-3 in the illuminance from stars, 1e-2 in that from the Moon
/// Omits     towns, Milky Way and zodiacal light, clouds, stars that a high place sees below the horizontal
/// Throws    Error     without an observer; as require_sound, air_over; when a catalogue is damaged
/// Source    colours of the night: Patat (2003), A&A 400, 1183
Dome dome_over(const DomeRequest& request, const LitMoon& moon, const ViewRequest& view);

/// Writes a sky without stars, for a renderer that draws its own. The first row below the horizon repeats the row above
/// it, so that the horizon stays bright in a renderer that interpolates rows.
void write_sky(const std::filesystem::path& file, const LitMoon& moon, ViewRequest view,
               const DomeRequest& dome = {.width = 1024});

}  // namespace coppermoon::uses
