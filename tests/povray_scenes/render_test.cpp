// SPDX-License-Identifier: MIT
#include "povray_scenes/render.h"

#include <OpenImageIO/imagebuf.h>
#include <chrono>
#include <glm/geometric.hpp>
#include <stdexcept>

#include "povray_scenes/folder.h"
#include "povray_scenes/meridian.h"
#include "povray_scenes/moon_scene.h"
#include "povray_scenes/pictures.h"
#include "povray_scenes/scene_camera.h"
#include "support/left_behind.h"
#include "support/testing.h"

namespace coppermoon::povray_scenes::render_test {

using algebra::degrees;
using algebra::Error;

std::filesystem::path rendered(const std::filesystem::path& folder, const SceneCamera& camera,
                               const OIIO::ImageBuf& texture) {
  write_scene(folder, {.camera = camera, .texture = "moon.exr"});
  if (!texture.write((folder / "moon.exr").string())) throw std::runtime_error(texture.geterror());
  return render(folder);
}

/// No symmetry: every reflection or turn of this pattern misses it.
const std::vector<Texel> pattern = {{720, 360}, {860, 270}, {590, 310},
                                    {700, 480}, {880, 380}, {670, 230}};

void expect_pattern(const SceneCamera& camera) {
  const TemporaryFolder folder;
  const Luminance frame(rendered(folder.path, camera, texture_with(pattern)));
  for (const auto& texel : pattern) {
    const auto expected = pixel_of(camera, centre(texel));
    ASSERT_TRUE(expected);
    const auto spot = spot_near(frame, *expected);
    ASSERT_GT(spot.luminance, 10) << texel.column << ", " << texel.row;
    EXPECT_WITHIN(spot.centroid.x, expected->x, 0.25, "0.05 pixel rays, spots of about a pixel");
    EXPECT_WITHIN(spot.centroid.y, expected->y, 0.25, "0.05 pixel rays, spots of about a pixel");
  }
}

SceneCamera seen_from(double latitude_deg, Up up = Up::zenith) {
  return camera_at(moon_at_the_equinox(), on_the_meridian(degrees(latitude_deg)), up,
                   {degrees(0.6), 240, 240});
}

TEST(Frame, ShowsPlacesWherePixelOfSaysFromTheNorth) { expect_pattern(seen_from(52)); }

TEST(Frame, ShowsPlacesWherePixelOfSaysFromTheSouth) { expect_pattern(seen_from(-33)); }

TEST(Frame, ShowsPlacesWherePixelOfSaysWithARolledCamera) {
  auto camera = seen_from(52);
  camera.position += glm::dvec3(0, 20, -12);  // librations of 5 and 3 degrees
  camera.up = {0.3, 0.4, 0.8};
  expect_pattern(camera);
}

TEST(Frame, ShowsPlacesWherePixelOfSaysInAWideField) {
  expect_pattern({{2.2, 0.1, 0.2}, {0, 0, 1}, degrees(120), 600, 400});
}

TEST(Frame, ShowsPlacesWherePixelOfSaysInANarrowField) {
  // 0.02 degrees is 0.077 lunar radii: a texel is six pixels, a bright one a tent of twelve.
  SceneCamera camera{{221, 0, 0}, {0, 0, 1}, degrees(0.02), 100, 100};
  const TemporaryFolder folder;
  const Luminance frame(rendered(folder.path, camera, texture_with({{722, 357}})));
  const auto expected = *pixel_of(camera, centre({722, 357}));
  const auto spot = spot_near(frame, expected, 12);
  EXPECT_WITHIN(spot.centroid.x, expected.x, 0.25, "a tent cut at whole pixels");
  EXPECT_WITHIN(spot.centroid.y, expected.y, 0.25, "a tent cut at whole pixels");
}

TEST(Frame, ShowsPlacesWherePixelOfSaysAwayFromTheMiddle) {
  auto camera = seen_from(52);
  camera.horizontal_field = degrees(1.2);
  camera.width = camera.height = 480;
  const glm::dvec3 right = glm::normalize(glm::cross(-camera.position, camera.up));
  camera.direction = -camera.position + 0.8 * right - 0.6 * glm::normalize(camera.up);
  ASSERT_LT(pixel_of(camera, centre(pattern[0]))->x, 200);
  ASSERT_LT(pixel_of(camera, centre(pattern[0]))->y, 200);
  expect_pattern(camera);
}

TEST(Frame, ShowsPlacesWherePixelOfSaysAwayFromTheMiddleOfAWideField) {
  expect_pattern({.position = {2.2, 0.1, 0.2},
                  .up = {0, 0.2, 1},
                  .horizontal_field = degrees(140),
                  .width = 1200,
                  .height = 800,
                  .direction = {-1, 0.3, 0.15}});
}

TEST(Frame, ShowsPlacesWherePixelOfSaysFromATripod) {
  // Due east at a true altitude of 2 degrees, in the lower right of the picture.
  auto camera = camera_fixed(moon_at_the_equinox(), moon_in_the_east(degrees(2)),
                             {degrees(2.5), degrees(89.7)}, {degrees(1.2), 480, 480});
  camera.flattening = 0.9;
  expect_pattern(camera);
}

TEST(Frame, IsBlackWhereTheMoonIsNot) {
  for (const auto& direction : {glm::dvec3(1, 0, 0), glm::dvec3(-1, 0.02, 0)}) {
    const SceneCamera camera{.position = {221, 0, 0},
                             .up = {0, 0, 1},
                             .horizontal_field = degrees(1),
                             .width = 60,
                             .height = 40,
                             .direction = direction};
    const TemporaryFolder folder;
    EXPECT_EQ(Luminance(rendered(folder.path, camera, uniform_texture(1))).total(), 0);
  }
}

TEST(Frame, ShowsAMirroredTextureMirrored) {
  std::vector<Texel> mirrored;
  for (const auto& texel : pattern) mirrored.push_back({columns - 1 - texel.column, texel.row});
  const TemporaryFolder folder;
  const auto camera = seen_from(52);
  const Luminance frame(rendered(folder.path, camera, texture_with(mirrored)));
  for (std::size_t i = 1; i < pattern.size(); ++i) {
    EXPECT_EQ(spot_near(frame, *pixel_of(camera, centre(pattern[i]))).luminance, 0) << i;
    EXPECT_GT(spot_near(frame, *pixel_of(camera, centre(mirrored[i]))).luminance, 10) << i;
  }
}

TEST(Frame, HasTheTexturesLuminanceOverTheDiscThatGeometryGives) {
  // From distance d the disc's radius is tan(asin(1/d)), of tan(field/2) to the edge.
  const auto camera = seen_from(52);
  for (const float luminance : {0.001f, 5000.f}) {
    const TemporaryFolder folder;
    const Luminance frame(rendered(folder.path, camera, uniform_texture(luminance)));
    EXPECT_WITHIN_RELATIVE(frame.at(120, 120), luminance, 5e-4, "half floats");
    EXPECT_EQ(frame.at(1, 1), 0);
    const double tangent = 1 / std::sqrt(glm::dot(camera.position, camera.position) - 1);
    const double radius = 120 * tangent / std::tan(in_radians(degrees(0.3)));
    EXPECT_WITHIN_RELATIVE(frame.total(), luminance * std::numbers::pi * radius * radius, 1e-3,
                           "limb pixels are means of 9 rays");
  }
}

/// Seen low, with the zenith 40 degrees from the top of the picture.
SceneCamera seen_low(double flattening) {
  auto camera = seen_from(52, Up::celestial_north);
  const glm::dvec3 right = glm::normalize(glm::cross(-camera.position, camera.up));
  camera.zenith = std::cos(in_radians(degrees(40))) * glm::normalize(camera.up) +
                  std::sin(in_radians(degrees(40))) * right + glm::normalize(camera.position);
  camera.flattening = flattening;
  return camera;
}

TEST(Frame, ShowsPlacesWherePixelOfSaysOnAFlattenedMoon) { expect_pattern(seen_low(0.85)); }

TEST(Frame, ShowsAFlattenedDiscAsAnEllipseTowardsTheZenith) {
  const TemporaryFolder folder;
  const Luminance frame(rendered(folder.path, seen_low(0.85), uniform_texture(1)));
  // Second moments of the disc, along the zenith and across it: as the squares of its diameters.
  const glm::dvec2 zenith{std::sin(in_radians(degrees(40))), -std::cos(in_radians(degrees(40)))};
  const glm::dvec2 horizon{-zenith.y, zenith.x};
  double along = 0, across = 0, mixed = 0;
  for (int y = 0; y < 240; ++y)
    for (int x = 0; x < 240; ++x) {
      const glm::dvec2 place = glm::dvec2(x + 0.5, y + 0.5) - glm::dvec2(120, 120);
      const double z = glm::dot(place, zenith), h = glm::dot(place, horizon);
      along += frame.at(x, y) * z * z;
      across += frame.at(x, y) * h * h;
      mixed += frame.at(x, y) * z * h;
    }
  EXPECT_WITHIN(std::sqrt(along / across), 0.85, 1e-3, "limb pixels are means of 9 rays");
  EXPECT_WITHIN(mixed / across, 0, 1e-3, "limb pixels are means of 9 rays");
}

/// The frame of a scene written by hand, of the camera's size, with the pattern for its texture.
Luminance frame_by_hand(const SceneCamera& camera, const std::string& scene) {
  const TemporaryFolder folder;
  write_scene(folder.path, {.camera = camera, .texture = "moon.exr"});
  std::filesystem::copy(std::filesystem::path(COPPERMOON_INC_FOLDER) / "coppermoon.inc",
                        folder.path);
  std::ofstream(folder.path / "eclipse.pov")
      << "#version 3.7; global_settings { assumed_gamma 1.0 }\n#include \"coppermoon.inc\"\n"
      << scene;
  texture_with(pattern).write((folder.path / "moon.exr").string());
  return Luminance(render(folder.path));
}

void expect_pattern_in(const Luminance& frame, const SceneCamera& camera) {
  for (const auto& texel : pattern) {
    const auto expected = *pixel_of(camera, centre(texel));
    const auto spot = spot_near(frame, expected);
    EXPECT_WITHIN(spot.centroid.x, expected.x, 0.25, "0.05 pixel rays, spots of about a pixel");
    EXPECT_WITHIN(spot.centroid.y, expected.y, 0.25, "0.05 pixel rays, spots of about a pixel");
  }
}

TEST(CoppermoonInc, GivesTheMoonAndThePlacesOfOurOwnScenes) {
  const auto camera =
      SceneCamera{{200 * std::cos(0.1), 0, 200 * std::sin(0.1)}, {0, 0, 1}, degrees(0.7), 240, 200};
  const auto frame = frame_by_hand(
      camera,
      "camera { location 200*Coppermoon_Place(degrees(0.1), 0) right x*240/200 up y sky y\n"
      "angle 0.7 look_at 0 }\nobject { Coppermoon_Moon(\"moon.exr\", 0.5) }\n");
  expect_pattern_in(frame, camera);
}

/// A camera in the Moon's own frame that sees what an observer sees: the place under him in the
/// middle, and north turned from the top of the picture anticlockwise, towards the left.
SceneCamera seen_by_observer(double latitude_deg, double longitude_deg, double axis_angle_deg) {
  const auto toward = almanac::selenographic_direction(place(latitude_deg, longitude_deg));
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 0, 1), toward));
  const glm::dvec3 north = glm::cross(toward, right);
  const double turn = in_radians(degrees(axis_angle_deg));
  return {221. * toward, std::cos(turn) * north + std::sin(turn) * right, degrees(0.7), 240, 200};
}

