// SPDX-License-Identifier: MIT
// What commands write, and what they take for granted when little is said.
#include <nlohmann/json.hpp>

#include "colour/working_space.h"
#include "files/memory.h"
#include "support/csv_rows.h"
#include "support/program.h"
#include "texture/read_image.h"
#include "texture/write_image.h"

namespace coppermoon::end_to_end::outputs_test {

using nlohmann::json;

const std::string middle = "2018-07-27T20:21:45Z";

class Outputs : public ProgramTest {
 protected:
  std::string done(const Words& words) const {
    const auto outcome = coppermoon(words);
    expect_done(outcome);
    return outcome.out;
  }
  /// A frame of one grey.
  void frame(const std::string& name, float luminance,
             const texture::Attributes& attributes = {}) const {
    texture::Image image(8, 4, {"R", "G", "B"});
    std::ranges::fill(image.values, luminance);
    texture::write_exr(here(name), image, attributes);
  }
};

TEST_F(Outputs, OfTheShadowGoIntoFilesByTheirEnding) {
  const auto shadow = words_of("shadow {} --rays 50 --axis-distances 0,3000,9000", middle);
  const auto printed = done(shadow), document = done(shadow + Words{"--json"});
  const auto said = done(shadow + "-o a.csv -o a.json -o a.svg");
  EXPECT_EQ(said,
            "a.csv: 3 distances to 9000 km, 3 wavelengths\n"
            "a.json: 3 distances to 9000 km, 3 wavelengths\n"
            "a.svg: 3 distances to 9000 km, 3 wavelengths\n");
  EXPECT_EQ(text_of(here("a.csv")), printed);
  EXPECT_EQ(json::parse(text_of(here("a.json")))["irradiance_ratio"],
            json::parse(document)["irradiance_ratio"]);
  const auto rows = csv_rows(printed);
  const auto ratios = json::parse(document)["irradiance_ratio"];
  ASSERT_EQ(rows.size(), ratios.size());
  for (std::size_t d = 0; d < rows.size(); ++d)
    EXPECT_WITHIN_RELATIVE(std::stod(rows[d].at("irradiance_ratio_450nm")),
                           ratios[d][0].get<double>(), 1e-5, "six digits");
  const auto plot = text_of(here("a.svg"));
  for (const char* text : {"2018-07-27 20:21:45 UTC", "406098 km from the Earth", "standard air",
                           "edge of the umbra", "edge of the penumbra", "Moon", "450 nm"})
    EXPECT_SAYS(plot, text);
  expect_refused(shadow + "-o a.xls",
                 "ends in .csv (numbers), .json (numbers), .png (plot), .svg (plot), .pdf (plot)");
}

TEST_F(Outputs, OfARingAreOneDocument) {
  const auto all =
      json::parse(done(words_of("ring {} --atmosphere undated -o a.exr --json", middle)));
  EXPECT_EQ(all["file"], "a.exr");
  EXPECT_WITHIN(all["earth_distance_km"].get<double>(), 406098 - 1737, 10,
                "the Moon's depth in the shadow, which is its distance to 1e-5, and its radius");
}

TEST_F(Outputs, OfBrightnessAreThoseOfAPlaceToo) {
  const auto of = [&](const Words& more) {
    return json::parse(
        done(words_of("brightness {} --unshadowed --texture-width 64 --albedo-map built-in --json",
                      middle) +
             more));
  };
  const auto seen = of("--at -21.1,15"), low = of("--at 36,18"),
             space = of("--at 36,18 --reddening off");
  const double altitude_deg = seen["seen"]["altitude_deg"],
               air_mass = 1 / std::sin(altitude_deg * std::numbers::pi / 180);
  EXPECT_GT(altitude_deg, 40);
  const auto lost = [](const json& all, const char* band) {
    return all["seen"]["extinction_mag"][band].get<double>();
  };
  EXPECT_WITHIN(lost(seen, "V") / air_mass, 0.23, 0.06, "at sea level 0.2 to 0.28 in textbooks");
  EXPECT_WITHIN(lost(seen, "B") / air_mass, 0.36, 0.08, "at sea level 0.3 to 0.42");
  EXPECT_GT(low["seen"]["reddening_b_v"], seen["seen"]["reddening_b_v"]) << "through more air";
  EXPECT_EQ(lost(space, "V"), 0);
  EXPECT_WITHIN(space["seen"]["magnitudes"]["V"].get<double>(),
                seen["magnitudes"]["V"].get<double>(), 0.036,
                "nearer by an Earth's radius of 406 000 km at most");
}

TEST_F(Outputs, OfBakeAreReddenedByTheAirOfAPlace) {
  const auto bake = [&](const std::string& name, const Words& more) {
    done(
        words_of(
            "bake {} --rays 50 --atmosphere undated --albedo-map built-in --texture-width 32 -o {}",
            middle, name) +
        more);
    return texture::read_image(here(name));
  };
  const auto above = bake("above.exr", {}), red = bake("red.exr", "--at -21.1,15"),
             space = bake("space.exr", "--at -21.1,15 --reddening off");
  EXPECT_EQ(space.values, above.values);
  double sums[2][3] = {};
  for (std::size_t i = 0; i < red.values.size(); ++i)
    sums[0][i % 3] += above.values[i], sums[1][i % 3] += red.values[i];
  EXPECT_LT(sums[1][0] / sums[0][0], 0.95);
  EXPECT_LT(sums[1][1] / sums[0][1], sums[1][0] / sums[0][0]);
  done("bake red.exr -o again.exr");
  EXPECT_EQ(text_of(here("again.exr")), text_of(here("red.exr")));
}

TEST_F(Outputs, OfDevelopShareOneExposure) {
  frame("a.exr", 100), frame("b.exr", 1), frame("c.exr", 0);
  const auto set = json::parse(done("develop a.exr b.exr c.exr -o set/ --json")),
             alone = json::parse(done("develop a.exr -o a.png --json"));
  EXPECT_EQ(set["files"], (Words("set/a.png set/b.png set/c.png")));
  EXPECT_WITHIN_RELATIVE(set["white_cd_m2"][0].get<double>(), alone["white_cd_m2"][0].get<double>(),
                         5e-4,
                         "the brightest hundredth is the first frame's; counted in steps of 2^-11");
  const auto of_set = texture::read_image(here("set/a.png")),
             of_one = texture::read_image(here("a.png"));
  ASSERT_EQ(of_set.values.size(), of_one.values.size());
  for (std::size_t i = 0; i < of_one.values.size(); ++i)
    EXPECT_WITHIN(of_set.values[i], of_one.values[i], 1.01 / 255,
                  "where the two times lie on two sides of a dithered step: one step");
  std::filesystem::create_directory(here("other"));
  frame("other/a.exr", 1);
  expect_refused("develop a.exr other/a.exr -o set", "would become one picture");
  expect_refused("develop a.exr b.exr -o ab.png", "ab.png");
  expect_refused("develop a.exr -o a.gif",
                 "a.gif: a picture ends in .png, .jpg (8 bits, without its recipe), .avif (high "
                 "dynamic range)");
  done("develop a.exr -o a.jpg");
  const auto as_jpeg = texture::read_image(here("a.jpg"));
  for (std::size_t i = 0; i < of_one.values.size(); ++i)
    EXPECT_WITHIN(as_jpeg.values[i], of_one.values[i], 2.01 / 255, "of quality 95, and dither");
}

TEST_F(Outputs, ThatTakeMoreMemoryThanThereIsAreRefusedAtOnce) {
  if (files::available_memory() > 3e11) GTEST_SKIP() << "there is as much";
  expect_refused(words_of("still {} --width 65535 --height 65535 -o a.png", middle),
                 "a.png: takes 322.1 GB of memory, allowed the ");
}

TEST_F(Outputs, OfAFullDiskReplaceNothing) {
  file("p.png", "old");
  const auto outcome = coppermoon(words_of("shadow {} --atmosphere paper -o p.png", middle),
                                  {.file_limit = 20 << 10});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err,
            "coppermoon: gnuplot: its file is cut off after 20480 bytes; is the disk full?\n");
  EXPECT_EQ(text_of(here("p.png")), "old");
}

TEST_F(Outputs, OfStillHoldTheirFrameInTheSpaceAskedFor) {
  const auto still = [&](const std::string& name, const std::string& space) {
    done(
        words_of("still {} --unshadowed --albedo-map built-in --width 30 --height 50 --space {} "
                 "--frame {} -o {}",
                 middle, space, name + ".exr", name + ".png"));
    EXPECT_EQ(texture::read_attribute(here(name + ".exr"), "coppermoon:colour_space"), space);
    done({"develop", name + ".exr", "-o", name + "_again.png"});
    return texture::read_image(here(name + "_again.png"));
  };
  const auto rec709 = still("a", "lin_rec709"), aces = still("b", "acescg"),
             xyz = still("c", "lin_ciexyzd65_scene");
  for (std::size_t i = 0; i < rec709.values.size(); ++i) {
    ASSERT_NEAR(aces.values[i], rec709.values[i], 1.5 / 255) << "frames of half floats";
    ASSERT_NEAR(xyz.values[i], rec709.values[i], 1.5 / 255);
  }
}

}  // namespace coppermoon::end_to_end::outputs_test
