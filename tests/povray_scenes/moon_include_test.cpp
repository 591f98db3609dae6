// SPDX-License-Identifier: MIT
#include "povray_scenes/moon_include.h"

#include "povray_scenes/folder.h"
#include "povray_scenes/moon_scene.h"
#include "povray_scenes/pictures.h"
#include "povray_scenes/render.h"
#include "support/testing.h"

namespace coppermoon::povray_scenes::moon_include_test {

using algebra::degrees;
using std::numbers::pi;

constexpr double altitude = 40 * pi / 180, moonlight_lux = 0.01, starlight_lux = 2e-6,
                 star_radius = 1 * pi / 180;

/// White ground below, the sky above, a star in it; the Moon stands behind the camera.
///
/// Given  globals   of global_settings
///        enlarged  the Moon, how many times
///        sky       luminance
Luminance landscape(const std::string& globals, double enlarged, double sky) {
  const TemporaryFolder folder;
  MoonInSky moon{};
  moon.texture = "moon.exr";
  moon.title = "a test";
  moon.view.moon_distance = algebra::metres(384400e3);
  moon.place = {algebra::radians(altitude), degrees(180)};
  moon.illuminance_lux = {moonlight_lux, moonlight_lux, moonlight_lux};
  const std::array stars{
      StarInSky{{degrees(20), degrees(0)}, {starlight_lux, starlight_lux, starlight_lux}}};
  uniform_texture(1000).write((folder.path / "moon.exr").string());
  std::ofstream(folder.path / "moon.inc") << moon_include(moon);
  std::ofstream(folder.path / "eclipse_stars.inc") << star_include("a test", stars);
  std::ofstream(folder.path / "coppermoon.inc") << coppermoon_inc();
  write_scene(folder.path, {.camera = {.position = {221, 0, 0},
                                       .up = {0, 0, 1},
                                       .horizontal_field = degrees(60),
                                       .width = 61,
                                       .height = 60},
                            .texture = "moon.exr"});
  std::ofstream(folder.path / settings_file, std::ios::app) << "Antialias=off\n";
  std::ofstream(folder.path / scene_file)
      << "#version 3.7;\nglobal_settings { assumed_gamma 1.0 " << globals
      << " }\n#include \"moon.inc\"\n"
      << "#include \"eclipse_stars.inc\"\n"
      << "camera { location y right x up y angle 90 "
         "look_at Coppermoon_Direction(0, 0) + y }\n"
      << "sky_sphere { pigment { rgb " << sky << " } }\n"
      << "object { Eclipsed_Moon(" << enlarged << ", 1e6) }\n"
      << "Eclipsed_Moonlight(1)\nEclipsed_Stars(y, 2, 2e6)\n"
      << "plane { y, 0 pigment { rgb 1 } finish { diffuse 1 } }\n";
  return Luminance(render(folder.path));
}

constexpr double moonlit_ground = moonlight_lux / pi;  // times the sine of the Moon's altitude

TEST(MoonInclude, LightsTheGroundByItsIlluminanceAndAddsStarsToTheSky) {
  constexpr double sky = 1e-3;
  const auto picture = landscape("", 1, sky);
  EXPECT_WITHIN_RELATIVE(picture.at(30, 50), moonlit_ground * std::sin(altitude), 1e-3,
                         "half floats; neither the Moon's shadow nor ambient light");
  EXPECT_WITHIN_RELATIVE(picture.at(5, 5), sky, 1e-3, "half floats");
  // a field of 90 degrees: an altitude of 20 degrees is 0.364 of 30 pixels above the middle
  const double star = starlight_lux / (pi * std::pow(std::sin(star_radius), 2));
  EXPECT_WITHIN_RELATIVE(picture.at(30, 19), sky + star, 3e-3, "a star takes 0.2 % of the sky");
  EXPECT_GT(star, sky);
}

TEST(MoonInclude, HidesAMoonBelowTheHorizonUnlessEnlargedItReachesAboveIt) {
  MoonInSky moon{};
  moon.texture = "moon.exr";
  moon.view.moon_distance = algebra::metres(384400e3);
  moon.place = {degrees(-1), degrees(0)};
  const std::string hidden = "no_image no_reflection";
  EXPECT_SAYS_NOT(moon_include(moon), hidden);
  moon.up = false;
  const auto luminance = [&](double enlarged) {
    const TemporaryFolder folder;
    uniform_texture(1000).write((folder.path / "moon.exr").string());
    std::ofstream(folder.path / "moon.inc") << moon_include(moon);
    std::ofstream(folder.path / "coppermoon.inc") << coppermoon_inc();
    write_scene(folder.path, {.camera = {.position = {221, 0, 0},
                                         .up = {0, 0, 1},
                                         .horizontal_field = degrees(60),
                                         .width = 16,
                                         .height = 16},
                              .texture = "moon.exr"});
    std::ofstream(folder.path / scene_file)
        << "#version 3.7;\nglobal_settings { assumed_gamma 1.0 }\n#include \"moon.inc\"\n"
        << "camera { right x up y angle 0.2 look_at Coppermoon_Direction(-1, 0) }\n"
        << "object { Eclipsed_Moon(" << enlarged << ", 1e6) }\n";
    return Luminance(render(folder.path)).at(8, 8);
  };
  EXPECT_EQ(luminance(3), 0);
  EXPECT_WITHIN_RELATIVE(luminance(5), 1000, 1e-3, "half floats; it is 1.3 degrees in radius");
}

TEST(MoonInclude, GivesItsLightOnceInASceneWithRadiosity) {
  const auto picture = landscape("radiosity { count 200 error_bound 0.5 }", 30, 0);
  EXPECT_WITHIN_RELATIVE(picture.at(30, 50), moonlit_ground * std::sin(altitude), 1e-3,
                         "half floats; radiosity adds no moonlight");
}

}  // namespace coppermoon::povray_scenes::moon_include_test
