// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "support/program.h"
#include "texture/read_image.h"

namespace coppermoon::end_to_end::dome_test {

using nlohmann::json;

const Words totality = "dome 2018-07-27T20:22Z --at Nairobi --quality draft";

class DomeFile : public ProgramTest {
 protected:
  json dome(const Words& more, const std::string& file = "sky.exr") const {
    return json_of(totality + more + Words{"-o", file});
  }

  texture::Image light(const std::string& file = "sky.exr") const {
    return texture::read_image(here(file));
  }

  std::string said(const char* name) const {
    return texture::read_attribute(here("sky.exr"), name).value_or("");
  }
};

TEST_F(DomeFile, SaysInItsHeaderWhatItIs) {
  const auto figures = dome("--width 64 --moon on");
  const auto image = light();
  EXPECT_EQ(image.width, 64u);
  EXPECT_EQ(image.height, 32u);
  EXPECT_EQ(image.channels, (Words("R G B")));
  EXPECT_EQ(said("colorInteropID"), "lin_rec709_scene");
  EXPECT_EQ(said("coppermoon:unit"), "cd/m^2");
  EXPECT_EQ(said("coppermoon:moon"), "on");
  EXPECT_SAYS(said("coppermoon:projection"), "north in the middle column");
  for (const char* name :
       {"zenith_luminance_cd_m2", "sky_illuminance_lx", "sun_geometric_altitude_deg"})
    EXPECT_WITHIN_RELATIVE(std::stod(said((std::string("coppermoon:") + name).c_str())),
                           figures[name].get<double>(), 1e-5, "a header's float, to six digits");
}

TEST_F(DomeFile, IsMadeAgainFromItsOwnRecipe) {
  dome("--width 64 --ground-albedo 0.3 --stars 3 --observer-aerosol 0.2");
  expect_done(coppermoon("dome --recipe sky.exr -o again.exr"));
  EXPECT_EQ(light().values, light("again.exr").values);
}

TEST_F(DomeFile, HasTheBrightStarsOfTheSkyInTheirTexels) {
  const auto listed = coppermoon(words_of("sky {} --at Nairobi --stars 1.5 --json", totality[1]));
  expect_done(listed);
  dome("--stars 1.5 --width 1024 --type float");
  dome("--stars off --width 1024 --type float", "none.exr");
  const auto with = light(), without = light("none.exr");
  std::size_t seen = 0;
  const auto sky = json::parse(listed.out);
  for (const auto& star : sky["stars"]) {
    const double altitude = star["altitude_deg"], azimuth = star["azimuth_deg"];
    if (altitude < 5 || altitude > 80)
      continue;  // low and in the zenith a light spreads over other texels
    ++seen;
    // from the top by 180 degrees over 512 rows; north in the middle, east to the right
    const double y = (90 - altitude) * 512 / 180, x = std::fmod(azimuth + 180, 360) * 1024 / 360;
    double lux = 0, at_x = 0, at_y = 0;
    for (int down = -2; down <= 2; ++down)
      for (int right = -2; right <= 2; ++right) {
        const auto r = static_cast<std::size_t>(std::floor(y) + down),
                   c = static_cast<std::size_t>(std::floor(x) + right + 1024) % 1024;
        const double step = std::numbers::pi / 512,
                     solid =
                         step * step * std::cos(std::numbers::pi / 2 - (double(r) + 0.5) * step);
        const double light = (double{with(r, c, 1)} - without(r, c, 1)) * solid;
        lux += light;
        at_y += light * (double(r) + 0.5 - y);
        at_x += light * (std::floor(x) + right + 0.5 - x);
      }
    double expected = 0;  // of both stars of alpha Centauri
    for (const auto& other : sky["stars"])
      if (std::hypot(other["altitude_deg"].get<double>() - altitude,
                     other["azimuth_deg"].get<double>() - azimuth) < 0.02)
        expected += other["illuminance_lux"][1].get<double>();
    EXPECT_WITHIN_RELATIVE(lux, expected, 1e-3,
                           "floats of stars on a sky; texels' solid angles at their middles");
    EXPECT_WITHIN(at_x / lux, 0, 0.01, "of a texel: its light is spread by its place");
    EXPECT_WITHIN(at_y / lux, 0, 0.01, "of a texel");
  }
  EXPECT_GE(seen, 8u);
}

TEST_F(DomeFile, IsThatOfAnyOtherNightToo) {
  const auto outcome =
      coppermoon("dome 2018-08-11T20:00Z --at Nairobi --width 16 -o sky.exr --json");
  expect_done(outcome);
  const auto new_moon = json::parse(outcome.out);
  EXPECT_LT(new_moon["moon_altitude_deg"].get<double>(), 0) << "a new Moon at 23 h";
  EXPECT_EQ(new_moon["moon_illuminance_lx"], 0);
}

TEST_F(DomeFile, IsRefusedInOneLine) {
  for (const auto& [words, part] :
       {std::pair{words_of("dome {} -o sky.exr", totality[1]), "--at"},
        {totality + "-o sky.png", ".exr"},
        {totality + "-o sky.exr --width 18", "multiples of 4"},
        {totality + "-o sky_acescg.exr --space lin_rec709", "acescg"}}) {
    const auto outcome = coppermoon(words);
    EXPECT_NE(outcome.status, 0);
    EXPECT_SAYS(outcome.err, part);
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1);
    EXPECT_TRUE(std::filesystem::is_empty(here()));
  }
}

}  // namespace coppermoon::end_to_end::dome_test
