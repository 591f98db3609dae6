// SPDX-License-Identifier: MIT
#include "support/program.h"
#include "texture/write_image.h"

namespace coppermoon::end_to_end::bad_input_test {

constexpr const char* eclipse_of_2008 = "2008-02-21T03:26:05Z";

/// A command line, and what its refusal says.
struct Refused {
  Words words;
  std::vector<std::string> parts;
  int status = could_not;
};

/// A quick bake that is right in all but what is added.
Words bake(const Words& more) {
  return words_of("bake {} -o moon.exr --texture-width 16 --rays 50 --albedo-map built-in",
                  eclipse_of_2008) +
         more;
}

/// A quick still, likewise; it has no shadow to compute.
Words still(const Words& more) {
  return words_of(
             "still {} --unshadowed -o frame.png --texture-width 16 --albedo-map built-in "
             "--width 16 --height 16",
             eclipse_of_2008) +
         more;
}

Words sky_at(const char* place) { return words_of("sky {} --at {}", eclipse_of_2008, place); }

Words with_region(const char* region) { return bake({"--region", region}); }

/// Every test here: one line, the right exit status, and nothing left behind.
class BadInput : public ProgramTest {
 protected:
  void expect_all_refused(const std::vector<Refused>& all) const {
    for (const auto& [words, parts, status] : all) {
      SCOPED_TRACE(fmt::format("{}", fmt::join(words, " ")));
      const auto said = expect_refused(words, "", status);
      for (const auto& part : parts) EXPECT_SAYS(said, part);
    }
  }
};

TEST_F(BadInput, TheCommandsThatAreSpoiltHereAreSound) {
  expect_done(coppermoon(bake({})));
  EXPECT_TRUE(std::filesystem::exists(here("moon.exr")));
}

TEST_F(BadInput, AnAlbedoMapThatIsNoneIsRefused) {
  file("text.png", "not a picture at all\n");
  file("empty.png", "");
  texture::Image image(64, 32, {"R", "G", "B"});
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] = static_cast<float>((i * 7919) % 1000) / 1000;
  texture::write_png(here("whole.png"), image, 8);
  const auto bytes = text_of(here("whole.png"));
  file("half.png", bytes.substr(0, bytes.size() / 2));
  texture::write_png(here("square.png"), texture::Image(16, 16, {"Y"}), 8);
  texture::write_png(here("black.png"), texture::Image(32, 16, {"Y"}), 8);
  expect_all_refused({{bake("--albedo-map text.png"), {"text.png: cannot be read"}},
                      {bake("--albedo-map missing.png"), {"missing.png", "no such file"}},
                      {bake("--albedo-map empty.png"), {"empty.png", "it is empty"}},
                      {bake("--albedo-map half.png"), {"half.png: cannot be read"}},
                      {bake("--albedo-map square.png"), {"16 x 16", "2:1"}},
                      {bake("--atmosphere undated --albedo-map black.png"), {"mean 0", "above 0"}},
                      {bake("--albedo-exponent 0 --albedo-map black.png"),
                       {"albedo exponent = 0, allowed 0.1 to 10"}}});
}

TEST_F(BadInput, ATermOutsideItsRangeIsRefusedWithItsUnit) {
  std::vector<Refused> all{
      {bake("--cloud-cover 70"), {"cloud cover = 70, allowed 0 to 1"}},
      {bake("--cloud-top-km 10000"), {"cloud top [km] = 10000, allowed 0 to 30"}},
      {bake("--tropospheric-aerosol -0.1"), {"tropospheric aerosol = -0.1, allowed 0 to 10"}},
      {bake("--danjon 5"), {"danjon = 5, allowed 0 to 4"}},
      {bake("--dust-extinction 4.7"), {"dust extinction [1/m] = 4.7, allowed 0 to 0.01"}},
      {bake("--dust-bottom-km 30 --dust-extinction 1e-6"),
       {"dust top [km] = 20, allowed 30 to 86"}},
      {bake("--ozone-du 3450"), {"ozone [DU] = 3450, allowed 0 to 1000"}},
      {bake("--dust-extinction much"), {"dust-extinction", "much"}, wrong_usage}};
  for (const char* alpha : {"-1", "1e9", "nan", "inf"})
    all.push_back({bake({"--dust-extinction", alpha}), {"dust extinction", "allowed 0 to"}});
  expect_all_refused(all);
}

