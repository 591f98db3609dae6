// SPDX-License-Identifier: MIT
// A scene is whole: it renders with POV-Ray alone, wherever it is moved.
#include <nlohmann/json.hpp>

#include "support/program.h"
#include "texture/read_image.h"

namespace coppermoon::end_to_end::scene_folder_test {

class SceneFolder : public ProgramTest {
 protected:
  void write_scene(const std::string& renderer = "povray") const {
    expect_done(coppermoon(
        words_of("scene 2008-02-21T03:26:05Z --at 42.86,-73.77 --rays 50 --albedo-map built-in "
                 "--atmosphere undated --texture-width 64 --width 32 --height 24 --for {} -o scene",
                 renderer)));
  }
};

TEST_F(SceneFolder, HoldsSceneSettingsAndTexture) {
  write_scene();
  const std::set<std::string> expected{"here/scene",
                                       "here/scene/coppermoon.inc",
                                       "here/scene/eclipse.ini",
                                       "here/scene/eclipse.pov",
                                       "here/scene/eclipse_air.exr",
                                       "here/scene/eclipse_sky.exr",
                                       "here/scene/eclipse_stars.inc",
                                       "here/scene/moon.inc",
                                       "here/scene/moon_lin_rec709.exr"};
  std::set<std::string> found = listing();
  EXPECT_EQ(found, expected);
  const std::filesystem::path of_povray = "/usr/share/povray-3.7/include";
  ASSERT_TRUE(std::filesystem::exists(of_povray / "stars.inc"));
  for (const std::filesystem::path file : expected)
    EXPECT_FALSE(std::filesystem::exists(of_povray / file.filename()))
        << file << ": from another folder `#include` would read POV-Ray's own";
}

TEST_F(SceneFolder, ForMitsubaHoldsItsSceneAndTheSameTexture) {
  write_scene();
  const auto texture = text_of(here("scene/moon_lin_rec709.exr"));
  std::filesystem::remove_all(here("scene"));
  write_scene("mitsuba");
  const std::set<std::string> expected{"here/scene", "here/scene/eclipse.xml",
                                       "here/scene/moon.obj", "here/scene/moon_lin_rec709.exr"};
  EXPECT_EQ(listing(), expected);
  const auto pixels = texture::read_image(here("scene/moon_lin_rec709.exr"));
  write_scene();  // beside it: both renderers have one texture
  EXPECT_EQ(texture::read_image(here("scene/moon_lin_rec709.exr")).values, pixels.values);
  EXPECT_EQ(text_of(here("scene/moon_lin_rec709.exr")), texture);
  file("scene/moon.obj", "mine");
  const auto refused = coppermoon("scene 2018-07-27 --for mitsuba -o scene");
  EXPECT_EQ(refused.status, 1);
  EXPECT_EQ(text_of(here("scene/moon.obj")), "mine");
}

TEST_F(SceneFolder, RendersWithPovrayAloneWhereverItIsMoved) {
  write_scene();
  std::filesystem::rename(here("scene"), here("moved with spaces"));
  const auto outcome = run("povray eclipse.ini", {.folder = here("moved with spaces")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto frame = texture::read_image(here("moved with spaces") / "frame.exr");
  EXPECT_EQ(frame.width, 32U);
  EXPECT_EQ(frame.height, 24U);
  EXPECT_GT(frame(12, 16, 0), frame(12, 16, 2)) << "an eclipsed Moon is red";
  EXPECT_GT(frame(12, 16, 0), 0.01F);
  EXPECT_GT(frame(0, 0, 0), 1e-4F) << "airglow, 1.9e-4 cd/m2 at the zenith (Patat 2003)";
  EXPECT_LT(frame(0, 0, 0), 1e-3F);
}

TEST_F(SceneFolder, LosesNoFileOfSomebodyElse) {
  std::filesystem::create_directory(here("scene"));
  file("precious.txt", "mine");
  for (const char* name : {"eclipse.pov", "moon.inc", "moon_lin_rec709.exr", "eclipse_sky.exr"})
    for (const bool link : {false, true}) {
      const auto path = here("scene") / name;
      if (link)
        std::filesystem::create_symlink("../precious.txt", path);
      else
        file(std::string("scene/") + name, "mine");
      const auto outcome = coppermoon("scene 2018-07-27 --at Nairobi -o scene");
      EXPECT_EQ(outcome.status, 1);
      EXPECT_TRUE(outcome.err.starts_with("coppermoon: scene/" + std::string(name) + ": is "))
          << outcome.err;
      EXPECT_EQ(text_of(path), "mine");
      EXPECT_EQ(listing().size(), 3U) << "nothing else was written";
      std::filesystem::remove(path);
    }
}

/// The numbers behind a name in moon.inc.
std::vector<double> declared(const std::string& text, const std::string& name) {
  auto from = text.find("#declare " + name + " =");
  std::vector<double> numbers;
  for (from = text.find_first_of("-0123456789", from); text[from] != '\n' && text[from] != '/';
       from = text.find_first_of("-0123456789/\n", from)) {
    std::size_t length = 0;
    numbers.push_back(std::stod(text.substr(from), &length));
    from += length;
  }
  return numbers;
}

TEST_F(SceneFolder, MoonIncHasTheMoonAndItsLightForAnotherScene) {
  write_scene();
  const auto include = text_of(here("scene/moon.inc"));
  const auto sky =
      nlohmann::json::parse(coppermoon("sky 2008-02-21T03:26:05Z --at 42.86,-73.77 --json").out);
  EXPECT_NEAR(declared(include, "Moon_Azimuth")[0], sky["azimuth_deg"], 1e-5) << "as it is printed";
  EXPECT_NEAR(declared(include, "Moon_Parallactic_Angle")[0], sky["parallactic_angle_deg"], 1e-5);
  // illuminance is mean luminance times the disc's solid angle: both are sums over texels
  const auto seen =
      nlohmann::json::parse(coppermoon("brightness 2008-02-21T03:26:05Z --at 42.86,-73.77 --rays "
                                       "50 --albedo-map built-in --atmosphere undated --json")
                                .out)["seen"];
  const auto lux = declared(include, "Moon_Illuminance");
  ASSERT_EQ(lux.size(), 3U);
  const double radius = declared(include, "Moon_Diameter")[0] / 2 * std::numbers::pi / 180,
               expected =
                   seen["mean_luminance_cd_m2"].get<double>() * std::numbers::pi * radius * radius,
               found = 0.2126 * lux[0] + 0.7152 * lux[1] + 0.0722 * lux[2];
  EXPECT_NEAR(found / expected, 1, 0.01) << "360 and 720 texels around, half a percent each";
  EXPECT_NEAR(found / seen["illuminance_lx"].get<double>(), 1, 0.01) << "the same texels";
  EXPECT_GT(lux[0], lux[2]) << "an eclipsed Moon's light is red";
}

TEST_F(SceneFolder, MoonIncHasTheSkyTheRightWayRound) {
  write_scene();
  // four pictures of the sky alone, towards the quarters, against texels of the dome
  const auto dome = texture::read_image(here("scene/eclipse_sky.exr"));
  const auto include = text_of(here("scene/moon.inc"));
  const double moon = declared(include, "Moon_Azimuth")[0];
  for (const double aside : {-60., 0., 60., 180.}) {
    const double azimuth = moon + aside, altitude = 30;
    file("scene/look.pov",
         "#version 3.7;\nglobal_settings { assumed_gamma 1.0 }\n#include \"moon.inc\"\n"
         "camera { location 0 direction z right x up y angle 1 look_at Coppermoon_Direction(" +
             std::to_string(altitude) + ", " + std::to_string(azimuth) + ") }\nEclipsed_Sky(2)\n");
    const auto outcome = run("povray look.pov +W3 +H3 +FE -A -D", {.folder = here("scene")});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto seen = texture::read_image(here("scene/look.exr"));
    const auto row = static_cast<std::size_t>((90 - altitude) / 180 * 512),
               column = static_cast<std::size_t>(std::fmod(azimuth + 540, 360) / 360 * 1024);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(seen(1, 1, k) / (2 * dome(row, column, k)), 1, 0.03)
          << aside << ": a texel beside it, 0.35 degrees";
  }
  const auto moon_at = [&](const std::string& more) {
    file("scene/moon.pov",
         "#version 3.7;\nglobal_settings { assumed_gamma 1.0 }\n#include \"moon.inc\"\n" + more +
             "camera { location 0 direction z right x up y angle 0.1 look_at "
             "Coppermoon_Direction(Moon_Altitude, Moon_Azimuth) }\nobject { Eclipsed_Moon(1, 1e5) "
             "}\n");
    const auto outcome = run("povray moon.pov +W3 +H3 +FE -A -D", {.folder = here("scene")});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return texture::read_image(here("scene/moon.exr"))(1, 1, 2);
  };
  const double bare = moon_at(""), through_air = moon_at("Eclipsed_Sky(1e3)\n");
  const double altitude = declared(include, "Moon_Altitude")[0],
               aside = 3 / std::cos(altitude * std::numbers::pi / 180);
  const auto row = static_cast<std::size_t>((90 - altitude) / 180 * 512),
             column = static_cast<std::size_t>(std::fmod(moon + aside + 540, 360) / 360 * 1024);
  EXPECT_NEAR((through_air - bare) / (1e3 * dome(row, column, 2)), 1, 0.05)
      << "air before the Moon adds its light; a texel of 0.35 degrees";
  EXPECT_GT(declared(include, "Sky_Luminance")[0], 1e-4);
  EXPECT_LT(declared(include, "Sun_Altitude")[0], -18);
}

TEST_F(SceneFolder, ShowsTheSkyThatAStillHas) {
  const Words dusk =
      "2025-09-07T18:11Z --at Berlin --rays 50 --albedo-map built-in --atmosphere undated "
      "--texture-width 64 --width 60 --height 40 --up zenith --field 9 --stars off";
  // which says that the sky outshines the Moon
  EXPECT_EQ(coppermoon(Words{"still"} + dusk + "-o a.png --frame still.exr").status, 0);
  const auto still = texture::read_image(here("still.exr"));
  for (const char* sky : {"auto", "off"}) {
    expect_done(coppermoon(Words{"scene"} + dusk + words_of("--sky {} -o scene", sky)));
    const auto outcome = run("povray eclipse.ini -D", {.folder = here("scene")});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto scene = texture::read_image(here("scene/frame.exr"));
    for (std::size_t r = 0; r < scene.height; ++r)
      for (std::size_t c = 0; c < scene.width; ++c)
        for (std::size_t k = 0; k < 3; ++k) {
          if (std::string(sky) == "auto") {
            EXPECT_WITHIN_RELATIVE(scene(r, c, k), still(r, c, k), 3e-3,
                                   "half floats of air, Moon and frame; 0.1 % behind the pane")
                << r << " " << c;
          } else if (c < 20) {
            EXPECT_EQ(scene(r, c, k), 0) << "beside the Moon";
          }
        }
  }
}

using SceneFolderThoroughly = SceneFolder;

TEST_F(SceneFolderThoroughly, OfTheTutorialsLakeRenders) {
  expect_done(
      coppermoon("scene 2018-07-27T21:39:00Z --at 52.9,-3.9 --rays 50 --albedo-map built-in "
                 "--texture-width 256 -o scene"));
  std::filesystem::copy(COPPERMOON_TEST_DATA "/../examples/gallery/lake.pov", here("scene"));
  const auto outcome = run("povray lake.pov +W96 +H54 +FE +A0.0 -J -D", {.folder = here("scene")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto frame = texture::read_image(here("scene/lake.exr"));
  // the Moon stands 6 degrees over the middle of a picture 38 degrees wide: at 0.23 of its height
  const float moon = frame(12, 48, 0), sky = frame(12, 10, 0), wall = frame(53, 10, 0);
  const double zenith = declared(text_of(here("scene/moon.inc")), "Sky_Luminance")[0];
  EXPECT_GT(moon, 50 * sky) << "a sky 15 degrees from a low partial Moon, which lights it";
  EXPECT_GT(sky, zenith) << "brighter towards horizon and Moon";
  EXPECT_LT(sky, 30 * zenith);
  EXPECT_GT(wall, 0.F) << "water mirrors the sky";
}

TEST_F(SceneFolder, IsWrittenOverAnOldOneAndMadeAgainFromItsTexture) {
  write_scene();
  const auto before = text_of(here("scene/moon_lin_rec709.exr"));
  write_scene();
  EXPECT_EQ(text_of(here("scene/moon_lin_rec709.exr")), before);
  expect_done(coppermoon("scene scene/moon_lin_rec709.exr -o again"));
  for (const char* file : {"moon_lin_rec709.exr", "eclipse.pov", "eclipse.ini"})
    EXPECT_EQ(text_of(here("again") / file), text_of(here("scene") / file)) << file;
}

TEST_F(SceneFolder, OfAStillIsMadeAgainFromItsPicture) {
  const Words still =
      "still 2008-02-21T03:26:05Z --at 42.86,-73.77 --albedo-map built-in --atmosphere undated "
      "--width 32 --height 24 -o still.png";
  expect_done(coppermoon(still));
  expect_done(coppermoon("still still.png -o again.png"));
  EXPECT_EQ(text_of(here("again.png")), text_of(here("still.png")));
}

}  // namespace coppermoon::end_to_end::scene_folder_test
