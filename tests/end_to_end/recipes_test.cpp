// SPDX-License-Identifier: MIT
// A recipe is the flags; a file made is its own recipe.
#include "support/program.h"
#include "texture/read_image.h"
#include "texture/write_image.h"
#include "uses/picture/lit_scene.h"
#include "uses/picture/place_text.h"

namespace coppermoon::end_to_end::recipes_test {

class Recipes : public ProgramTest {
 protected:
  void SetUp() override {
    file("eclipse.toml",
         "# all kinds of values\n"
         "instant = 2008-02-21T03:08:26Z\n"
         "rays = 60\n"
         "ozone-du = 200.0\n"
         "dust-extinction = 4.7e-6\n"
         "texture-width = 32\n"
         "rayleigh = true\n"
         "atmosphere = \"undated\"\n"
         "albedo-map = \"built-in\"\n");
  }

  void make(const Words& words) const { expect_done(coppermoon(words)); }

  /// Once for all tests; the last word is the file.
  void make_once(const Words& words) const {
    static std::map<Words, std::string> made;
    auto& bytes = made[words];
    if (bytes.empty()) {
      make(words);
      bytes = text_of(here(words.back()));
    }
    file(words.back(), bytes);
  }

  void make_eclipse() const { make_once("bake --recipe eclipse.toml -o eclipse.exr"); }

  std::string bytes(const char* name) const {
    const auto text = text_of(here(name));
    EXPECT_GT(text.size(), 500U) << name;
    return text;
  }

