// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "algebra/described.h"
#include "almanac/sky.h"
#include "texture/image.h"
#include "uses/light/moonlight.h"

namespace coppermoon::uses {

/// Size and orientation of the ring's image and of the Earth in the Moon's sky. Position angles are measured about the
/// Earth's centre, from celestial north through east.
struct RingFigures {
  almanac::SelenographicPoint place;  ///< the observer's place on the Moon
  algebra::Angle inner, outer;        ///< angles from the Earth's centre to the image's edges
  double earth_distance_km = 0;
  algebra::Angle earth_altitude;
  std::optional<algebra::Angle> zenith;  ///< position angle; none if the Earth is at the zenith
  algebra::Angle sun;                    ///< position angle
  double scale = 1;
};

template <class Field>
void describe(Field&& is, const RingFigures& ring) {
  namespace unit = algebra::unit;
  is.a("Ring", "The Earth's ring of sunsets, as a place on the Moon sees it.");
  is("lunar_latitude", ring.place.latitude, unit::degrees, "latitude of the place on the Moon");
  is("lunar_longitude", ring.place.longitude, unit::degrees, "its longitude");
  is("inner_angle", ring.inner, unit::degrees, "angle of the inner edge from the Earth's centre");
  is("outer_angle", ring.outer, unit::degrees, "angle of the outer edge from the Earth's centre");
  is("earth_distance_km", ring.earth_distance_km, unit::kilometres, "distance of the Earth");
  is("earth_altitude", ring.earth_altitude, unit::degrees, "altitude of the Earth's centre");
  is("earth_north_position_angle", 0., unit::degrees,
     "position angle of the Earth's north, which angles are counted from");
  is("zenith_position_angle", ring.zenith, unit::degrees,
     "position angle of the zenith; none if the Earth is there");
  is("sun_position_angle", ring.sun, unit::degrees, "position angle of the Sun");
  is("scale", ring.scale, "factor on luminance");
}

/// The Earth's ring of sunsets, unrolled, as seen from a place on the eclipsed Moon.
struct RingStrip {
  /// Image in linear Rec.709 [cd/m²]. Columns are position angles about the Earth's centre, from celestial north
  /// through east. Rows are evenly spaced in the angle from the Earth's centre, with the outer edge at the top.
  texture::Image light;
  RingFigures figures;
  texture::Attributes attributes;  ///< for a file's header
};

/// Given   request  only its air and its Sun are used
///         on       place on the Moon; if absent, the point where the Earth is at the zenith
///         scale    factor on all values, 1e-9 to 1e9
/// Throws  Error    when no eclipse is under way, the Earth is below the place's horizon, direct sunlight
///                  reaches the place, or the air bends no light towards it
RingStrip ring_strip(const LightRequest& request, const almanac::SkyState& sky,
                     const std::optional<almanac::SelenographicPoint>& on = {}, double scale = 1);

}  // namespace coppermoon::uses