TEST(CoppermoonInc, TurnsTheMoonAsAnObserverSeesItWithEastLeftOfNorth) {
  // North of the Moon a quarter to the east, as eastern libration and northern are in the middle.
  const auto camera = seen_by_observer(5, -7, 90);
  const auto north = *pixel_of(camera, place(60, -7));
  EXPECT_LT(north.x, 80) << "east is left when north is up";
  EXPECT_WITHIN(north.y, 100, 1, "a quarter turn puts the pole level with the middle");
  expect_pattern_in(frame_by_hand(camera,
                                  "Coppermoon_Telescope(0, 221*z, y, 0.7)\n"
                                  "object { Coppermoon_Moon(\"moon.exr\", 1)\n"
                                  "Coppermoon_Turn(5, -7, 90, -z, y) translate 221*z }\n"),
                    camera);
}

TEST(CoppermoonInc, PutsAMoonOfAnyRadiusAnywhere) {
  const auto camera = seen_by_observer(-6, 4, 25);
  expect_pattern_in(
      frame_by_hand(camera,
                    "#declare Eye = <3000, -200, 70>; #declare Toward = <-1, 2, 0.5>;\n"
                    "#declare Centre = Eye - 1737.4*221*vnormalize(Toward);\n"
                    "Coppermoon_Telescope(Eye, Centre, <0.3, 0.1, 5>, 0.7)\n"
                    "object { Coppermoon_Moon(\"moon.exr\", 1)\n"
                    "Coppermoon_Turn(-6, 4, 25, Toward, <0.3, 0.1, 5>)\n"
                    "scale 1737.4 translate Centre }\n"),
      camera);
}