  std::string recipe_in(const char* name) const {
    return texture::read_attribute(here(name), "coppermoon:recipe").value_or("");
  }
};

TEST_F(Recipes, AreTheSameAsTheirFlags) {
  make_eclipse();
  make(
      "bake 2008-02-21T03:08:26Z --rays 60 --ozone-du 200.0 --dust-extinction 4.7e-6 "
      "--texture-width 32 --rayleigh on --atmosphere undated --albedo-map built-in -o flags.exr");
  EXPECT_TRUE(bytes("eclipse.exr") == bytes("flags.exr"));
}

TEST_F(Recipes, OfOneCommandServeAllOthers) {
  file("night.toml",
       "instant = \"2018-07-27 U2+10min\"\nat = \"Nairobi\"\nwidth = 48\nheight = 32\n"
       "texture-width = 32\nalbedo-map = \"built-in\"\n[camera]\nmodel = \"400mm\"\niso = 800\n"
       "[atmosphere]\nmodel = \"undated\"\n");
  for (const Words& words :
       {Words{"sky"}, Words{"plan"}, Words{"brightness"}, Words("bake -o a.exr"),
        Words("scene -o folder"), Words("still -o a.png")}) {
    const auto outcome = coppermoon(words + "--recipe night.toml");
    EXPECT_EQ(outcome.status, 0) << words[0] << ": " << outcome.err;
    EXPECT_SAYS(outcome.err, "U2+10min is 2018-07-27 19:40:");
  }
  // what no command knows is refused by each
  file("wrong.toml", "instant = 2018-07-27T20:21:45Z\nwidht = 48\n");
  EXPECT_SAYS(coppermoon("sky --recipe wrong.toml").err, "wrong.toml:2: widht");
}

// Files of version 0.1 say "standard" of the air that is called "undated" now.
// Version 0.1 knew no glow: its cameras had none.
// A program of one's own, as docs/library.md has it, need not write the texture's recipe: its header holds it.
TEST_F(Recipes, OfTheLibraryBakeTheSameTexels) {
  uses::MoonRequest request{.texture_width = 32};
  request.light.wish.tolerance = 0.05;
  request.light.air.atmosphere = "undated";
  request.light.air.column.ozone_du = 280.1;
  request.light.air.regions = {
      {.from_latitude = -90, .to_latitude = 0.1, .column = {.dust_extinction_per_m = 1e-5}}};
  request.ground_by_place = false;
  uses::ViewRequest view{.observer = uses::observer_from("-1.2833333,36.8166667,1684.3")};
  view.observer_ozone_du = 250;
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2018-07-27T20:21:45.123456Z"));
  const auto scene = uses::lit_scene(request, view, sky);
  for (const bool passes : {false, true}) {
    auto made = uses::baked(scene.moon, {.space = colour::WorkingSpace::acescg,
                                         .type = texture::ExrType::floating,
                                         .spectral_nm = 100,
                                         .passes = passes});
    texture::write_exr(here("library.exr"), made.parts, made.attributes,
                       {texture::ExrType::floating});
    const auto recipe = recipe_in("library.exr");
    file("library.toml", recipe);
    make("bake --recipe library.toml -o program.exr");
    EXPECT_TRUE(texture::read_image(here("program.exr")).values ==
                texture::read_image(here("library.exr")).values)
        << recipe;
  }
}

TEST_F(Recipes, GiveWayToTheUsersFlags) {
  make("bake --recipe eclipse.toml -o other.exr --ozone-du 0");
  make("bake --ozone-du 0 --recipe=eclipse.toml -o before.exr");
  make(
      "bake 2008-02-21T03:08:26Z --rays 60 --ozone-du 0 --dust-extinction 4.7e-6 --texture-width "
      "32 --atmosphere undated --albedo-map built-in -o flags.exr");
  EXPECT_TRUE(bytes("other.exr") == bytes("flags.exr"));
  EXPECT_TRUE(bytes("before.exr") == bytes("flags.exr"));
}

TEST_F(Recipes, GiveWayToTheUsersInstant) {
  make("bake 2008-02-21T03:26:05Z --recipe eclipse.toml -o later.exr");
  EXPECT_SAYS(recipe_in("later.exr"), "2008-02-21T03:26:05Z") << recipe_in("later.exr");
}

TEST_F(Recipes, GiveWayToTheUsersLists) {
  file("shadow.toml", "wavelengths = [450, 550]\naxis-distances = [0, 1000.5]\nrays = 50\n");
  const Words shadow =
      "shadow --moon-distance-km 376400 --sun-distance-km 1.48e8 --recipe shadow.toml";
  const auto as_told = coppermoon(shadow);
  expect_done(as_told);
  EXPECT_TRUE(
      as_told.out.starts_with("axis_distance_km,irradiance_ratio_450nm,standard_error_450nm,"
                              "irradiance_ratio_550nm,standard_error_550nm\n0,"))
      << as_told.out;
  EXPECT_SAYS(as_told.out, "\n1000.5,");
  Words own = shadow;
  own += "--wavelengths 650";
  const auto otherwise = coppermoon(own);
  expect_done(otherwise);
  EXPECT_TRUE(
      otherwise.out.starts_with("axis_distance_km,irradiance_ratio_650nm,standard_error_650nm\n"))
      << otherwise.out;
}

TEST_F(Recipes, InAHeaderReproduceTheFile) {
  make("bake --recipe eclipse.toml -o old.exr --space acescg --type float");
  make("bake old.exr -o new.exr");
  EXPECT_TRUE(bytes("old.exr") == bytes("new.exr"));
  make("bake --recipe old.exr -o again.exr");
  EXPECT_TRUE(bytes("old.exr") == bytes("again.exr"));
}

TEST_F(Recipes, InAHeaderReproduceAFileWhateverTheSpellingOfItsNumbers) {
  make(
      "bake 2008-02-21T03:08:26Z --rays 060 --dust-extinction .5e-6 --texture-width 32 "
      "--albedo-map built-in --ozone-du +200 -o old.exr --json");
  make("bake old.exr -o new.exr");
  EXPECT_TRUE(bytes("old.exr") == bytes("new.exr"));
}

TEST_F(Recipes, InAHeaderReproduceAFileWhateverItsMapIsCalled) {
  make(words_of("bake --recipe eclipse.toml -o {} --unshadowed", "A \"map\", \xc3\xa4.exr"));
  make(
      words_of("bake --recipe eclipse.toml -o old.exr --albedo-map {}", "A \"map\", \xc3\xa4.exr"));
  make("bake old.exr -o new.exr");
  EXPECT_TRUE(bytes("old.exr") == bytes("new.exr"));
}

TEST_F(Recipes, InAHeaderKeepThePhotometry) {
  make("bake --recipe eclipse.toml --photometry yapo-cutler -o old.exr");
  make("bake old.exr -o new.exr");
  EXPECT_TRUE(bytes("old.exr") == bytes("new.exr"));
  make_eclipse();
  EXPECT_TRUE(texture::read_image(here("old.exr")).values !=
              texture::read_image(here("eclipse.exr")).values);
}

TEST_F(Recipes, InAHeaderGiveWayToTheUsersFlags) {
  make_eclipse();
  make("bake eclipse.exr -o wide.exr --texture-width 64");
  EXPECT_EQ(texture::read_image(here("wide.exr")).width, 64U);
}

TEST_F(Recipes, InAHeaderComplainOfNothingThatTheUserDidNotType) {
  expect_done(
      coppermoon("bake 2018-07-27T20:21:45Z --solver photons --photons 1e4 --texture-width 64 "
                 "--albedo-map built-in --atmosphere undated -o a.exr"));
  EXPECT_EQ(coppermoon("brightness a.exr").err, "");
  EXPECT_SAYS(coppermoon("brightness a.exr --place-error 0.002").err, "--place-error: no effect");
}

TEST_F(Recipes, AreTakenFromAnotherWordsFile) {
  make("scene --recipe eclipse.toml --up moon-north --width 32 --height 32 -o scene");
  make("bake scene/moon_lin_rec709.exr -o new.exr");
  EXPECT_TRUE(texture::read_image(here("new.exr")).values ==
              texture::read_image(here("scene/moon_lin_rec709.exr")).values);
}

/// A quick eclipse with regions, by flags alone.
Words with_regions(const Words& regions, const char* output) {
  Words words =
      "bake 2008-02-21T03:08:26Z --quality draft --rays 20 --texture-width 32 --atmosphere undated "
      "--albedo-map built-in";
  for (const auto& region : regions) words += Words{"--region", region};
  return words + Words{"-o", output};
}

constexpr const char* quick =
    "instant = 2008-02-21T03:08:26Z\nquality = \"draft\"\nrays = 20\ntexture-width = 32\n"
    "albedo-map = \"built-in\"\n[atmosphere]\nmodel = \"undated\"\n";

constexpr const char* north = "from-latitude=0,to-latitude=90,dust-extinction=1e-5";

TEST_F(Recipes, WithRegionsAreTheSameAsTheirFlags) {
  file("plume.toml", std::string(quick) +
                         "[[atmosphere.region]]\nfrom-latitude = -90\nto-latitude = 0\n"
                         "dust-extinction = 1e-5\n"
                         "[[atmosphere.region]]\nfrom-position-angle = 330\n"
                         "to-position-angle = 30\ncloud-cover = 1\n");
  make("bake --recipe plume.toml -o recipe.exr");
  make(with_regions({"from-latitude=-90,to-latitude=0,dust-extinction=.1e-4",
                     "from-position-angle=330,to-position-angle=30.0,cloud-cover=1"},
                    "flags.exr"));
  EXPECT_TRUE(bytes("recipe.exr") == bytes("flags.exr"));
  make("bake recipe.exr -o again.exr");
  EXPECT_TRUE(bytes("recipe.exr") == bytes("again.exr"));
}

TEST_F(Recipes, WithRegionsWriteZeroWithoutASign) {
  // TOML's -0 is a whole number, and has none
  make(with_regions({"from-latitude=-.0,to-latitude=0,dust-extinction=1e-5"}, "flags.exr"));
  make("bake flags.exr -o recipe.exr");
  EXPECT_TRUE(bytes("recipe.exr") == bytes("flags.exr"));
}

TEST_F(Recipes, WithRegionsGiveWayToTheUsers) {
  file("south.toml", std::string(quick) +
                         "[[atmosphere.region]]\nfrom-latitude = -90\nto-latitude = 0\n"
                         "dust-extinction = 1e-4\n");
  make(words_of("bake --recipe south.toml -o recipe.exr --region {}", north));
  make_once(with_regions({north}, "flags.exr"));
  EXPECT_TRUE(bytes("recipe.exr") == bytes("flags.exr"));
}

using RecipesThoroughly = Recipes;

TEST_F(RecipesThoroughly, PositionAnglesMayPassOverNorth) {
  // A sector told in one piece is the same sector told in two that meet in the north; all knobs are
  // set, for more regions are more work, and would be planned otherwise.
  const auto make_with = [&](const Words& regions, const char* output) {
    auto words = with_regions(regions, output);
    words += "--bands 20 --sun-terms 3 --planes 2 --place-error 3e-4 --leave-out none";
    make(words);
  };
  make_with({"from-position-angle=330,to-position-angle=30,cloud-cover=1"}, "one.exr");
  make_with({"from-position-angle=330,to-position-angle=360,cloud-cover=1",
             "from-position-angle=0,to-position-angle=30,cloud-cover=1"},
            "two.exr");
  make_with({"from-position-angle=30,to-position-angle=330,cloud-cover=1"}, "rest.exr");
  const auto values = [&](const char* name) { return texture::read_image(here(name)).values; };
  const auto one = values("one.exr"), two = values("two.exr");
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i)
    EXPECT_WITHIN(
        two[i], one[i],
        1e-3 * std::max({one[i - i % 3], one[i - i % 3 + 1], one[i - i % 3 + 2]}) + 1e-6,
        "of a texel's brightest channel: a step of half floats, and the error between places");
  EXPECT_TRUE(one != values("rest.exr"));
}