TEST_F(BadInput, ARegionThatNoEarthHasIsRefused) {
  expect_all_refused(
      {{with_region("from-latitude=-100,to-latitude=0"),
        {"latitude [degrees] = -100, allowed -90 to 90"}},
       {with_region("from-latitude=20,to-latitude=0"),
        {"latitude [degrees] = 0, allowed 20 to 90"}},
       {with_region("from-position-angle=0,to-position-angle=1000"),
        {"position angle [degrees] = 1000, allowed -360 to 720"}},
       {with_region("from-position-angle=0,to-position-angle=nan"),
        {"position angle [degrees] = nan"}},
       {with_region("from-latitude=-90,to-latitude=0,cloud-cover=2"),
        {"cloud cover = 2, allowed 0 to 1"}},
       {with_region("from-latitude=-90,to-latitude=0,dust-extinction=-1"),
        {"dust extinction", "-1"}},
       {with_region("dust-extinction=1e-5"), {"needs from-latitude and to-latitude"}},
       {with_region("from-latitude=-90,to-position-angle=0"),
        {"from-latitude and to-latitude", "[degrees]"}},
       {with_region("from-latitude=-90,from-position-angle=0,to-position-angle=9"),
        {"from-latitude and to-latitude", "[degrees]"}},
       {with_region(""), {"region", "from-latitude and to-latitude"}}});
}

TEST_F(BadInput, AWordThatIsNotKnownIsAnsweredWithThoseThatAre) {
  expect_all_refused(
      {{bake("--atmosphere venus"), {"venus", "standard"}, wrong_usage},
       {bake("--stratospheric-aerosol some"), {"some", "moderate"}, wrong_usage},
       {bake("--earth flat"), {"flat", "ellipsoid"}, wrong_usage},
       {bake("--photometry lambert"),
        {"--photometry", "lambert", "lommel-seeliger-rolo", "yapo-cutler"},
        wrong_usage},
       {bake("--space prophoto"), {"prophoto", "lin_rec709", "acescg"}},
       {still("--view Nonsense"), {"Nonsense", "Un-tone-mapped", "ACES 1.0 SDR Video", "Raw"}},
       {still("--display Nonsense"), {"Nonsense", "sRGB"}},
       {bake("--ozon-du 300"), {"--ozon-du", "--ozone-du"}, wrong_usage},
       {{"sky", eclipse_of_2008, "--jsn"}, {"--jsn", "--json"}, wrong_usage},
       {{"bakee", eclipse_of_2008}, {"bakee", "did you mean bake?"}, wrong_usage},
       {bake({"-q"}), {"-q"}, wrong_usage},
       {{}, {}, wrong_usage},
       {{"bake", eclipse_of_2008}, {"--output"}, wrong_usage},
       {{"shadow"}, {"moment"}, wrong_usage}});
}

TEST_F(BadInput, AnOutputThatCannotBeIsRefused) {
  file("scene", "a file");
  const auto scene = words_of("scene {} --unshadowed", eclipse_of_2008);
  expect_all_refused(
      {{bake("-o nowhere/moon.exr"), {"nowhere: no such directory"}},
       {still("-o nowhere/frame.png"), {"nowhere: no such directory"}},
       {words_of("scene {} -o nowhere/scene", eclipse_of_2008), {"nowhere: no such directory"}},
       {scene + "-o scene", {"scene: is no directory"}},
       {bake("-o moon.tif"), {"moon.tif", ".exr"}}});
}