TEST(CoppermoonInc, PutsTheMoonIntoTheSkyOfALandscapeWithAzimuthsGrowingToTheRight) {
  // A third of the way from the horizon to the zenith, 30 degrees east of south. The zenith's
  // position angle is -65 degrees, so that the axis at -40 is 25 to the left of it.
  const auto camera = seen_by_observer(0.6, -0.4, 25);
  const auto frame = frame_by_hand(
      camera,
      "Coppermoon_Telescope(0, <sqrt(3)/4, 1/2, -3/4>, y, 0.7)\n"
      "object { Coppermoon_Moon(\"moon.exr\", 1)\n"
      "Coppermoon_In_Sky(0.6, -0.4, -40, -65, 30, 150, 2*degrees(asin(1/221)), 1000) }\n"
      "sphere { 1000*Coppermoon_Direction(30, 150.36), 0.1\n"
      "pigment { rgb 1000 } finish { ambient 0 diffuse 0 emission 1 } }\n");
  expect_pattern_in(frame, camera);
  const double right = std::cos(in_radians(degrees(30))) * std::sin(in_radians(degrees(0.36)));
  const double x = 120 + 120 * right / std::tan(in_radians(degrees(0.35)));
  const auto star = spot_near(frame, {x, 100});
  ASSERT_GT(star.luminance, 1000);
  EXPECT_WITHIN(star.centroid.x, x, 0.25, "a disc of 4 pixels, means of 9 rays");
}

