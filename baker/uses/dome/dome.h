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
  std::size_t width = 2048;  ///< [texels], a multiple of 4 from 16 to 16384; the height is half
  TextureContent content{};  ///< colour space and number type
  bool moon = false;         ///< whether to include the Moon itself, as a uniform disc
  double ground_albedo = 0;  ///< albedo of the ground below the horizon, 0 (black) to 1
};

/// Describes a dome's parameters: its width, the Moon, the ground's albedo, the colour space and the number type.
void describe(request::Parameters& is, DomeRequest& dome);

/// Throws  Error  if one of the dome's settings is outside its permitted range
void require_sound(const DomeRequest& dome);

/// Summary of a dome's light: illuminances, zenith luminance, extinction, and the altitudes of the Moon and the Sun.
struct DomeFigures {
  double zenith_cd_m2 = 0;  ///< luminance of the zenith, without stars
  double sky_lx = 0;        ///< illuminance on level ground by sky and stars, without the Moon
  double moon_lx = 0;       ///< illuminance by the Moon on a surface that faces it
  povray_scenes::HorizonPlace moon;  ///< apparent place of the Moon, with refraction
  algebra::Angle sun_altitude;       ///< without refraction
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
  texture::Attributes attributes;  ///< for the image file's header
  DomeFigures figures{};
};

/// Picture of the clear night sky over an observer, in a latitude–longitude projection. The zenith is at the top, the
/// horizon half-way down, north in the middle column, and east at three quarters of the width. The sky is seen from
/// inside and is not mirrored.
///
/// The sky's luminance comes from ClearSky. Stars and planets are points. Each is spread over the four nearest texels,
/// whose luminance times solid angle adds up to the star's illuminance through the air. The Moon, if requested, is a
/// uniform disc with the illuminance from brightness_of. Leave it out if the scene has a Moon of its own. The ground
/// is diffuse and lit by the sky, the stars and the Moon.
///
/// Moonlight is scattered as in ScatteredColour, with the eclipsed Moon's B − V and V − R. Twilight has the colour from
/// atmosphere::TwilightSky, airglow has B − V = 1.03 and V − R = 0.74 (Patat 2003), and stars are as in StarLights.
///
/// Given     moon      may be at any moment; a Moon below the horizon gives no light
///           view      gives the observer, the air and the stars (down to V = 6.5 unless the view sets another limit)
/// Returned  luminances [cd/m²], finite and not negative in every direction
/// Accuracy  that of ClearSky; relative errors of 1e-3 in the illuminance by stars and 1e-2 in that by the Moon
/// Omits     towns, Milky Way, zodiacal light, clouds, and stars that a high observer sees below the horizontal
/// Throws    Error     if there is no observer, if a catalogue is damaged, or if require_sound or air_over does
/// Source    colours of the night: Patat (2003), A&A 400, 1183
Dome dome_over(const DomeRequest& request, const LitMoon& moon, const ViewRequest& view);

/// Writes a picture of the sky without stars, for a renderer that draws the stars itself. The first row below the
/// horizon repeats the row above, so that the horizon stays bright if the renderer interpolates between rows.
void write_sky(const std::filesystem::path& file, const LitMoon& moon, ViewRequest view,
               const DomeRequest& dome = {.width = 1024});

}  // namespace coppermoon::uses