TEST_F(BadInput, AFullDiskIsAnErrorAndKeepsWhatWasThere) {
  const Surroundings full{.file_limit = 20000};
  const Words large = "--texture-width 512 --unshadowed";
  expect_refused(bake(large), {"moon.exr", "File too large"}, could_not, full);
  expect_refused(words_of("scene {} -o scene", eclipse_of_2008) + large, "File too large",
                 could_not, full);
  file("moon.exr", "the old one");
  expect_refused(bake(large), "moon.exr", could_not, full);
}

TEST_F(BadInput, ARecipeWithAFaultIsAnsweredWithItsLine) {
  struct Faulty {
    const char* text;
    std::vector<std::string> parts;
    int status = could_not;
  };
  const std::string limits = "from-latitude and to-latitude";
  for (const auto& [text, parts, status] : std::vector<Faulty>{
           {"# a recipe\nrays = 50\nozon-du = 300\n", {":3", "ozon-du", "ozone-du"}, wrong_usage},
           {"rays = 50\nozone-du = = 3\n", {":2"}},
           {"[rays]\nmany = 50\n", {":2", "rays is no table"}},
           {"[atmosphere]\nozon-du = 300\n",
            {":2", "ozon-du", "the nearest is ozone-du"},
            wrong_usage},
           {"[[atmosphere.region]]\nfrom-latitude = -90\nto-latitud = 0\n",
            {":3", "to-latitud", "the nearest is to-latitude"},
            wrong_usage},
           {"rays = 50\n[[atmosphere.region]]\n", {":2", limits, "[degrees]"}},
           {"rays = 50\n[[atmosphere.region]]\ncloud-cover = 1\n", {":2", limits, "[degrees]"}},
           {"rays = 50\n[[atmosphere.region]]\nfrom-latitude = \"S\"\nto-latitude = 0\n",
            {":2", "from-latitude", "S"}},
           {"rays = 50\n[[atmosphere.region]]\nfrom-latitude = [1, 2]\nto-latitude = 0\n",
            {":3", "from-latitude", "1,2"}}}) {
    file("bad.toml", text);
    auto all = parts;
    all.front() = "bad.toml" + all.front();
    expect_all_refused({{bake("--recipe bad.toml"), all, status}});
  }
  file("air.toml", "[atmosphere]\nmodel = \"martian\"\n");
  file("one.toml", "rays = 50\n");
  expect_all_refused(
      {{bake("--recipe air.toml"), {"air.toml:2: atmosphere = martian", "paper"}, wrong_usage},
       {bake("--recipe missing.toml"), {"missing.toml: cannot be read"}},
       {bake("--recipe one.toml --recipe=one.toml"), {"--recipe", "once"}, wrong_usage}});
}

TEST_F(BadInput, AMomentThatIsNoneIsRefused) {
  for (const char* date : {"2008-02-30", "yesterday", "2008-13-01", "2008-02-21T25:00", ""})
    expect_refused({"sky", date}, date);
  auto words = bake({});
  words[1] = "2008-02-25T00:00:00Z";
  expect_refused(words, {"no lunar eclipse", "2008-02-21T03:2", "--unshadowed"});
  expect_done(coppermoon(words + Words{"--unshadowed"}));
}

TEST_F(BadInput, AMissingOrFailingPovrayIsNamed) {
  std::filesystem::create_directory(here("bin"));
  expect_refused(still({}), {"povray: not found", "install"}, could_not, {.path = here("bin")});
  script("bin/povray",
         "echo 'Parse Error: Out of moonlight' >&2\necho 'Render failed' >&2\nexit 1");
  expect_refused(still({}), {"povray: ", "Out of moonlight", "Render failed"}, could_not,
                 {.path = here("bin").string() + ":/usr/bin:/bin"});
}