/// A folder with spaces and letters outside ASCII, the scene in it, and what is put there for
/// POV-Ray.
struct SmallScene {
  TemporaryFolder parent;
  std::filesystem::path folder = parent.path / "Mönd und Schatten";

  SmallScene() {
    write_scene(folder,
                {.camera = {{221, 0, 0}, {0, 0, 1}, degrees(0.6), 96, 72}, .texture = "moon.exr"});
    texture_with(pattern).write((folder / "moon.exr").string());
  }
  std::string stand_in(const std::string& script) const { return script_in(folder, script); }
};

std::string refusal(const SmallScene& scene, const RenderSettings& settings = {}) {
  return refusal_of([&] { render(scene.folder, settings); });
}

TEST(Render, GivesTheFrameAndLeavesNothingElse) {
  const SmallScene scene;
  EXPECT_EQ(render(scene.folder), scene.folder / "frame.exr");
  EXPECT_EQ(files_in(scene.folder), 4);
}

TEST(Render, TellsItsProgressUpToOne) {
  const SmallScene scene;
  std::vector<double> told;
  render(scene.folder, {.threads = 1}, [&](double fraction) { told.push_back(fraction); });
  ASSERT_GE(told.size(), 2u);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_EQ(std::count(told.begin(), told.end(), 1), 1);
  EXPECT_GT(told.front(), 0);
  EXPECT_EQ(told.back(), 1);
}

TEST(Render, ReadsTheCountOfPixelsBetweenOtherWords) {
  const SmallScene scene;
  std::vector<double> told;
  const auto povray = scene.stand_in(
      "printf 'Hello\\nRendered 1 of 4 pixels (25%%)\\rRendered 3 of 4 pixels (75%%)\\r' >&2\n"
      "echo frame > \"${2#+O}\"");
  render(scene.folder, {.povray = povray}, [&](double fraction) { told.push_back(fraction); });
  EXPECT_EQ(told, (std::vector<double>{0.25, 0.75, 1}));
}

TEST(Render, HandsOnTheNumberOfThreads) {
  const SmallScene scene;
  const auto povray = scene.stand_in("echo \"Error: $*\" >&2; exit 1");
  EXPECT_SAYS(refusal(scene, {.threads = 3, .povray = povray}), " +WT3");
  EXPECT_SAYS_NOT(refusal(scene, {.threads = 0, .povray = povray}), " +WT");
  EXPECT_SAYS(refusal(scene, {.threads = -1}), "threads = -1, allowed 0 to 512");
}

