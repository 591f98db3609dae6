// SPDX-License-Identifier: MIT
// An eclipse through a telescope: what the camera's keys do to files, and where they may stand.
#include <nlohmann/json.hpp>

#include "colour/camera.h"
#include "colour/glow.h"
#include "support/luther_camera.h"
#include "support/program.h"
#include "texture/read_image.h"
#include "texture/write_image.h"
#include "uses/picture/pixels.h"

namespace coppermoon::end_to_end::camera_test {

constexpr const char *deep = "2008-02-21T03:08:26Z", *new_york = "42.86,-73.77";

class CameraTest : public ProgramTest {
 protected:
  static Words still(const Words& more, const std::string& output = "a.png",
                     const std::string& air = "undated") {
    return words_of(
               "still {} --at {} --albedo-map built-in --rays 60 --iso 800 --time 2 "
               "--texture-width 128 "
               "--width 90 --height 60 -o {} --atmosphere {}",
               deep, new_york, output, air) +
           more;
  }

  void make(const Words& words) const { expect_done(coppermoon(words)); }
  texture::Image image(const char* name) const { return texture::read_image(here(name)); }
  double number(const char* file, const char* attribute) const {
    return std::stod(texture::read_attribute(here(file), attribute).value_or("nan"));
  }
};

double mean_of_corner(const texture::Image& image, std::size_t channel) {
  double sum = 0;
  for (std::size_t r = 0; r < 10; ++r)
    for (std::size_t c = 0; c < 10; ++c) sum += image(r, c, channel) / 100;
  return sum;
}

TEST_F(CameraTest, MakesARawFileAPhotographAndAPictureOfAFrame) {
  make(
      still("--camera paper --seeing 2 --frame frame.exr --raw raw.tif --photograph photograph.exr",
            "a.png", "standard"));
  const auto raw = image("raw.tif"), photograph = image("photograph.exr"),
             frame = image("frame.exr");
  EXPECT_EQ(raw.width, 90U);
  const auto [least, most] = std::ranges::minmax(raw.values);
  EXPECT_GT(least * 65535, 60)
      << "a black level of 124, and its noise of 1.7 over 17 sensor pixels";
  EXPECT_LE(most * 65535, 4095.01) << "12 bits";
  EXPECT_EQ(photograph.channels, (std::vector<std::string>{"R", "G", "B", "valid"}));
  // over the middle of the disc the photograph has the frame's light and its glow, but for noise and
  // blur: the square scatters 5 % of its light, of which the disc about it gives half back
  const double pixel_rad = 22.7 / 90 / 1540;
  const auto glowing = colour::with_glow(uses::pixels_of(frame), 0.05, pixel_rad);
  double light[2] = {};
  for (std::size_t r = 20; r < 40; ++r)
    for (std::size_t c = 35; c < 55; ++c)
      light[0] += glowing(r, c)[0], light[1] += photograph(r, c, 0);
  EXPECT_WITHIN_RELATIVE(light[1], light[0], 0.02, "what 2 arcsec carry over this square's sides");
  EXPECT_NEAR(number("frame.exr", "coppermoon:pixel_arcsec"), 206265 * pixel_rad, 0.01);
}

TEST_F(CameraTest, WritesARawPhotographThatIsComparedAsACamerasOwn) {
  make(words_of(
      "still 2008-02-21T03:26:05Z --at {} --albedo-map built-in --rays 60 --iso 800 --time 1 "
      "--width 300 --height 200 --camera 400mm --raw a.dng --seeing 2 --focal-length 1200 "
      "--frame frame.exr --texture-width 256 -o a.png",
      new_york));
  const auto outcome = coppermoon("compare a.dng frame.exr --json");
  expect_done(outcome);
  const auto found = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(found["exposure"]["time_s"], 1);
  EXPECT_EQ(found["exposure"]["iso"], 800);
  EXPECT_EQ(found["registration"]["mirrored"], false);
  EXPECT_WITHIN(found["registration"]["rotation_deg"].get<double>(), 0, 0.3,
                "half a pixel over the Moon's radius of 90");
  // the header's exposure means a usual lens; this one transmits more
  const colour::Exposure exposure{1, 400 / 71.4, 800};
  const double of_this_lens =
      -std::log2(colour::saturation_cd_m2(colour::camera_named("400mm"), exposure) *
                 colour::exposure_scale(exposure));
  const auto& disc = found["disc"];
  EXPECT_WITHIN(disc["difference_stops"].get<double>(), of_this_lens, 0.02,
                "what 2 arcsec and the mosaic carry over edges of the maria");
  for (const std::string part : {"u", "v"})
    EXPECT_WITHIN(disc["photo_" + part].get<double>(), disc["render_" + part].get<double>(), 0.002,
                  "half of what is just seen; noise below black is cut off");
  const auto by_another = coppermoon("compare a.dng frame.exr --json --response nikon-d850");
  expect_done(by_another);
  EXPECT_GT(std::abs(nlohmann::json::parse(by_another.out)["disc"]["photo_u"].get<double>() -
                     disc["photo_u"].get<double>()),
            0.005)
      << "another camera's matrix makes other colours of the raw file";
}

TEST_F(CameraTest, DevelopsARawPhotographAsItsFrame) {
  const Words taken =
      "--camera 400mm --focal-length 1540 --response colorimetric --noise off --diffraction off";
  auto words = taken;
  words += "--frame frame.exr --raw a.dng --time 0.3";
  make(still(words, "frame.png"));
  make("develop a.dng --time 0.3 --f-number 5.6022 -o raw.png");
  const auto raw = texture::read_light(here("raw.png")),
             frame = texture::read_light(here("frame.png"));
  double light[2] = {};
  for (std::size_t r = 25; r < 35; ++r)
    for (std::size_t c = 40; c < 50; ++c) light[0] += raw(r, c, 0), light[1] += frame(r, c, 0);
  EXPECT_GT(light[1], 3);
  EXPECT_WITHIN_RELATIVE(light[0], light[1], 0.03, "a mosaic of a Moon of 36 pixels, 8 bits");
}

TEST_F(CameraTest, SaysThatAFrameIsInTheColoursOfAnotherCamera) {
  make(still("--response sony-ilce-7m3 --frame frame.exr"));
  const auto develop = [&](const Words& more) {
    Words words = "develop frame.exr --time 2 -o b.png";
    words += more;
    const auto outcome = coppermoon(words);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.err;
  };
  EXPECT_EQ(develop("--response nikon-d850"),
            "coppermoon: frame.exr: its colours are those of sony-ilce-7m3, not of nikon-d850: "
            "make it anew with --response nikon-d850\n");
  EXPECT_EQ(develop("--response sony-ilce-7m3"), "");
  EXPECT_EQ(develop({}), "");
}

TEST_F(CameraTest, SetsTheViewUnlessItIsSetByHand) {
  make(still("--camera 400mm --frame camera.exr"));
  make(still("--focal-length 400 --sensor-width 35.8 --frame hand.exr"));
  EXPECT_TRUE(image("camera.exr").values == image("hand.exr").values);
  make(still("--camera 400mm --focal-length 800 --frame longer.exr"));
  EXPECT_WITHIN_RELATIVE(number("longer.exr", "coppermoon:pixel_arcsec"),
                         number("camera.exr", "coppermoon:pixel_arcsec") / 2, 1e-5,
                         "read in six digits");
  EXPECT_WITHIN_RELATIVE(number("longer.exr", "aperture"), number("camera.exr", "aperture"), 1e-5,
                         "as fast as before, unless its aperture is given");
}

TEST_F(CameraTest, IsATableOfARecipe) {
  const std::string above =
      "instant = 2008-02-21T03:08:26Z\nat = \"42.86,-73.77\"\nwidth = 90\n"
      "height = 60\nalbedo-map = \"built-in\"\nrays = 60\n"
      "texture-width = 128\natmosphere = \"undated\"\n";
  file("camera.toml", above +
                          "[camera]\nmodel = \"paper\"\nseeing = 3\nread-noise = 20\n"
                          "iso = 800\ntime = 2\n");
  make("still --recipe camera.toml -o table.png");
  make(still("--camera paper --seeing 3 --read-noise 20", "flags.png"));
  EXPECT_TRUE(image("table.png").values == image("flags.png").values);
  make("still table.png -o again.png");
  EXPECT_EQ(text_of(here("again.png")), text_of(here("table.png")));

  const auto refusal = [&](const std::string& table, int status = could_not) {
    file("wrong.toml", above + table);
    return expect_refused("still --recipe wrong.toml -o no.png", "", status);
  };
  EXPECT_EQ(refusal("[camera]\nmodel = \"paper\"\nseing = 3\n", wrong_usage),
            "coppermoon: wrong.toml:11: seing: [camera] has no such key; the nearest is seeing\n");
  EXPECT_EQ(
      refusal("[camera]\nmodel = \"brownie\"\n"),
      "coppermoon: camera = brownie, allowed paper, 400mm, schmidt-cassegrain, refractor; of a "
      "maker's camera, response says the colours, focal-length and sensor-width the field\n");
  EXPECT_EQ(refusal("seeing = 3\n"),
            "coppermoon: aperture, sensor, noise and files of a camera need a camera: paper, "
            "400mm, schmidt-cassegrain, refractor\n");
  EXPECT_EQ(refusal("[camera]\nmodel = \"paper\"\nread-noise = -1\n"),
            "coppermoon: wrong.toml:11: read noise [electrons] = -1, allowed 0 to 10000\n");
  EXPECT_EQ(refusal("sky = \"bright\"\n"),
            "coppermoon: wrong.toml:9: sky [mag/arcsec2] = bright, allowed auto, off or 0 to 30\n");
}

TEST_F(CameraTest, DevelopsAFrameAsStillDoes) {
  make(still("--camera paper --seeing 2 --frame frame.exr --raw one.tif"));
  make("develop frame.exr --camera paper --seeing 2 --time 2 --iso 800 --raw two.tif -o b.png");
  const auto one = image("one.tif"), two = image("two.tif");
  double apart = 0;
  for (std::size_t i = 0; i < one.values.size(); ++i)
    apart = std::max(apart, std::abs(65535. * (one.values[i] - two.values[i])));
  // the frame is kept in half floats, 1/2048 apart: of 4095 numbers 2, and the same noise but one
  // electron's, 1.4 numbers
  EXPECT_LE(apart, 6);
}

TEST_F(CameraTest, LeftOutCostsNothing) {
  make(still("--frame frame.exr --focal-length 1540 --sensor-width 22.7 --sky off"));
  make(
      still("--camera paper --noise off --diffraction off --glow 0 --sky off --response "
            "colorimetric --sensor-bits 16 --photograph photograph.exr"));
  const auto frame = image("frame.exr"), photograph = image("photograph.exr");
  for (std::size_t r = 0; r < frame.height; ++r)
    for (std::size_t c = 0; c < frame.width; ++c)
      for (std::size_t k = 0; k < 3 && photograph(r, c, 3) == 1; ++k)
        EXPECT_WITHIN(photograph(r, c, k), frame(r, c, k), 6e-4 + 5e-4 * frame(r, c, k),
                      "a step of 16 bits, 15 cd/m2 over them, and of half floats");
}

using CameraTestThoroughly = CameraTest;

/// Moonset in the morning of 2008-02-21 over Kurdistan: the Sun is 5 degrees below.
TEST_F(CameraTestThoroughly, SeesTheTwilight) {
  const auto taken = [&](const Words& more, const char* name) {
    auto words = words_of(
        "still {} --at 36,48 --camera 400mm --noise off --time 1 --iso 100 --albedo-map built-in "
        "--rays 60 --texture-width 64 --width 60 --height 40 -o a.png --photograph {}",
        deep, name);
    words += more;
    const auto outcome = coppermoon(words);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return mean_of_corner(image(name), 1);
  };
  const double off = taken("--sky off --atmosphere undated", "off.exr");
  const double twilight = taken("--frame frame.exr", "twilight.exr") - off;
  const double sky = number("frame.exr", "coppermoon:sky_cd_m2");
  EXPECT_GT(sky, 0.01);
  EXPECT_LT(sky, 100);
  const auto frame = image("frame.exr");
  const double green = mean_of_corner(frame, 1);
  EXPECT_WITHIN_RELATIVE(green, sky, 0.2, "its colour, and half a degree beside the Moon");
  EXPECT_WITHIN_RELATIVE(twilight, green, 0.01, "a step of 14 bits: 0.2 % of it");
  const double by_hand = taken("--sky 12 --atmosphere undated", "hand.exr") - off;
  EXPECT_WITHIN_RELATIVE(by_hand, 1.08e5 * std::pow(10, -0.4 * 12), 0.01, "as before");

  const auto outcome = coppermoon("develop frame.exr --camera 400mm --view raw -o auto.png");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_SAYS(outcome.err, "times as bright as the Moon");
  const double level = mean_of_corner(image("auto.png"), 1);
  EXPECT_GT(level, 0.1) << "a sky that outshines the Moon is as bright as eyes have it: of white";
  EXPECT_LT(level, 0.4) << "its luminance 0.4 at most (Krawczyk et al. 2005)";
}

/// Frames once named a sky in their header that they did not hold.
TEST_F(CameraTest, DevelopsAnOlderFrameWithTheSkyOfItsHeader) {
  texture::Image frame(20, 20, {"R", "G", "B"});
  const texture::Attributes older{{"coppermoon:version", std::string("0.1.0")},
                                  {"coppermoon:sky_cd_m2", 2.F}};
  auto newer = older;
  newer["coppermoon:sky"] = std::string("in the frame");
  texture::write_exr(here("older.exr"), frame, older);
  texture::write_exr(here("newer.exr"), frame, newer);
  const auto developed = [&](const std::string& name, const Words& more) {
    const auto outcome = coppermoon(
        words_of("develop {} --view raw --time 8 --iso 100 --bits 16 -o a.png", name) + more);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return mean_of_corner(image("a.png"), 1);
  };
  // ISO 12232: 0.65 t S / (78 N²) of 2 cd/m²
  const double scaled = 2 * 0.65 * 8 * 100 / (78 * 12.1 * 12.1);
  EXPECT_WITHIN(developed("older.exr", {}), scaled, 2e-5, "a step of 16 bits");
  EXPECT_EQ(developed("older.exr", "--sky off"), 0);
  EXPECT_WITHIN_RELATIVE(developed("older.exr", "--sky 11"),
                         scaled / 2 * 1.08e5 * std::pow(10, -0.4 * 11), 1e-3, "steps of 16 bits");
  EXPECT_EQ(developed("newer.exr", {}), 0) << "no second sky";
  const auto twice = coppermoon("develop newer.exr --sky 14 -o a.png");
  EXPECT_EQ(twice.status, 1);
  EXPECT_EQ(twice.err, "coppermoon: newer.exr: holds a sky of 2 cd/m², allowed sky = auto\n");
}

TEST_F(CameraTest, MergesABracketedSetOfPhotographs) {
  make(still("--frame frame.exr"));
  Words words{"merge"};
  for (const char* time : {"0.1", "0.8", "6"}) {
    const auto name = "bracket_" + std::string(time) + ".exr";
    make(
        words_of("develop frame.exr --camera refractor --time {} --diffraction off --glow 0 "
                 "--photograph {} -o a.png",
                 time, name));
    words.push_back(name);
  }
  words += "-o merged.exr";
  make(words);
  const auto merged = image("merged.exr"), frame = image("frame.exr");
  double light = 0, there = 0;
  for (std::size_t r = 0; r < frame.height; ++r)
    for (std::size_t c = 0; c < frame.width; ++c) {
      EXPECT_EQ(merged(r, c, 3), 1);
      light += merged(r, c, 1), there += frame(r, c, 1);
    }
  EXPECT_WITHIN_RELATIVE(light, there, 2e-3, "noise of 5400 pixels of some 1e4 electrons each");
  const auto outcome = coppermoon("merge frame.exr -o no.exr");
  EXPECT_EQ(outcome.err, "coppermoon: frame.exr: channels R, G, B, allowed R, G, B, valid\n");
}

/// Means of three channels over the middle of the frame, which the Moon fills.
std::array<double, 3> middle_of(const texture::Image& image) {
  std::array<double, 3> sums{};
  for (std::size_t r = 20; r < 40; ++r)
    for (std::size_t c = 35; c < 55; ++c)
      for (std::size_t k = 0; k < 3; ++k) sums[k] += image(r, c, k) / 400;
  return sums;
}

TEST_F(CameraTest, OfTheObserversOwnCurvesSeesAsTheObserver) {
  file("luther.csv", luther_camera());
  make(still("--stars 9 --frame cie.exr"));
  make(still("--stars 9 --response luther.csv --frame luther.exr", "b.png"));
  const auto cie = image("cie.exr"), luther = image("luther.exr");
  for (std::size_t i = 0; i < cie.values.size(); ++i)
    EXPECT_WITHIN(luther.values[i], cie.values[i], 1e-6 + 1e-3 * cie.values[i], "half floats");
  make("still b.png -o again.png --frame again.exr");
  EXPECT_TRUE(image("again.exr").values == luther.values) << "its recipe names the response";
}

TEST_F(CameraTest, SeesThroughItsOwnFilters) {
  make(still("--frame cie.exr"));
  const auto cie = middle_of(image("cie.exr"));
  for (const char* name : {"canon-eos-600d", "sony-ilce-7m3"}) {
    make(still(words_of("--response {} --frame camera.exr", name), "b.png"));
    const auto camera = middle_of(image("camera.exr"));
    EXPECT_GT(camera[2] / camera[0], 1.1 * cie[2] / cie[0])
        << name << ": copper that is less saturated";
    EXPECT_WITHIN_RELATIVE(camera[1] / camera[0], cie[1] / cie[0], 0.25, "it stays copper") << name;
    EXPECT_SAYS(text_of(here("b.png")), "response = '" + std::string(name));
  }
}

TEST_F(CameraTest, CountsWhatItsOwnFiltersPassAndSaysByWhichMatrix) {
  make(
      still("--camera 400mm --focal-length 1540 --response canon-eos-600d --noise off "
            "--diffraction off --glow 0 --sky off --time 0.3 --frame frame.exr --raw a.dng"));
  const auto frame = middle_of(image("frame.exr")),
             raw = middle_of(texture::read_light(here("a.dng")));
  for (const std::size_t k : {1, 2})
    EXPECT_WITHIN(raw[k] / raw[0], frame[k] / frame[0], 0.01, "a mosaic; 14 bits");
  make("develop a.dng -o adobe.png --time 0.3");
  make("develop a.dng -o own.png --time 0.3 --response canon-eos-600d");
  const auto one = middle_of(image("adobe.png")), other = middle_of(image("own.png"));
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_WITHIN(one[k], other[k], 0.005, "the matrix of the file is that of the response");
}

TEST_F(CameraTest, OfAFilmIsNoOtherFileOfFilters) {
  const Words film =
      "animate 2018-07-27 --from greatest-1s --to greatest+1s --frames 2 --texture-width 64 "
      "--width 48 --height 32 --atmosphere undated --response own.csv -o film";
  const auto own = luther_camera();
  file("own.csv", own);
  make(film);
  make(film);
  file("own.csv", own.substr(0, own.rfind("780,")));
  const auto outcome = coppermoon(film);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err,
            "coppermoon: film: holds a film made with other contents of response (frame.0001.png "
            "and 1 more), allowed another folder, or --replace\n");
}

