// SPDX-License-Identifier: MIT
// Files and dates from anyone: maps, recipes, instants, photons' sums.
#include <nlohmann/json.hpp>

#include "almanac/instant.h"
#include "extremes/untrusted.h"
#include "support/testing.h"
#include "texture/read_image.h"
#include "texture/write_image.h"
#include "uses/light/photon_file.h"

namespace coppermoon::extremes::inputs_test {

/// IEC 61966-2-1, by hand.
double srgb(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }

class Maps : public Untrusted {
 protected:
  /// Every texel is the one value that the file was given.
  void expect_uniform(const std::string& what, const std::filesystem::path& map, double value,
                      double tolerance = 1e-6) const {
    double worst = 0;
    const auto read = texture::read_albedo_map(here(map.string()));
    for (const float v : read.values()) worst = std::max(worst, std::abs(v - value) / value);
    EXPECT_WITHIN(worst, 0, tolerance, "floats, and what the file's own coding loses");
    tried("albedo map: " + what, "the value it was given, over itself", tolerance, worst);
  }

  std::string refusal(const std::filesystem::path& map) const {
    return refusal_of([&] { texture::read_albedo_map(here(map.string())); });
  }

  void expect_map_refused(const std::string& what, const std::filesystem::path& map,
                          const std::string& part) const {
    const auto line = refusal(map);
    EXPECT_SAYS(line, part) << what << ": " << line;
    EXPECT_SAYS_NOT(line, '\n') << what << ": " << line;
    refused("albedo map: " + what, line.substr(line.find(": ") + 2));
  }

