// SPDX-License-Identifier: MIT
// A Moon of one grey, fully lit: its luminance and what a camera makes of it are known without any
// of our code.
#include "end_to_end/luminance.h"
#include "support/program.h"
#include "texture/read_image.h"
#include "texture/write_image.h"

namespace coppermoon::end_to_end::exposure_test {

using std::numbers::pi;

constexpr const char* mid_eclipse = "2008-02-21T03:26:05Z";
constexpr double time_s = 1. / 500, f_number = 11, iso = 100;

double luminance_in_the_middle(const texture::Image& image) {
  double sum = 0;
  for (std::size_t r = image.height / 2 - 2; r < image.height / 2 + 2; ++r)
    for (std::size_t c = image.width / 2 - 2; c < image.width / 2 + 2; ++c)
      sum += luminance(image, r, c) / 16;
  return sum;
}

/// Sunlight on grey ground is brightest in red.
double red_in_the_middle(const texture::Image& image) {
  return image(image.height / 2, image.width / 2, 0);
}

/// IEC 61966-2-1, backwards.
float linear(float coded) {
  return coded <= 0.04045F ? coded / 12.92F : std::pow((coded + 0.055F) / 1.055F, 2.4F);
}

/// L = p / f_mean · E_v / π · (1 au / d)²: the full Moon's mean is p, the middle of its disc (f =
/// 1) is brighter than that by 1 / 0.92737, the photometric function's mean over the disc.
double full_moon_luminance() {
  constexpr double geometric_albedo = 0.12, disc_mean = 0.92737;
  constexpr double illuminance_lx =
      133.33e3;  // at 1 au: Darula, Kittler & Gueymard (2005), Solar Energy 79, 559
  constexpr double sun_au = 0.98879, moon_au = 383740. / 149597871, radius_au = 1737. / 149597871;
  const double distance_au =
      sun_au + moon_au - radius_au;  // Sun, Earth, the Moon's near side: all in a row
  return geometric_albedo / disc_mean * illuminance_lx / pi / (distance_au * distance_au);
}

class Exposure : public ProgramTest {
 protected:
  Exposure() {
    texture::Image map(32, 16, {"Y"});
    for (float& value : map.values) value = 0.5F;
    texture::write_exr(here("grey.exr"), map, {});
  }

  static Words with_grey_moon(const Words& words) {
    return Words{words[0], mid_eclipse} +
           "--unshadowed --albedo-map grey.exr --texture-width 64 --photometry yapo-cutler" +
           Words(words.begin() + 1, words.end());
  }

  /// The texture, made once for all tests.
  texture::Image baked() const {
    static const auto moon = [this] {
      expect_done(coppermoon(with_grey_moon("bake -o moon.exr")));
      return texture::read_image(here("moon.exr"));
    }();
    return moon;
  }

  /// The frame, seen from the Earth's centre, and its picture in a view; once for all tests of a view.
  texture::Image picture(const std::string& view) const {
    static std::map<std::string, std::pair<std::string, texture::Image>> made;
    if (!made.contains(view)) made[view] = rendered(view);
    const auto& [frame, picture] = made[view];
    file("frame.exr", frame);
    return picture;
  }

 private:
  std::pair<std::string, texture::Image> rendered(const std::string& view) const {
    expect_done(coppermoon(with_grey_moon(words_of(
        "still --width 64 --height 64 --field 0.6 --frame frame.exr -o picture.png --bits 16 "
        "--view {} --time {} --f-number {} --iso {}",
        view, time_s, f_number, iso))));
    return {text_of(here("frame.exr")), texture::read_image(here("picture.png"))};
  }
};

TEST_F(Exposure, TheTextureHasTheLuminanceOfTheFullMoon) {
  EXPECT_WITHIN_RELATIVE(luminance_in_the_middle(baked()), full_moon_luminance(), 0.01,
                         "spectra of the Sun differ by that in luminance");
}

TEST_F(Exposure, TheFrameHasTheLuminanceOfTheTexture) {
  picture("Raw");
  EXPECT_WITHIN_RELATIVE(
      luminance_in_the_middle(texture::read_image(here("frame.exr"))),
      luminance_in_the_middle(baked()), 0.002,
      "half floats, twice, 5e-4 each; f falls by 2e-4 over the pixels in the middle");
}

TEST_F(Exposure, TheRawPictureIsTheExposureFormula) {
  const auto shown = picture("Raw");
  const double frame = luminance_in_the_middle(texture::read_image(here("frame.exr")));
  const double q = 0.65, expected = q * frame * time_s * iso / (78 * f_number * f_number);
  ASSERT_LT(expected, 0.9);
  ASSERT_GT(expected, 0.02);
  EXPECT_WITHIN_RELATIVE(luminance_in_the_middle(shown), expected, 0.01,
                         "asked for; 16 bits have steps of 2e-5");
}

TEST_F(Exposure, ThePictureWithoutToneMappingIsTheSameBehindSrgb) {
  auto shown = picture("Un-tone-mapped");
  for (float& value : shown.values) value = linear(value);
  const double frame = luminance_in_the_middle(texture::read_image(here("frame.exr")));
  const double q = 0.65, expected = q * frame * time_s * iso / (78 * f_number * f_number);
  EXPECT_WITHIN_RELATIVE(luminance_in_the_middle(shown), expected, 0.01,
                         "asked for; 16 bits have steps of 2e-5");
}

TEST_F(Exposure, ALongerExposureDevelopsBrighterAlike) {
  picture("Raw");
  const auto developed = [&](const char* time, const char* name) {
    expect_done(coppermoon(
        words_of("develop frame.exr -o {} --view Raw --bits 16 --time {} --f-number 11 --iso 100",
                 name, time)));
    return luminance_in_the_middle(texture::read_image(here(name)));
  };
  EXPECT_WITHIN_RELATIVE(developed("0.004", "longer.png"), 4 * developed("0.001", "shorter.png"),
                         0.002, "16 bits have steps of 2e-5 in 0.04");
}

TEST_F(Exposure, WithoutATimeTheBrightestComesToFourFifths) {
  picture("Raw");
  expect_done(coppermoon("develop frame.exr -o auto.png --view Raw --bits 16"));
  EXPECT_WITHIN(red_in_the_middle(texture::read_image(here("auto.png"))), 0.8, 0.01,
                "the middle of a full Moon is among its brightest, but for the half floats");
}

TEST_F(Exposure, OfAnotherProgramsSceneIsACamerasWhereOneIsMeant) {
  texture::Image land(8, 8, {"R", "G", "B"});
  for (float& value : land.values) value = 1e-3F;
  texture::write_exr(here("land.exr"), land, {});
  const auto made = [&](const Words& more) {
    return coppermoon(Words("develop land.exr -o land.png") + more).out;
  };
  EXPECT_EQ(made({}), "land.png: white is 0.00125 cd/m²\n") << "80 % of it are 0.001";
  for (const char* name : {"expTime", "aperture", "isoSpeed"})
    EXPECT_FALSE(texture::read_attribute(here("land.png"), name)) << name;
  EXPECT_TRUE(made({"--json"}).find("time_s") == std::string::npos);
  EXPECT_EQ(made("--time 2"), "land.png: exposed for 2 s, f/12.1, ISO 800\n");
  EXPECT_EQ(texture::read_attribute(here("land.png"), "expTime"), "2");
}

}  // namespace coppermoon::end_to_end::exposure_test