TEST(Render, MakesTheSameBitsOnAnyNumberOfThreads) {
  const SmallScene scene;
  const Luminance one(render(scene.folder, {.threads = 1})),
      two(render(scene.folder, {.threads = 2}));
  for (int y = 0; y < 72; ++y)
    for (int x = 0; x < 96; ++x) EXPECT_EQ(one.at(x, y), two.at(x, y));
}

TEST(Render, OfAWindowIsTheSameThereAndBlackElsewhere) {
  const SmallScene scene;
  const Luminance whole(render(scene.folder));
  for (const RenderWindow window :
       {RenderWindow{20, 10, 70, 60}, {0, 0, 50, 40}, {1, 1, 96, 72}, {0, 0, 2, 2}}) {
    const Luminance part(render(scene.folder, {.window = window}));
    for (std::size_t y = 0; y < 72; ++y)
      for (std::size_t x = 0; x < 96; ++x) {
        const bool within =
            x >= window.left && x < window.right && y >= window.top && y < window.bottom;
        const auto column = static_cast<int>(x), row = static_cast<int>(y);
        EXPECT_EQ(part.at(column, row), within ? whole.at(column, row) : 0) << x << ", " << y;
      }
  }
  EXPECT_EQ(refusal(scene, {.window = RenderWindow{20, 10, 21, 60}}),
            "width of the window [pixels] = 1, allowed 2 to 65535");
}

TEST(RenderFor, HandsOverTheSameFrameAndLeavesNothing) {
  const SmallScene scene;
  const Luminance whole(render(scene.folder));
  std::filesystem::remove(scene.folder / "frame.exr");
  std::vector<double> told;
  int read = 0;
  render_for(
      [&](const std::filesystem::path& exr) {
        const Luminance same(exr);
        for (int y = 0; y < 72; ++y)
          for (int x = 0; x < 96; ++x) EXPECT_EQ(same.at(x, y), whole.at(x, y));
        ++read;
      },
      scene.folder, {}, [&](double fraction) { told.push_back(fraction); });
  EXPECT_EQ(read, 1);
  EXPECT_EQ(told.back(), 1);
  EXPECT_EQ(files_in(scene.folder), 3);
}

TEST(RenderFor, EndsPovRayOnceItsFileIsClosed) {
  const SmallScene scene;
  const auto povray = scene.stand_in("echo frame > \"${2#+O}\"; exec sleep 1000");
  std::uintmax_t bytes = 0;
  render_for([&](const auto& exr) { bytes = std::filesystem::file_size(exr); }, scene.folder,
             {.timeout_s = 60, .povray = povray});
  EXPECT_EQ(bytes, 6u);
}

TEST(RenderFor, PassesOnWhatGoesWrong) {
  const SmallScene scene;
  const auto none = [](const std::filesystem::path&) { FAIL() << "there is no frame"; };
  const auto fails = scene.stand_in("echo 'Out of ink' >&2; exit 1");
  EXPECT_THROW(render_for(none, scene.folder, {.povray = fails}), Error);
  EXPECT_THROW(render_for(none, scene.folder, {.povray = "true"}), Error);
  EXPECT_THROW(render_for([](const auto&) { throw std::runtime_error("damaged"); }, scene.folder),
               std::runtime_error);
  EXPECT_EQ(files_in(scene.folder), 4);
}

TEST(Render, SaysWhichPackageIsMissing) {
  const SmallScene scene;
  EXPECT_EQ(refusal(scene, {.povray = "povray-that-nobody-has"}),
            "povray-that-nobody-has: not found; install the package povray");
}

TEST(Render, PassesOnPovRaysOwnWords) {
  const SmallScene scene;
  std::filesystem::remove(scene.folder / "moon.exr");
  const auto words = refusal(scene);
  EXPECT_TRUE(words.starts_with("povray: File 'eclipse.pov' line 1")) << words;
  EXPECT_SAYS(words, "Cannot find file 'moon.exr'");
  EXPECT_SAYS_NOT(words, '\n');
  EXPECT_EQ(files_in(scene.folder), 2);
}

TEST(Render, KeepsTheEarlierFrameWhenItFails) {
  const SmallScene scene;
  std::ofstream(scene.folder / "frame.exr") << "earlier";
  const auto povray = scene.stand_in("echo half > \"${2#+O}\"; echo 'Out of ink' >&2; exit 1");
  EXPECT_EQ(refusal(scene, {.povray = povray}), povray + ": Out of ink");
  EXPECT_EQ(std::filesystem::file_size(scene.folder / "frame.exr"), 7u);
  EXPECT_EQ(files_in(scene.folder), 5);
}

