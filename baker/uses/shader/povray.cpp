// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <numbers>

#include "almanac/ephemeris.h"
#include "shadow/lookup_table.h"
#include "uses/shader/shader_languages.h"

namespace coppermoon::uses {
namespace {

double radii(double km) { return km / algebra::in_kilometres(almanac::lunar_radius); }

/// Declares a POV-Ray array of vectors that holds the coefficients of a power series.
std::string series(const char* name, const std::vector<glm::dvec3>& coefficients) {
  std::vector<std::string> vectors;
  for (const auto& v : coefficients)
    vectors.push_back(fmt::format("<{:.9g}, {:.9g}, {:.9g}>", v.x, v.y, v.z));
  return fmt::format("#declare Eclipse_{}_Series = array[{}] {{\n  {} }}\n", name, vectors.size(),
                     fmt::join(vectors, ",\n  "));
}

/// POV-Ray declarations of the Moon's motion, with y towards the Moon's north pole and z towards longitude 90° east.
std::string motion_of(ShadowMotion motion) {
  std::vector<glm::dvec3> centre;
  for (std::size_t i = 0; i < motion.centre[0].size(); ++i)
    centre.emplace_back(motion.centre[0][i], motion.centre[1][i], motion.centre[2][i]);
  for (auto& axis : motion.axes)
    for (auto& coefficient : axis) std::swap(coefficient.y, coefficient.z);
  return series("Centre", centre) + series("East", motion.axes[0]) +
         series("North", motion.axes[1]) + series("Away", motion.axes[2]);
}

/// POV-Ray functions that look up the light strip. Each of them returns a single number.
std::string reading_of(const LightStrip& strip) {
  std::vector<std::string> stretches;
  for (std::size_t s = 0; s < strip.stretches.size(); ++s) {
    const double from = radii(strip.from_km(s)), to = radii(strip.ends_km[s]);
    stretches.push_back(
        fmt::format("min(max((M - {:.9g})/{:.9g}, 0), 1)*{}", from, to - from, strip.stretches[s]));
  }
  const double thickness = strip.planes > 1 ? radii(strip.farthest_km - strip.nearest_km) : 1;
  return fmt::format(
      R"(#declare Eclipse_Length = function(X, Y, Z) {{ sqrt(X*X + Y*Y + Z*Z) }}
// of a distance A from the axis in depth D: the same in the middle plane, along a line from the limb
#declare Eclipse_In_Middle = function(A, D) {{ A + (A - {:.9g})*({:.9g}/D - 1)*min(A/{:.9g}, 1) }}
#declare Eclipse_Along = function(M) {{ ({} + 0.5)/{} }}
#declare Eclipse_Turns = function(E, N) {{ atan2(E + 1e-9, N)/{:.9g} }}
#declare Eclipse_Across = function(T) {{ ((T - floor(T))*{} + 0.5)/{} }}
#declare Eclipse_Deeper = function(D) {{ min(max((D - {:.9g})/{:.9g}, 0), 1) }}
#declare Eclipse_Mixed = function(Near, Far, Share) {{ pow(Near + (Far - Near)*Share, 2) }}
)",
      radii(shadow::limb_m / 1e3), radii(strip.middle_km()), radii(shadow::one_limb_m / 1e3),
      fmt::join(stretches, " + "), strip.roots.width, 2 * std::numbers::pi, strip.sectors,
      strip.roots.height, radii(strip.nearest_km), thickness);
}

/// Repeats a format string for red, green and blue. In the string, {0} stands for the channel's capitalised name, {1}
/// for its POV-Ray name, and {2} for the given number.
std::string each_channel(const char* text, double number = 0) {
  std::string all;
  for (const auto& [name, channel] :
       {std::pair{"Red", "red"}, {"Green", "green"}, {"Blue", "blue"}})
    all += fmt::format(fmt::runtime(text), name, channel, number);
  return all;
}

}  // namespace

std::string povray_of(const ShadowMotion& motion, const LightStrip& strip, const ShaderHead& head) {
  return fmt::format(
             R"(// SPDX-License-Identifier: MIT
// {0}: light on the Moon over full sunlight, made by coppermoon for POV-Ray 3.7.
//
// eclipse.pov shows its use. The Moon is a sphere of radius 1: longitude 0 at x, 90 degrees east at z, north at y
// (as in coppermoon.inc). Lengths are in lunar radii.

#declare Eclipse_Strip = function {{ pigment {{ image_map {{ exr "{1}" interpolate 2 once }} }} }}

// The Moon's centre <east, north, depth> in the shadow, and the shadow's axes: power series of a time from -1 to 1.
)",
             head.title, head.strip) +
         motion_of(motion) + "\n// Light at places of the strip.\n" + reading_of(strip) +
         each_channel(R"(#declare Eclipse_{0}_Texel = function(U, V, Share) {{
  Eclipse_Mixed(Eclipse_Strip(U, 1 - V, 0).{1}, Eclipse_Strip(U, {2} - V, 0).{1}, Share) }}