TEST_F(CameraTestThoroughly, GivesEachFrameOfAFilmNoiseOfItsOwn) {
  const auto film = [&](const char* folder, const Words& more = {}) {
    make(words_of(
             "animate 2018-07-27 --from greatest-1s --to greatest+1s --frames 2 --texture-width "
             "64 --width 48 --height 32 --albedo-map built-in --rays 60 --camera 400mm --time 1 "
             "-o {} --atmosphere undated",
             folder) +
         more);
  };
  film("one"), film("two");
  film("canon", "--response canon-eos-600d");
  const auto first = image("one/frame.0001.png"), second = image("one/frame.0002.png");
  EXPECT_FALSE(first.values == second.values);
  EXPECT_TRUE(first.values == image("two/frame.0001.png").values);
  EXPECT_FALSE(first.values == image("canon/frame.0001.png").values);
}

TEST_F(CameraTest, RefusesFilesThatItCannotWrite) {
  const auto refusal = [&](const Words& more) { return expect_refused(still(more), ""); };
  EXPECT_EQ(refusal("--camera paper --raw raw.png"),
            "coppermoon: raw.png: a raw file ends in .tif, or in .dng\n");
  EXPECT_EQ(refusal("--camera paper --response luminance --raw raw.dng"),
            "coppermoon: raw.dng: response = luminance, allowed for a raw file that ends in .dng a "
            "sensor that sees colours\n");
  file("wrong.csv", "wavelength_nm,r,g,b\n500,1,1,1\n400,1,1,1\n");
  EXPECT_EQ(refusal("--response wrong.csv"),
            "coppermoon: wrong.csv: 2 rows of numbers, allowed 10 to 100000\n");
  EXPECT_EQ(refusal("--response lost.csv").substr(0, 50),
            "coppermoon: lost.csv: no such file, allowed a .csv");
  EXPECT_EQ(refusal("--response canon-6d"),
            "coppermoon: aperture, sensor, noise and files of a camera need a camera: paper, "
            "400mm, schmidt-cassegrain, refractor\n")
      << "a matrix of a sensor, without one";
  EXPECT_EQ(refusal("--camera paper --photograph a.tif"),
            "coppermoon: a.tif: a photograph ends in .exr\n");
  EXPECT_EQ(refusal("--camera paper --raw no/raw.tif"), "coppermoon: no: no such directory\n");
}

TEST_F(CameraTest, LeavesNoPartOfARawFileOnAFullDisk) {
  make(still("--frame frame.exr"));
  for (const std::string raw : {"raw.tif", "raw.dng"}) {
    const auto outcome =
        coppermoon(words_of("develop frame.exr --camera paper --time 2 --raw {} -o b.png", raw),
                   {.file_limit = 2000});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.err.starts_with("coppermoon: " + raw + ": cannot be written: "))
        << outcome.err;
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1);
    EXPECT_FALSE(std::filesystem::exists(here(raw)));
  }
}

}  // namespace coppermoon::end_to_end::camera_test