  std::filesystem::path float_map(int width, int height, std::vector<float> grey) const {
    auto bytes = fmt::format("Pf\n{} {}\n-1\n", width, height);
    bytes.append(reinterpret_cast<const char*>(grey.data()), grey.size() * sizeof(float));
    return file("map.pfm", bytes);
  }
};

TEST_F(Maps, OfEveryDepthAndNumberOfChannelsAreRead) {
  struct Kind {
    const char *what, *size, *channels, *type, *name;
    double value, tolerance = 1e-6;
  };
  const double byte = srgb(128 / 255.), word = srgb(32768 / 65535.);
  for (const auto& [what, size, channels, type, name, value, tolerance] :
       std::vector<Kind>{{"2 x 1, 8 bits", "2x1", "1", "uint8", "a.png", byte},
                         {"1 channel, 16 bits", "8x4", "1", "uint16", "a.png", word},
                         {"2 channels, grey and alpha", "8x4", "2", "uint16", "a.tif", word},
                         {"4 channels, 8 bits", "8x4", "4", "uint8", "a.tif", byte},
                         {"32 bits", "8x4", "3", "uint32", "a.tif", srgb(0.5)},
                         {"double precision", "8x4", "3", "double", "a.tif", 0.5},
                         {"floating point, 1 channel", "8x4", "1", "float", "a.exr", 0.5},
                         {"7 channels", "8x4", "7", "half", "a.exr", 0.5},
                         {"JPEG", "64x32", "3", "uint8", "a.jpg", byte}}) {
    oiiotool(words_of("--create {} {} --addc 0.5 -d {} -o {}", size, channels, type, name));
    expect_uniform(what, name, value, tolerance);
  }
}

TEST_F(Maps, InTilesOfSeveralPartsAndInInksAreRead) {
  const Words rgb = "--create 64x32 3 --addc 0.5";
  oiiotool(rgb + "-d uint16 --tile 16 16 -o tiled.tif");
  expect_uniform("TIFF in tiles", "tiled.tif", srgb(32768 / 65535.));
  oiiotool(rgb + "-d half --tile 48 48 -o tiled.exr");
  expect_uniform("EXR in tiles that do not fit", "tiled.exr", 0.5);
  oiiotool(rgb + "-d half --create 64x32 1 --siappend -o two.exr");
  expect_uniform("EXR of two parts: the first", "two.exr", 0.5);
  const Words inks = "--create 8x4 4 -d uint8 --attrib tiff:ColorSpace CMYK";
  oiiotool(inks + "--chnames C,M,Y,K -o cmyk.tif");
  expect_uniform("TIFF of CMYK, no ink there: white", "cmyk.tif", 1);
  oiiotool(inks + "-o inks.tif");
  expect_map_refused("TIFF of four other inks", "inks.tif", "channels of inks, allowed");
}

TEST_F(Maps, AreReadWhateverTheirNameSays) {
  oiiotool("--create 8x4 3 --addc 0.5 -d uint8 -o a.png");
  for (const char* name : {"a.tif", "a.exr", "a.what", "a"}) {
    std::filesystem::copy_file(here("a.png"), here(name));
    expect_uniform(fmt::format("a PNG named {}", name), name, srgb(128 / 255.));
  }
}

TEST_F(Maps, OfValuesFromTheLeastToTheLargestAreRead) {
  for (const float value : {1e-38F, 1e-20F, 1e20F, 3e38F})
    expect_uniform(fmt::format("all {:g}", value), float_map(8, 4, std::vector<float>(32, value)),
                   value);
}

TEST_F(Maps, WithOneTexelThatIsNoneAreRefused) {
  for (const float value : {NAN, INFINITY, -INFINITY, -1e-30F}) {
    std::vector<float> grey(32, 0.5F);
    grey[30] = value;
    expect_map_refused(fmt::format("one texel {:g}", value), float_map(8, 4, grey),
                       fmt::format("row 0, column 6 = {:g}, allowed 0 or more", value));
  }
}

TEST_F(Maps, OfAnotherShapeAreRefused) {
  expect_map_refused("1 x 1", float_map(1, 1, {0.5F}), "1 x 1 texels, allowed 2:1");
  expect_map_refused("1 x 2", float_map(1, 2, {0.5F, 0.5F}), "1 x 2 texels, allowed 2:1");
  oiiotool("--create 65536x2 1 --addc 0.5 -d uint8 -o wide.tif");
  expect_map_refused("65536 x 2", "wide.tif", "65536 x 2 texels, allowed 2:1");
  oiiotool("--create 8x4 1 --addc 0.5 --fullsize 16x8 -d half -o cut.exr");
  expect_map_refused("cropped", "cut.exr", "cropped from 16 x 8 texels");
}

/// Numbers that begin a TIFF, uncompressed grey, whose header alone is there.
std::string tiff_of(std::uint32_t width, std::uint32_t height) {
  std::string bytes("II*\0\x08\0\0\0\x08\0", 10);
  const auto field = [&](std::uint16_t tag, std::uint32_t value) {
    const std::uint16_t head[] = {tag, 4};
    const std::uint32_t tail[] = {1, value};
    bytes.append(reinterpret_cast<const char*>(head), 4);
    bytes.append(reinterpret_cast<const char*>(tail), 8);
  };
  field(256, width), field(257, height), field(258, 8), field(259, 1), field(262, 1);
  field(273, 8), field(278, height), field(279, 16);
  return bytes + std::string(100, '\0');
}

TEST_F(Maps, ThatClaimMoreThanTheirFileCanHoldAreRefused) {
  file("vast.tif", tiff_of(65536, 32768));
  expect_map_refused("a header alone of 65536 x 32768", "vast.tif", "allowed");
  file("vaster.tif", tiff_of(2'000'000'000, 1'000'000'000));
  expect_map_refused("a header alone of 2e9 x 1e9", "vaster.tif", "vaster.tif: cannot be read");
  file("vast.pfm", "Pf\n65534 32767\n-1\n" + std::string(64, '\0'));
  expect_map_refused("floats, 65534 x 32767 in 80 bytes", "vast.pfm",
                     "numbers in a file so small = 2.14735e+09, allowed up to 1.74");
}

/// OpenEXR would take the memory, and the seconds to clear it, before it found the file's end.
TEST_F(Maps, WhoseHeadersClaimMoreThanTheFileAreRefused) {
  oiiotool("--create 4x2 1 --addc 0.5 -d half --attrib note here -o a.exr");
  const auto whole = text_of(here("a.exr"));
  const auto claim = [&](std::string_view attribute, std::string_view size) {
    auto bytes = whole;
    bytes.replace(whole.find(attribute) + attribute.size(), 4, size);
    file("claim.exr", bytes);
  };
  claim(std::string_view("note\0string\0", 12), "\xFF\xFF\xFF\x7F");
  expect_map_refused("an EXR with a text of 2 GB", "claim.exr", "attribute \"note\" of 2147483647");
  claim(std::string_view("note\0string\0", 12), "\xFF\xFF\xFF\xFF");
  expect_map_refused("an EXR with a text of -1 bytes", "claim.exr", "attribute \"note\" of -1");
  claim(std::string_view("channels\0chlist\0", 16), "\xFF\xFF\xFF\x7F");
  expect_map_refused("an EXR with channels of 2 GB", "claim.exr", "attribute \"channels\"");
  claim(std::string_view("channels\0chlist\0", 16), std::string_view("\x24\0\0\0", 4));
  expect_map_refused("an EXR with 36 bytes of channels", "claim.exr",
                     "attribute \"channels\" of 36");
  claim(std::string_view("dataWindow\0box2i\0", 17), std::string_view("\x0F\0\0\0", 4));
  expect_map_refused("an EXR with a window of 15 bytes", "claim.exr", "\"dataWindow\" of 15");
}

TEST_F(Maps, WhoseTilesClaimMoreThanTheFileAreRefused) {
  oiiotool("--create 32x16 3 --addc 0.5 -d half --tile 64 64 -o a.exr");
  auto bytes = text_of(here("a.exr"));
  // the tile's width, its height behind it
  bytes.replace(bytes.find(std::string_view("tiles\0tiledesc\0", 15)) + 15 + 4 + 4, 4,
                std::string_view("\x40\x00\x28\x00", 4));
  file("claim.exr", bytes);
  expect_map_refused("an EXR with a tile of 2 GB", "claim.exr", "numbers of a tile");
  oiiotool("--create 32x16 3 --addc 0.5 -d uint16 --tile 64 64 -o a.tif");
  bytes = text_of(here("a.tif"));
  for (const auto* tag : {"\x42\x01", "\x43\x01"}) {  // its width, its height
    const auto field = bytes.find(std::string(tag) + std::string("\x03\0\x01\0\0\0\x40", 7));
    ASSERT_NE(field, std::string::npos);
    bytes.replace(field + 8, 2, "\xF0\xFF");
  }
  file("claim.tif", bytes);
  expect_map_refused("a TIFF with a tile of 26 GB", "claim.tif", "cannot be read");
}

TEST_F(Maps, WhoseChunksClaimMoreThanTheFileAreRefused) {
  oiiotool("--create 2x1 1 -d uint8 --attrib note here -o a.png");
  auto bytes = text_of(here("a.png"));
  bytes.replace(bytes.find("IDAT") - 4, 4, "\x6F\0\0\0", 4);
  file("claim.png", bytes);
  expect_map_refused("a PNG with a chunk of 1.8 GB", "claim.png", "chunk IDAT of 1862270976 bytes");
}

TEST_F(Maps, CutShortAreRefused) {
  const Words spotted = "--pattern noise 64x32 3 --clamp:min=0:max=1 -d";
  oiiotool(spotted + "uint8 -o a.png -o a.tif -o a.jpg --compression none -o plain.tif");
  oiiotool(spotted + "half --compression piz -o a.exr");
  for (const std::string name : {"a.png", "a.tif", "plain.tif", "a.jpg", "a.exr"}) {
    const auto whole = text_of(here(name));
    EXPECT_EQ(refusal(name), "");
    for (std::size_t tenths = 1; tenths < 10; ++tenths) {
      file("cut-" + name, whole.substr(0, whole.size() * tenths / 10));
      expect_map_refused(fmt::format("{}/10 of {}", tenths, name), "cut-" + name,
                         "cannot be read: ");
    }
  }
}

TEST_F(Maps, AreBakedOrRefusedInOneLine) {
  const auto baked = [&](const std::filesystem::path& map) {
    return coppermoon(bake(words_of("--albedo-map {} -o moon.exr", map)));
  };
  expect_refused("bake of a map that is cut short", baked(file("a.png", "\x89PNG\r\n\x1a\n")),
                 "a.png: cannot be read");
  expect_refused("bake of a black map", baked(float_map(2, 1, {0, 0})), "mean 0, allowed above 0");
  EXPECT_FALSE(std::filesystem::exists(here("moon.exr")));
  EXPECT_EQ(baked(float_map(2, 1, {1e-38F, 1e-38F})).status, 0);
}

class Recipes : public Untrusted {
 protected:
  Outcome baked_by(const std::string& recipe) const {
    file("a.toml", recipe);
    return coppermoon(bake("--albedo-map built-in --recipe a.toml -o by.exr"));
  }