#declare Eclipse_{0}_In_Shadow = function(E, N, D) {{
  Eclipse_{0}_Texel(Eclipse_Along(Eclipse_In_Middle(Eclipse_Length(E, N, 0), D)),
                    Eclipse_Across(Eclipse_Turns(E, N)), Eclipse_Deeper(D)) }}
)",
                      1. / static_cast<double>(strip.planes)) +
         fmt::format(R"(
#macro Eclipse_Sum(Series)
  #local Sum = <0, 0, 0>;
  #for (I, dimension_size(Series, 1) - 1, 0, -1)
    #local Sum = Sum*Eclipse_Moment + Series[I];
  #end
  Sum
#end

// The shadow at a time: seconds from greatest eclipse, {} UTC. Declares
//   Eclipse_Red, Eclipse_Green, Eclipse_Blue   functions of x, y, z: factors on the sunlit Moon, 1 in full sunlight;
//                                              red, green and blue of {}
//   Eclipse_Earth, Eclipse_North, Eclipse_Sun  directions from the Moon's centre: the Earth's centre, the celestial
//                                              pole and the Sun, unit
//   Eclipse_Distance                           of the Earth's centre, in lunar radii
#macro Eclipse_At(Time)
  #declare Eclipse_Moment = min(max(Time/{:.9g} + 0.5, 0), 1)*2 - 1;
  #local Declination = {:.7g};  // of the point opposite to the Sun
)",
                     head.greatest, head.colour_space, 2 * motion.half_s, head.declination_rad) +
         R"(  #local Centre = Eclipse_Sum(Eclipse_Centre_Series);
  #local East = Eclipse_Sum(Eclipse_East_Series);
  #local North = Eclipse_Sum(Eclipse_North_Series);
  #local Away = Eclipse_Sum(Eclipse_Away_Series);
  #ifdef (Eclipse_Place) #undef Eclipse_Place #end
  #declare Eclipse_Place = function {
    transform {
      matrix <East.x, North.x, Away.x, East.y, North.y, Away.y, East.z, North.z, Away.z,
              Centre.x, Centre.y, Centre.z>
    }
  }
)" +
         each_channel(
             R"(  #ifdef (Eclipse_{0}_On_Ground) #undef Eclipse_{0}_On_Ground #undef Eclipse_{0} #end
  #declare Eclipse_{0}_On_Ground = function {{
    Eclipse_{0}_In_Shadow(Eclipse_Place(x, y, z).x, Eclipse_Place(x, y, z).y, Eclipse_Place(x, y, z).z) }}
  #declare Eclipse_{0} = function {{
    Eclipse_{0}_On_Ground(x/Eclipse_Length(x, y, z), y/Eclipse_Length(x, y, z), z/Eclipse_Length(x, y, z)) }}
)") + R"(  #declare Eclipse_Sun = -Away;
  #declare Eclipse_North = cos(Declination)*North - sin(Declination)*Eclipse_Sun;
  #local To_Earth = Centre.z*Eclipse_Sun - Centre.x*East - Centre.y*North;
  #declare Eclipse_Earth = vnormalize(To_Earth);
  #declare Eclipse_Distance = vlength(To_Earth);
#end

// The Moon, luminous: a pigment of the sunlit Moon, in cd/m2 up to 20000, times the light of Eclipse_At.
#macro Eclipse_Moon(Sunlit)
  #local Most = 20000;  // what a pigment's function has for 1
  #local Sunlit_Map = function { pigment { Sunlit } }
  sphere {
    0, 1
    pigment {
      average
      pigment_map {
        [ 1 function { min(Sunlit_Map(x, y, z).red*Eclipse_Red(x, y, z)/Most, 0.999999) }
          colour_map { [ 0 rgb 0 ] [ 1 rgb <3*Most, 0, 0> ] } ]
        [ 1 function { min(Sunlit_Map(x, y, z).green*Eclipse_Green(x, y, z)/Most, 0.999999) }
          colour_map { [ 0 rgb 0 ] [ 1 rgb <0, 3*Most, 0> ] } ]
        [ 1 function { min(Sunlit_Map(x, y, z).blue*Eclipse_Blue(x, y, z)/Most, 0.999999) }
          colour_map { [ 0 rgb 0 ] [ 1 rgb <0, 0, 3*Most> ] } ]
      }
    }
    finish { ambient 0 diffuse 0 emission 1 }
    no_shadow
  }
#end
)";
}

}  // namespace coppermoon::uses
