// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "support/program.h"
#include "texture/write_image.h"

namespace coppermoon::end_to_end {
namespace {

constexpr int could_not = 1, wrong_usage = 2;
constexpr const char* eclipse_of_2008 = "2008-02-21T03:26:05Z";

/// Every test here: one line, the right exit status, and nothing left behind.
class BadInput : public ProgramTest {
 protected:
  /// A quick bake that is right in all but what is added.
  static Words bake(const Words& more) {
    return words_of("bake {} -o moon.exr --texture-width 16 --rays 50 --albedo-map built-in",
                    eclipse_of_2008) +
           more;
  }

  /// A quick still, likewise; it has no shadow to compute.
  static Words still(const Words& more) {
    return words_of(
               "still {} --unshadowed -o frame.png --texture-width 16 --albedo-map built-in "
               "--width 16 --height 16",
               eclipse_of_2008) +
           more;
  }

  /// An albedo map without fault.
  std::string map() const {
    texture::write_png(here("map.png"), texture::Image(32, 16, {"Y"}), 8);
    return "map.png";
  }

  /// A folder with a program named povray that says some words and fails.
  std::string folder_of_failing_povray() const {
    std::filesystem::create_directory(here("bin"));
    file("bin/povray",
         "#!/bin/sh\necho 'Parse Error: Out of moonlight' >&2\necho 'Render failed' >&2\nexit 1\n");
    std::filesystem::permissions(here("bin/povray"), std::filesystem::perms::owner_all);
    return here("bin").string() + ":/usr/bin:/bin";
  }
};

TEST_F(BadInput, TheCommandsThatAreSpoiltHereAreSound) {
  expect_done(coppermoon(bake({})));
  EXPECT_TRUE(std::filesystem::exists(here("moon.exr")));
}

TEST_F(BadInput, AnAlbedoMapThatIsNoImageIsRefused) {
  file("text.png", "not a picture at all\n");
  expect_refused(bake("--albedo-map text.png"), {"text.png: cannot be read"});
}

TEST_F(BadInput, AMissingAlbedoMapIsRefused) {
  expect_refused(bake("--albedo-map missing.png"), {"missing.png", "no such file"});
}

TEST_F(BadInput, AnEmptyAlbedoMapIsRefused) {
  file("empty.png", "");
  expect_refused(bake("--albedo-map empty.png"), {"empty.png", "it is empty"});
}

TEST_F(BadInput, AnAlbedoMapThatEndsEarlyIsRefused) {
  texture::Image image(64, 32, {"R", "G", "B"});
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] = static_cast<float>((i * 7919) % 1000) / 1000;
  texture::write_png(here("whole.png"), image, 8);
  const auto bytes = text_of(here("whole.png"));
  file("half.png", bytes.substr(0, bytes.size() / 2));
  expect_refused(bake("--albedo-map half.png"), {"half.png: cannot be read"});
}

TEST_F(BadInput, AnAlbedoMapThatIsNotTwoToOneIsRefused) {
  texture::write_png(here("square.png"), texture::Image(16, 16, {"Y"}), 8);
  expect_refused(bake("--albedo-map square.png"), {"16 x 16", "2:1"});
}

TEST_F(BadInput, ABlackAlbedoMapIsRefused) {
  texture::write_png(here("black.png"), texture::Image(32, 16, {"Y"}), 8);
  expect_refused(bake("--atmosphere undated --albedo-map black.png"), {"mean 0", "above 0"});
}

TEST_F(BadInput, TermsOutsideTheirRangesAreRefusedWithTheirUnit) {
  const auto refused = [&](const Words& words, std::string_view text) {
    expect_refused(bake(words), {text});
  };
  refused("--cloud-cover 70", "cloud cover = 70, allowed 0 to 1");
  refused("--cloud-top-km 10000", "cloud top [km] = 10000, allowed 0 to 30");
  refused("--tropospheric-aerosol -0.1", "tropospheric aerosol = -0.1, allowed 0 to 10");
  refused("--danjon 5", "danjon = 5, allowed 0 to 4");
  refused("--dust-extinction 4.7", "dust extinction [1/m] = 4.7, allowed 0 to 0.01");
  refused("--dust-bottom-km 30 --dust-extinction 1e-6", "dust top [km] = 20, allowed 30 to 86");
  refused("--ozone-du 3450", "ozone [DU] = 3450, allowed 0 to 1000");
  refused(words_of("--albedo-exponent 0 --albedo-map {}", map()),
          "albedo exponent = 0, allowed 0.1 to 10");
}

TEST_F(BadInput, ARegionThatCannotBeIsRefused) {
  const auto refused = [&](const std::string& region, std::string_view text) {
    expect_refused(bake({"--region", region}), {text});
  };
  refused("from-latitude=-100,to-latitude=0", "latitude [degrees] = -100, allowed -90 to 90");
  refused("from-latitude=20,to-latitude=0", "latitude [degrees] = 0, allowed 20 to 90");
  refused("from-position-angle=0,to-position-angle=1000",
          "position angle [degrees] = 1000, allowed -360 to 720");
  refused("from-latitude=-90,to-latitude=0,cloud-cover=2", "cloud cover = 2, allowed 0 to 1");
  refused("dust-extinction=1e-5", "needs from-latitude and to-latitude");
}

TEST_F(BadInput, WordsATermDoesNotKnowAreRefused) {
  expect_refused(bake("--atmosphere venus"), {"venus", "standard"}, wrong_usage);
  expect_refused(bake("--stratospheric-aerosol some"), {"some", "moderate"}, wrong_usage);
  expect_refused(bake("--earth flat"), {"flat", "ellipsoid"}, wrong_usage);
  expect_refused(bake("--photometry lambert"), {"lambert", "yapo-cutler"}, wrong_usage);
}

TEST_F(BadInput, AnOutputInNoSuchDirectoryIsRefused) {
  expect_refused(bake("-o nowhere/moon.exr"), {"nowhere: no such directory"});
  expect_refused(still("-o nowhere/frame.png"), {"nowhere: no such directory"});
  expect_refused(words_of("scene {} -o nowhere/scene", eclipse_of_2008),
                 {"nowhere: no such directory"});
}

TEST_F(BadInput, ASceneInThePlaceOfAFileIsRefused) {
  file("scene", "a file");
  expect_refused(words_of("scene {} --unshadowed -o scene", eclipse_of_2008),
                 {"scene: is no directory"});
}

TEST_F(BadInput, ATextureOfAnotherEndingIsRefused) {
  expect_refused(bake("-o moon.tif"), {"moon.tif", ".exr"});
}

TEST_F(BadInput, AFullDiskIsAnErrorAndLeavesNothing) {
  const Words large = "--texture-width 512 --unshadowed";
  expect_refused(bake(large), {"moon.exr", "File too large"}, could_not, {.file_limit = 20000});
}

TEST_F(BadInput, AFullDiskLeavesNoHalfAScene) {
  expect_refused(words_of("scene {} --unshadowed --texture-width 512 -o scene", eclipse_of_2008),
                 {"File too large"}, could_not, {.file_limit = 20000});
}

TEST_F(BadInput, AFullDiskKeepsTheOldFile) {
  const auto old = file("moon.exr", "the old one");
  expect_refused(bake("--texture-width 512 --unshadowed"), {"moon.exr"}, could_not,
                 {.file_limit = 20000});
  EXPECT_EQ(text_of(old), "the old one");
}

TEST_F(BadInput, AnUnknownFlagIsAnsweredWithTheNearest) {
  expect_refused(bake("--ozon-du 300"), {"--ozon-du", "--ozone-du"}, wrong_usage);
  expect_refused({"sky", eclipse_of_2008, "--jsn"}, {"--jsn", "--json"}, wrong_usage);
}

TEST_F(BadInput, AnUnknownPhotometryIsRefused) {
  expect_refused(bake("--photometry lambert"),
                 {"--photometry", "lambert", "lommel-seeliger-rolo", "yapo-cutler"}, wrong_usage);
}

TEST_F(BadInput, AnUnknownWordIsAnsweredWithTheNearest) {
  expect_refused({"bakee", eclipse_of_2008}, {"bakee", "did you mean bake?"}, wrong_usage);
}

TEST_F(BadInput, AnUnknownShortFlagIsRefused) { expect_refused(bake({"-q"}), {"-q"}, wrong_usage); }

TEST_F(BadInput, NoWordAtAllIsWrongUsage) { expect_refused({}, {}, wrong_usage); }

TEST_F(BadInput, ALeftOutOutputIsWrongUsage) {
  expect_refused({"bake", eclipse_of_2008}, {"--output"}, wrong_usage);
}

TEST_F(BadInput, AnUnknownRecipeKeyIsAnsweredWithItsLineAndTheNearest) {
  file("typo.toml", "# a recipe\nrays = 50\nozon-du = 300\n");
  expect_refused(bake("--recipe typo.toml"), {"typo.toml:3", "ozon-du", "ozone-du"}, wrong_usage);
}

TEST_F(BadInput, ARecipeWithASyntaxErrorIsAnsweredWithItsLine) {
  file("broken.toml", "rays = 50\nozone-du = = 3\n");
  expect_refused(bake("--recipe broken.toml"), {"broken.toml:2"});
}

TEST_F(BadInput, ARecipeWithTablesIsRefused) {
  file("table.toml", "[rays]\nmany = 50\n");
  expect_refused(bake("--recipe table.toml"), {"table.toml:2", "rays is no table"});
}

TEST_F(BadInput, AnUnknownKeyInATableOfTheAirIsAnsweredWithItsLineAndTheNearest) {
  file("air.toml", "[atmosphere]\nozon-du = 300\n");
  expect_refused(bake("--recipe air.toml"), {"air.toml:2", "ozon-du", "the nearest is ozone-du"},
                 wrong_usage);
  file("region.toml", "[[atmosphere.region]]\nfrom-latitude = -90\nto-latitud = 0\n");
  expect_refused(bake("--recipe region.toml"),
                 {"region.toml:3", "to-latitud", "the nearest is to-latitude"}, wrong_usage);
}

TEST_F(BadInput, ABadModelOfTheAirIsWrongUsage) {
  file("air.toml", "[atmosphere]\nmodel = \"martian\"\n");
  expect_refused(bake("--recipe air.toml"), {"air.toml:2: atmosphere = martian", "paper"}, wrong_usage);
}

TEST_F(BadInput, ABadRegionInARecipeIsRefusedWithItsLine) {
  const auto expect = [&](const std::string& region,
                          std::initializer_list<std::string_view> parts) {
    file("bad.toml", "rays = 50\n[[atmosphere.region]]\n" + region);
    expect_refused(bake("--recipe bad.toml"), parts);
  };
  expect("", {"bad.toml:2", "from-latitude and to-latitude", "[degrees]"});
  expect("cloud-cover = 1\n", {"bad.toml:2", "from-latitude and to-latitude", "[degrees]"});
  expect("from-latitude = \"S\"\nto-latitude = 0\n", {"bad.toml:2", "from-latitude", "S"});
  expect("from-latitude = [1, 2]\nto-latitude = 0\n", {"bad.toml:3", "from-latitude", "1,2"});
}

TEST_F(BadInput, ARegionThatNoEarthHasIsRefused) {
  const auto expect = [&](const std::string& region,
                          std::initializer_list<std::string_view> parts) {
    expect_refused(bake({"--region", region}), parts);
  };
  expect("from-latitude=-95,to-latitude=0", {"latitude [degrees] = -95", "allowed -90 to 90"});
  expect("from-latitude=10,to-latitude=0", {"latitude", "10"});
  expect("from-position-angle=0,to-position-angle=nan", {"position angle [degrees] = nan"});
  expect("from-latitude=-90,to-latitude=0,dust-extinction=-1", {"dust extinction", "-1"});
  expect("from-latitude=-90,to-latitude=0,cloud-cover=2", {"cloud cover", "2", "allowed 0 to 1"});
  expect("from-latitude=-90,to-position-angle=0", {"from-latitude and to-latitude", "[degrees]"});
  expect("from-latitude=-90,from-position-angle=0,to-position-angle=9",
         {"from-latitude and to-latitude", "[degrees]"});
  expect("", {"region", "from-latitude and to-latitude"});
}

TEST_F(BadInput, AMissingRecipeIsRefused) {
  expect_refused(bake("--recipe missing.toml"), {"missing.toml: cannot be read"});
}

TEST_F(BadInput, TwoRecipesAreRefused) {
  file("one.toml", "rays = 50\n");
  expect_refused(bake("--recipe one.toml --recipe=one.toml"), {"--recipe", "once"}, wrong_usage);
}

TEST_F(BadInput, ADateThatIsNoneIsRefused) {
  for (const char* date : {"2008-02-30", "yesterday", "2008-13-01", "2008-02-21T25:00", ""})
    expect_refused({"sky", date}, {date});
}

TEST_F(BadInput, AnInstantWithoutEclipseIsAnsweredWithTheNearest) {
  Words words = bake({});
  words[1] = "2008-02-25T00:00:00Z";
  expect_refused(words, {"no lunar eclipse", "2008-02-21T03:2", "--unshadowed"});
  expect_done(coppermoon(words + Words{"--unshadowed"}));
}

TEST_F(BadInput, AMoonBelowTheHorizonIsRefused) {
  // At 150 east it is one in the afternoon, and the Moon is full.
  expect_refused(still("--at -30,150"), {"from -30,150 the Moon is", "below the horizon"});
}

TEST_F(BadInput, DustThatNoAirHoldsIsRefused) {
  for (const char* alpha : {"-1", "1e9", "nan", "inf"})
    expect_refused(bake({"--dust-extinction", alpha}), {"dust extinction", "allowed 0 to"},
                   could_not);
}

TEST_F(BadInput, ANumberThatIsNoneIsWrongUsage) {
  expect_refused(bake("--dust-extinction much"), {"dust-extinction", "much"}, wrong_usage);
}

TEST_F(BadInput, AMissingPovrayIsNamed) {
  std::filesystem::create_directory(here("bin"));
  expect_refused(still({}), {"povray: not found", "install"}, could_not, {.path = here("bin")});
}

TEST_F(BadInput, AMissingGnuplotIsSaid) {
  // 300 kB of table: more than a pipe takes before it hears that nobody reads.
  std::string many = "400";
  for (int i = 1; i < 100; ++i) many += fmt::format(",{}", 400 + i);
  expect_refused(
      words_of("shadow 2008-02-21T03:08:26Z --rays 20 --wavelengths {} -o shadow.png", many),
      {"gnuplot: not found", "install"}, could_not, {.path = here("bin")});
}

TEST_F(BadInput, AFailingPovrayHasTheLastWord) {
  expect_refused(still({}), {"povray: ", "Out of moonlight", "Render failed"}, could_not,
                 {.path = folder_of_failing_povray()});
}

TEST_F(BadInput, NegativePhotonsAreRefusedWhateverTheSolver) {
  expect_refused(bake("--solver photons --photons -5"), {"photons = -5", "allowed 1 to"});
  expect_refused(bake("--photons -5"), {"photons = -5", "allowed 1 to"});
}

TEST_F(BadInput, ASolverThatIsSetWrongIsRefused) {
  expect_refused(bake("--rays -3"), {"rays = -3"});
  expect_refused(bake("--seed -3"), {"--seed", "-3"}, wrong_usage);
  expect_refused(bake("--smoothing-km -3"), {"smoothing [km] = -3"});
  const Words photons = "--solver photons --photons 10";
  expect_refused(bake(photons + "--step-km 0"), {"step [km] = 0"});
  expect_refused(bake(photons + "--ring-km nan"), {"ring [km] = nan"});
}

TEST_F(BadInput, ATextureWidthThatIsNoneIsRefused) {
  expect_refused(bake("--texture-width 15"), {"texture width", "15", "even"});
  expect_refused(bake("--texture-width 0"), {"texture width", "= 0", "allowed"});
  expect_refused(bake("--texture-width -5"), {"texture-width", "-5"}, wrong_usage);
}

TEST_F(BadInput, APlaceThatIsNoneIsRefused) {
  expect_refused(words_of("sky {} --at 95,0", eclipse_of_2008), {"latitude", "95", "-90 to 90"});
  expect_refused(words_of("sky {} --at foo", eclipse_of_2008), {"foo", "LATITUDE,LONGITUDE"});
  expect_refused(words_of("sky {} --at nan,0", eclipse_of_2008), {"latitude", "nan"});
  expect_refused(words_of("sky {} --at 10,20,nan", eclipse_of_2008), {"elevation", "nan"});
}

TEST_F(BadInput, AFeatureThatIsNoPlaceOnTheMoonIsRefused) {
  const auto expect = [&](const char* place, std::initializer_list<std::string_view> parts) {
    expect_refused(words_of("almanac --from 2008-01-01 --to 2008-12-31 --feature {}", place),
                   parts);
  };
  expect("95,0", {"latitude", "95", "-90 to 90"});
  expect("0,400", {"longitude", "400", "-360 to 360"});
  expect("nan,0", {"latitude", "nan"});
  for (const char* text : {"Atlantis", "10", "1,2,3", ""})
    expect(text, {text, "LATITUDE,LONGITUDE"});
}

TEST_F(BadInput, AViewThereIsNotIsAnsweredWithThoseThereAre) {
  expect_refused(still("--view Nonsense"),
                 {"Nonsense", "Un-tone-mapped", "ACES 1.0 SDR Video", "Raw"});
}

TEST_F(BadInput, ADisplayThereIsNotIsAnsweredWithThoseThereAre) {
  expect_refused(still("--display Nonsense"), {"Nonsense", "sRGB"});
}

TEST_F(BadInput, ACameraThatIsNoneIsRefused) {
  expect_refused(still("--time -1"), {"-1", "allowed", "s"});
  expect_refused(still("--time soon"), {"soon", "auto"});
  expect_refused(still("--iso 0"), {"0", "allowed"});
  expect_refused(still("--f-number nan"), {"nan", "allowed"});
  expect_refused(still("--field -3"), {"field of view", "-3"});
  expect_refused(still("--width 0"), {"width", "0"});
  expect_refused(still("--width -1"), {"width", "-1"}, wrong_usage);
}

TEST_F(BadInput, AFrameThatIsNoImageIsRefused) {
  file("frame.exr", "no light in here\n");
  expect_refused("develop frame.exr -o frame.png", {"frame.exr: cannot be read"});
  expect_refused("develop none.exr -o frame.png", {"none.exr", "no such file"});
}

TEST_F(BadInput, AFrameWithoutColoursIsRefused) {
  texture::write_exr(here("grey.exr"), texture::Image(4, 4, {"Y"}), {});
  expect_refused("develop grey.exr -o frame.png", {"channels Y, allowed R, G, B"});
}

TEST_F(BadInput, ASpaceThereIsNotIsAnsweredWithThoseThereAre) {
  expect_refused(bake("--space prophoto"), {"prophoto", "lin_rec709", "acescg"});
}

TEST_F(BadInput, AShadowCutBackwardsIsRefused) {
  const Words shadow = "shadow --moon-distance-km 380000 --sun-distance-km 1.5e8 --rays 50";
  expect_refused(shadow + "--axis-distances 5000,4000", {"axis distance [km] = 4000"});
  expect_refused(shadow + "--wavelengths 5", {"wavelength", "5"});
  expect_refused({"shadow"}, {"moment"}, wrong_usage);
}

TEST_F(BadInput, AnAlmanacThatRunsBackwardsIsRefused) {
  expect_refused("almanac --from 2009-01-01 --to 2008-01-01", {"2008-01-01"});
}

}  // namespace
}  // namespace coppermoon::end_to_end