TEST_F(Recipes, ARegionThatStandsTwiceCountsOnce) {
  make_once(with_regions({north}, "flags.exr"));
  make(with_regions({north, north}, "twice.exr"));
  make(with_regions({}, "without.exr"));
  const auto values = [&](const char* name) { return texture::read_image(here(name)).values; };
  EXPECT_TRUE(values("flags.exr") == values("twice.exr"));
  EXPECT_TRUE(values("flags.exr") != values("without.exr"));
}

/// Red light of a frame's outer thirds.
struct Thirds {
  double north = 0, south = 0;
};

Thirds thirds_of(const texture::Image& frame) {
  Thirds sum;
  for (std::size_t row = 0; row < frame.height / 3; ++row)
    for (std::size_t column = 0; column < frame.width; ++column) {
      sum.north += frame(row, column, 0);
      sum.south += frame(frame.height - 1 - row, column, 0);
    }
  return sum;
}

TEST_F(RecipesThoroughly, OfAVolcanoDarkensItsHalfOfTheShadow) {
  const std::string example = COPPERMOON_TEST_DATA "/../examples/volcanic_south.toml";
  const auto thirds_with = [&](const Words& more) {
    auto words = words_of(
        "still --recipe {} --width 48 --height 48 --texture-width 64 --rays 100 --albedo-map "
        "built-in -o still.png --frame frame.exr",
        example);
    words += more;
    make(words);
    return thirds_of(texture::read_image(here("frame.exr")));
  };
  const auto calm = thirds_with("--region from-latitude=-90,to-latitude=0"),
             southern = thirds_with({}),
             northern =
                 thirds_with("--region from-latitude=0,to-latitude=90,stratospheric-aerosol=high");
  EXPECT_LT(southern.south, 0.6 * calm.south);
  EXPECT_GT(southern.north, 0.9 * calm.north);
  // The Moon passes north of the axis: its south is lit from all around.
  EXPECT_LT(northern.north, 0.6 * calm.north);
  EXPECT_LT(northern.north / calm.north, 0.6 * northern.south / calm.south);
}

/// An eclipse by a few photons.
Words by_photons(const char* seed, const char* threads, const char* output) {
  return {"bake",      "--recipe",  "eclipse.toml",   "--solver", "photons",
          "--photons", "2000",      "--smoothing-km", "300",      "--seed",
          seed,        "--threads", threads,          "-o",       output};
}

TEST_F(Recipes, PhotonsAreTheSameOnAnyNumberOfThreads) {
  make_once(by_photons("1", "1", "photons.exr"));
  make(by_photons("1", "2", "threads.exr"));
  EXPECT_TRUE(bytes("photons.exr") == bytes("threads.exr"));
}

TEST_F(Recipes, PhotonsOfAnotherSeedAreOthers) {
  make_once(by_photons("1", "1", "photons.exr"));
  make(by_photons("2", "1", "others.exr"));
  EXPECT_TRUE(texture::read_image(here("photons.exr")).values !=
              texture::read_image(here("others.exr")).values);
}

}  // namespace coppermoon::end_to_end::recipes_test