  /// The recipe makes what its flags make, to the last bit.
  void expect_same(const std::string& what, const std::string& recipe, const Words& flags) const {
    const auto outcome = baked_by(recipe);
    ASSERT_EQ(outcome.status, 0) << what << ": " << outcome.err;
    coppermoon(bake(Words("--albedo-map built-in -o flags.exr") + flags));
    EXPECT_EQ(text_of(here("by.exr")), text_of(here("flags.exr"))) << what;
    tried("recipe: " + what, "the bytes that its flags make");
  }

  void expect_recipe_refused(const std::string& what, const std::string& recipe,
                             const std::string& part, int status = could_not) const {
    expect_refused("recipe: " + what, baked_by(recipe), part, status);
    EXPECT_FALSE(std::filesystem::exists(here("by.exr")));
  }
};

TEST_F(Recipes, ThatTomlAllowsAreTaken) {
  expect_same("empty", "", {});
  expect_same("a byte order mark", "\xEF\xBB\xBFseed = 5\n", "--seed 5");
  expect_same("lines that end as in DOS", "seed = 5\r\nozone-du = 300\r\n",
              "--seed 5 --ozone-du 300");
  expect_same("hexadecimal, and digits apart", "seed = 0x10\nozone-du = 3_0_0.0\n",
              "--seed 16 --ozone-du 300");
  expect_same("a megabyte of comment", "seed = 5\n#" + std::string(1'000'000, 'x') + "\n",
              "--seed 5");
}

TEST_F(Recipes, ThatTomlDoesNotAllowAreRefused) {
  expect_recipe_refused("the same key twice", "seed = 5\nseed = 6\n", "a.toml:2: ");
  expect_recipe_refused("a zero byte", std::string("seed = 5\0\n", 10), "a.toml:1: ");
  expect_recipe_refused("Latin-1", "albedo-map = \"caf\xE9\"\n", "a.toml:1: ");
  expect_recipe_refused("300 lists in lists",
                        "seed = " + std::string(300, '[') + std::string(300, ']'), "a.toml:1: ");
  expect_recipe_refused("a text without end", "albedo-map = \"a\n", "a.toml:1: ");
}

TEST_F(Recipes, ThatMeanNothingAreRefused) {
  expect_recipe_refused("an unknown key", "sead = 5\n", "sead", wrong_usage);
  expect_recipe_refused("an unknown key of 900 kB", std::string(900'000, 'k') + " = 5\n",
                        "the nearest is", wrong_usage);
  expect_recipe_refused("text for a number", "seed = \"five\"\n", "five", wrong_usage);
  expect_recipe_refused("a number for a word", "atmosphere = 5\n", "5", wrong_usage);
  expect_recipe_refused("a list for a number", "ozone-du = [1, 2]\n", "1,2", wrong_usage);
  expect_recipe_refused("a table for a number", "seed = {a = 5}\n", "a.toml:1: seed");
  expect_recipe_refused("no number", "ozone-du = nan\n", "ozone [DU] = nan, allowed 0 to 1000");
  expect_recipe_refused("an infinite number", "ozone-du = -inf\n", "= -inf, allowed 0 to 1000");
  expect_recipe_refused("a zero byte in a text", "albedo-map = \"a\\u0000b\"\n", "zero byte");
  expect_recipe_refused("a zero byte in a key", "\"seed\\u0000\" = 5\n", "nearest is", wrong_usage);
}

TEST_F(Recipes, WithoutEndAreRefused) {
  expect_recipe_refused("10 MB", "seed = 5\n#" + std::string(10'000'000, 'x') + "\n",
                        "more than 1048576 bytes");
  std::string name = "a";
  for (int i = 0; i < 300'000; ++i) name += ".a";
  expect_recipe_refused("a name of 300000 parts", name + " = 5\n", "a name of more than 16 parts");
  expect_recipe_refused("a table of 300000 parts", "['x'" + name.substr(1) + "]\n", "16 parts");
  const auto outcome = coppermoon(bake("--recipe /dev/zero -o by.exr"));
  expect_refused("recipe: /dev/zero", outcome, "/dev/zero: cannot be read: it is no regular file");
}

/// A picture from someone else may not say where this one's results go.
TEST_F(Recipes, InHeadersWriteNowhere) {
  texture::write_exr(here("theirs.exr"), texture::Image(4, 2, {"Y"}),
                     {{"coppermoon:recipe",
                       std::string("output = \"evil.exr\"\nkeep = \"evil.json\"\nhelp = true\n"
                                   "texture-width = 16\nunshadowed = true\nthreads = 1\n"
                                   "albedo-map = \"built-in\"\ninstant = \"2008-02-21\"\n")}});
  const auto nameless = coppermoon("bake theirs.exr");
  expect_refused("header that names an output", nameless, "--output", wrong_usage);
  const auto made = coppermoon("bake theirs.exr -o mine.exr");
  EXPECT_EQ(made.status, 0) << made.err;
  const std::set<std::string> expected{"here/mine.exr", "here/theirs.exr"};
  EXPECT_EQ(listing(), expected);
  tried("header that names files to write", "only -o is written");
}

double tt_days(const std::string& instant) {
  const auto at = almanac::instant_from_utc(instant);
  return at.tt_day + at.tt_fraction;
}

TEST(Instants, OfOneMomentAreOne) {
  const std::vector<Words> alike{
      {"2008-02-21T03:26:00Z", "2008-02-21T03:26Z", "2008-02-21T03:26", "+2008-02-21T03:26:00",
       "2008-02-21T03:26:00.0000000000000000000000"},
      {"2008-02-21", "2008-02-21Z", "2008-02-21T00:00", "20080221", "2008-02-20T24:00:00Z"},
      {"2008-02-21T03:26", "2008-02-21t03:26z", "20080221T0326Z"},
      "-0584-05-22T12:00Z -0584-05-22T12:00:00.000Z"};
  for (const auto& spellings : alike)
    for (const auto& spelling : spellings) {
      EXPECT_EQ(tt_days(spelling), tt_days(spellings[0])) << spelling;
      tried("instant " + spelling, "that of " + spellings[0]);
    }
}

TEST(Instants, AtTheEndsOfTheCalendarAreTaken) {
  for (const std::string instant : {"-1999-01-01T00:00:00.000Z", "3000-12-31T23:59:59.000Z",
                                    "0000-02-29T12:00:00.000Z", "2016-12-31T23:59:60.000Z"}) {
    EXPECT_EQ(almanac::utc_text(almanac::instant_from_utc(instant), 3), instant)
        << "a leap year; a leap second (IERS Bulletin C 52)";
    tried("instant " + instant, "written as it was read");
  }
}

TEST(Instants, ThatAreNoneAreRefused) {
  for (const std::string instant : {"",
                                    "2008-02-30",
                                    "1900-02-29",
                                    "2008-13-01",
                                    "2008-00-10",
                                    "2008-02-00",
                                    "2008-2-21",
                                    "08-02-21",
                                    "12008-02-21",
                                    "2008-02-21T03:60Z",
                                    "2008-02-21T03:26:60Z",
                                    "2015-12-31T23:59:60Z",
                                    "2008-02-21T03:26:05+1:00",
                                    "2008-02-21T03",
                                    "2008-02-21T",
                                    "2008-02-21  03:26",
                                    " 2008-02-21",
                                    "2008-02-21 ",
                                    "2008-02-21T03:26:05.Z",
                                    "2008-02-21T03:26:05ZZ",
                                    "3001-01-01",
                                    "tomorrow",
                                    "nan",
                                    "\xEF\xBC\x92\xEF\xBC\x90",
                                    "2008-02-21\n",
                                    "-2000-01-01"}) {
    EXPECT_THROW(almanac::instant_from_utc(instant), algebra::Error) << instant;
    refused("an instant", instant.substr(0, instant.find('\n')));
  }
}

class InstantsTold : public Untrusted {};

TEST_F(InstantsTold, AreRefusedInOneLine) {
  const std::string reason = "allowed is an ISO 8601 date of the years -1999 to 3000";
  expect_refused("sky of a date of two lines", coppermoon({"sky", "2008-02-21\n"}), reason);
  expect_refused("sky of a date of 100 kB", coppermoon({"sky", std::string(100'000, '2')}), reason);
}

class Sums : public Untrusted {
 protected:
  /// A shadow of few photons.
  Outcome shadow(const Words& more) const {
    return coppermoon(
        Words("shadow --moon-distance-km 380000 --sun-distance-km 1.5e8 --solver photons --photons "
              "20480 --ring-km 1000 --rays 50 --wavelengths 450,650") +
        more);
  }

  void expect_sums_refused(const std::string& what, const Words& flags, const char* part) const {
    const auto before = listing();
    expect_refused("photons' sums: " + what, shadow(flags), part);
    EXPECT_EQ(listing(), before);
  }

  void SetUp() override {
    ASSERT_EQ(shadow("--shard 1/2 --keep one").status, 0);
    ASSERT_EQ(shadow("--shard 2/2 --keep two").status, 0);
  }

  std::string with(const char* name, const nlohmann::json& value) const {
    auto all = nlohmann::json::parse(text_of(here("one")));
    all[name] = value;
    return all.dump();
  }
};

TEST_F(Sums, OfAllPartsAreTheWhole) {
  const auto together = shadow("--add one --add two"), whole = shadow({});
  ASSERT_EQ(together.status, 0) << together.err;
  EXPECT_EQ(together.out, whole.out) << "six digits are printed, sums differ by rounding";
  tried("photons' sums: two shards", "what one run prints");
}

TEST_F(Sums, CutShortAreRefused) {
  const auto whole = text_of(here("one"));
  for (std::size_t tenths = 0; tenths < 10; ++tenths) {
    file("cut", whole.substr(0, whole.size() * tenths / 10));
    EXPECT_THROW(uses::read_sums(here("cut")), algebra::Error) << tenths;
    tried(fmt::format("photons' sums: {}/10 of a file", tenths), "refused");
  }
}

TEST_F(Sums, OfAnotherKindAreRefused) {
  file("other", with("version", 2));
  expect_sums_refused("another version", "--add other", "version = 2, allowed 1");
  file("other", with("wavelengths_nm", {450, 651}));
  expect_sums_refused("other wavelengths", "--add other", "photons of different");
  file("other", with("kind", "recipe"));
  expect_sums_refused("another kind", "--add other", "other: these are no photons' sums");
  file("other", with("rings", 999'999));
  expect_sums_refused("more rings than cells", "--add other", "cells");
  file("other", std::string(1'000'000, '['));
  expect_sums_refused("a million lists in lists", "--add other", "other: no JSON");
  expect_sums_refused("nothing", {"--add", file("empty", "").string()}, "empty: no JSON at byte");
  expect_sums_refused("the same shard twice", "--add one --add one", "are in both");
  expect_sums_refused("a folder", "--add .", ".: ");
}

/// Magnitudes that someone wrote down.
class Magnitudes : public Untrusted {
 protected:
  void expect_list_refused(const std::string& what, const std::string& path,
                           const std::string& part) const {
    expect_refused("magnitudes: " + what, coppermoon({"fit", "--magnitudes", path}), part);
  }
};

TEST_F(Magnitudes, ThatAreNoneAreRefused) {
  const std::string names = "instant,band,magnitude\n", eclipsed = "2018-07-27T20:40:00Z,V,";
  for (const auto& [what, text, part] : std::vector<std::array<std::string, 3>>{
           {"no number", names + eclipsed + "nan\n", "a.csv:2: magnitude = nan, allowed -30 to 30"},
           {"an infinite one", names + eclipsed + "-inf\n", "magnitude = -inf"},
           {"text", names + eclipsed + "faint\n", "magnitude = faint, allowed a number"},
           {"none", names, "holds no magnitudes"},
           {"nothing", "", "holds no magnitudes"},
           {"a zero byte", names + eclipsed + std::string("\0", 1), "a.csv:2: magnitude = "},
           {"quotes", names + "\"2018-07-27T20:40:00Z\",V,1\n", "a.csv:2: date"},
           {"Latin-1", names + "2018-07-27T20:40:00Z,\xe9,1\n", "a.csv:2: band = "},
           {"2 MB", std::string(2 << 20, '#'), "a list of more than 1048576 bytes"}}) {
    file("a.csv", text);
    expect_list_refused(what, "a.csv", part);
  }
  expect_list_refused("/dev/zero", "/dev/zero", "it is no regular file");
  expect_list_refused("a folder", ".", ".: cannot be read");
}

/// Photographs that are to be merged.
class Photographs : public Untrusted {};

TEST_F(Photographs, ThatDoNotGoTogetherAreRefused) {
  const texture::ExrOptions floats{.type = texture::ExrType::floating};
  const auto photograph = [&](const std::string& name, std::size_t width,
                              const std::vector<std::string>& channels, float time_s = 1) {
    texture::write_exr(here(name), texture::Image(width, 2, channels),
                       {{"expTime", time_s}, {"aperture", 8.F}}, floats);
  };
  const std::vector<std::string> four{"R", "G", "B", "valid"};
  photograph("a.exr", 4, four);
  photograph("wide.exr", 5, four);
  photograph("endless.exr", 4, four, INFINITY);
  photograph("three.exr", 4, {"R", "G", "B"});
  const auto merged = [&](const char* name) {
    return coppermoon(words_of("merge a.exr {} -o b.exr", name));
  };
  expect_refused("merge: another size", merged("wide.exr"), "5 x 2 pixels, allowed 4 x 2");
  expect_refused("merge: without valid", merged("three.exr"),
                 "channels R, G, B, allowed R, G, B, valid");
  expect_refused("merge: an infinite exposure time", merged("endless.exr"),
                 "exposure time [s] = inf, allowed");
  expect_refused("merge: a folder", merged("."), ".: cannot be read");
  EXPECT_FALSE(std::filesystem::exists(here("b.exr")));
}

}  // namespace coppermoon::extremes::inputs_test