TEST_F(BadInput, AMissingGnuplotIsSaid) {
  // 300 kB of table: more than a pipe takes before it hears that nobody reads.
  std::string many = "400";
  for (int i = 1; i < 100; ++i) many += fmt::format(",{}", 400 + i);
  expect_refused(
      words_of("shadow 2008-02-21T03:08:26Z --rays 20 --wavelengths {} -o shadow.png", many),
      {"gnuplot: not found", "install"}, could_not, {.path = here("bin")});
}

TEST_F(BadInput, ANumberOfASolverThatIsWrongIsRefused) {
  const Words photons = "--solver photons --photons 10",
              shadow = "shadow --moon-distance-km 380000 --sun-distance-km 1.5e8 --rays 50";
  expect_all_refused({{bake("--solver photons --photons -5"), {"photons = -5", "allowed 1 to"}},
                      {bake("--photons -5"), {"photons = -5", "allowed 1 to"}},
                      {bake("--rays -3"), {"rays = -3"}},
                      {bake("--seed -3"), {"--seed", "-3"}, wrong_usage},
                      {bake("--smoothing-km -3"), {"smoothing [km] = -3"}},
                      {bake(photons + "--step-km 0"), {"step [km] = 0"}},
                      {bake(photons + "--ring-km nan"), {"ring [km] = nan"}},
                      {shadow + "--axis-distances 5000,4000", {"axis distance [km] = 4000"}},
                      {shadow + "--wavelengths 5", {"wavelength", "5"}},
                      {"almanac --from 2009-01-01 --to 2008-01-01", {"2008-01-01"}}});
}

TEST_F(BadInput, APlaceThatIsNoneIsRefused) {
  const auto feature = [](const char* place) {
    return words_of("almanac --from 2008-01-01 --to 2008-12-31 --feature {}", place);
  };
  expect_all_refused({{sky_at("95,0"), {"latitude", "95", "-90 to 90"}},
                      {sky_at("foo"), {"foo", "LATITUDE,LONGITUDE"}},
                      {sky_at("nan,0"), {"latitude", "nan"}},
                      {sky_at("10,20,nan"), {"elevation", "nan"}},
                      // at 150 east it is one in the afternoon, and the Moon is full
                      {still("--at -30,150"), {"from -30,150 the Moon is", "below the horizon"}},
                      {feature("95,0"), {"latitude", "95", "-90 to 90"}},
                      {feature("0,400"), {"longitude", "400", "-360 to 360"}},
                      {feature("nan,0"), {"latitude", "nan"}},
                      {feature("Atlantis"), {"Atlantis", "LATITUDE,LONGITUDE"}},
                      {feature("10"), {"10", "LATITUDE,LONGITUDE"}},
                      {feature("1,2,3"), {"1,2,3", "LATITUDE,LONGITUDE"}},
                      {feature(""), {"LATITUDE,LONGITUDE"}}});
}

TEST_F(BadInput, APictureThatIsNoneIsRefused) {
  file("frame.exr", "no light in here\n");
  texture::write_exr(here("grey.exr"), texture::Image(4, 4, {"Y"}), {});
  expect_all_refused({{bake("--texture-width 15"), {"texture width", "15", "even"}},
                      {bake("--texture-width 0"), {"texture width", "= 0", "allowed"}},
                      {bake("--texture-width -5"), {"texture-width", "-5"}, wrong_usage},
                      {still("--time -1"), {"-1", "allowed", "s"}},
                      {still("--time soon"), {"soon", "auto"}},
                      {still("--iso 0"), {"0", "allowed"}},
                      {still("--f-number nan"), {"nan", "allowed"}},
                      {still("--field -3"), {"field of view", "-3"}},
                      {still("--width 0"), {"width", "0"}},
                      {still("--width -1"), {"width", "-1"}, wrong_usage},
                      {"develop frame.exr -o frame.png", {"frame.exr: cannot be read"}},
                      {"develop none.exr -o frame.png", {"none.exr", "no such file"}},
                      {"develop grey.exr -o frame.png", {"channels Y, allowed R, G, B"}}});
}

}  // namespace coppermoon::end_to_end::bad_input_test