TEST(Render, DoesNotTakeSilenceForAFrame) {
  const SmallScene scene;
  EXPECT_SAYS(refusal(scene, {.povray = "true"}), "true: wrote no");
}

TEST(Render, NamesTheSignalThatEndedPovRay) {
  const SmallScene scene;
  const auto povray = scene.stand_in("kill -9 $$");
  EXPECT_EQ(refusal(scene, {.povray = povray}), povray + ": ended by signal 9");
}

TEST(Render, StopsPovRayWhenTheTimeIsUp) {
  const SmallScene scene;
  const auto povray = scene.stand_in("exec sleep 60");
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(refusal(scene, {.timeout_s = 0.2, .povray = povray}),
            povray + ": not done after 0.2 s, the time allowed");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST(Render, StopsPovRayWhenTheListenerThrows) {
  const SmallScene scene;
  EXPECT_THROW(render(scene.folder, {}, [](double) { throw Error("enough"); }), Error);
  EXPECT_EQ(files_in(scene.folder), 3);
}

TEST(Render, LeavesNoPovRayBehindWhenItIsKilled) {
  const SmallScene scene;
  const auto povray = scene.stand_in("echo $$ > pid.tmp; mv pid.tmp pid; exec sleep 20");
  EXPECT_EQ(signal_after_our_death(scene.folder / "pid",
                                   [&] { render(scene.folder, {.povray = povray}); }),
            SIGKILL);
}

TEST(Render, NeedsNoStandardStreams) {
  const SmallScene scene;
  const pid_t closed = ::fork();
  if (closed == 0) {
    for (const int stream : {0, 1, 2}) ::close(stream);
    try {
      render(scene.folder);
      ::_exit(0);
    } catch (...) {
      ::_exit(1);
    }
  }
  int status = 0;
  ::waitpid(closed, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_TRUE(std::filesystem::exists(scene.folder / "frame.exr"));
}

TEST(Render, StarsGiveTheirLightAndTheMoonHidesThem) {
  const TemporaryFolder folder;
  auto camera = seen_from(20);
  camera.horizontal_field = degrees(2);
  const auto sight = sight_of(camera);
  const auto light_at = [&](double x, double y) {
    return SkyLight{glm::normalize(sight.corner + x * sight.across + y * sight.down),
                    {2e-6, 2e-6, 2e-6}};
  };
  const glm::dvec2 beside(0.12 * static_cast<double>(camera.width) + 0.3,
                          0.3 * static_cast<double>(camera.height) + 0.4);
  write_scene(folder.path, {.camera = camera,
                            .texture = "moon.exr",
                            .lights = {light_at(beside.x, beside.y),
                                       light_at(0.5 * static_cast<double>(camera.width),
                                                0.5 * static_cast<double>(camera.height))}});
  ASSERT_TRUE(uniform_texture(0).write((folder.path / "moon.exr").string()));
  const OIIO::ImageBuf frame(render(folder.path).string());
  double lux = 0;
  glm::dvec2 middle(0, 0);
  for (int row = 0; row < frame.spec().height; ++row)
    for (int column = 0; column < frame.spec().width; ++column) {
      float light[4] = {};
      frame.getpixel(column, row, light);
      lux += light[0] * glm::length(sight.across) * glm::length(sight.down);
      middle += double{light[0]} * glm::dvec2(column + 0.5, row + 0.5);
    }
  middle *= glm::length(sight.across) * glm::length(sight.down) / lux;
  EXPECT_WITHIN_RELATIVE(lux, 2e-6, 0.08, "78 rays meet a sphere of one pixel: by a ninth of them");
  EXPECT_WITHIN(middle.x, beside.x, 0.1, "rays are a quarter of a pixel apart");
  EXPECT_WITHIN(middle.y, beside.y, 0.1, "rays are a quarter of a pixel apart");
}

TEST(Render, RefusesAFolderWithoutAScene) {
  const TemporaryFolder folder;
  EXPECT_THROW(render(folder.path), Error);
  EXPECT_THROW(render(folder.path / "none"), Error);
}

}  // namespace coppermoon::povray_scenes::render_test
