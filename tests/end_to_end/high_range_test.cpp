// SPDX-License-Identifier: MIT
// Pictures of high dynamic range, read back by another program.
#include <fmt/format.h>

#include "colour/exposure.h"
#include "support/program.h"
#include "texture/read_image.h"
#include "uses/picture/disc_outline.h"
#include "uses/picture/picture_files.h"

namespace coppermoon::end_to_end::high_range_test {

const Words moon = "--atmosphere undated --albedo-map built-in --width 180 --height 120";
constexpr double time_s = 0.05;

/// A partial eclipse as it is, and as the picture has it, [cd/m²] of the display.
class MadeStill : public ProgramFolder {
 public:
  MadeStill() {
    expect_done(coppermoon(
        Words("still 2018-07-27T18:44:28Z --at Nairobi --time 0.05 --frame f.exr -o a.avif") +
        moon));
    const auto read = run("avifdec --depth 16 a.avif a.png");
    EXPECT_EQ(read.status, 0) << read.out << read.err;
  }
};

class HighRange : public ProgramTest {
 protected:
  /// Once for all tests.
  void make() const {
    static const MadeStill made;
    std::filesystem::copy(made.here(), here(), std::filesystem::copy_options::recursive);
  }
};

/// Rec.2020's luminance of linear Rec.709, and of Rec.2020 itself (ITU-R BT.709, BT.2020).
double luminance_709(double r, double g, double b) { return 0.2126 * r + 0.7152 * g + 0.0722 * b; }
double luminance_2020(double r, double g, double b) { return 0.2627 * r + 0.6780 * g + 0.0593 * b; }

TEST_F(HighRange, LightComesBackFromTheFile) {
  make();
  const auto frame = texture::read_image(here("f.exr")),
             picture = texture::read_image(here("a.png"));
  const auto outline = uses::outline_in(
      texture::read_attribute(here("f.exr"), "coppermoon:disc_outline").value_or(""));
  ASSERT_TRUE(outline);
  const double scale =
      100 * colour::exposure_scale({time_s, 12.1, 800});  // 1 of the view is 100 cd/m²
  std::vector<double> off;
  double brightest = 0, sum = 0;
  for (std::size_t r = 0; r < frame.height; ++r)
    for (std::size_t c = 0; c < frame.width; ++c) {
      if (uses::covered_share(*outline, static_cast<double>(c) + 0.5,
                              static_cast<double>(r) + 0.5) < 1)
        continue;
      const double expected = scale * luminance_709(frame(r, c, 0), frame(r, c, 1), frame(r, c, 2));
      const auto light = [&](std::size_t k) { return 1e4 * uses::light_of_pq(picture(r, c, k)); };
      const double found = luminance_2020(light(0), light(1), light(2));
      if (expected < 0.1) continue;
      off.push_back(std::abs(found / expected - 1));
      sum += found / expected - 1;
      brightest = std::max(brightest, found);
    }
  ASSERT_GT(off.size(), 3000U);
  std::ranges::sort(off);
  EXPECT_LT(off[off.size() * 95 / 100], 0.02) << "12 bits of PQ: 0.6 %; the encoder's loss";
  EXPECT_WITHIN(sum / static_cast<double>(off.size()), 0, 0.005, "loss has no direction");
  EXPECT_GT(brightest, 300) << "what saturates a sensor is not clipped";
}

TEST_F(HighRange, IsSaidInTheFile) {
  make();
  const auto info = run("avifdec --info a.avif").out;
  for (const char* line : {"Bit Depth      : 12", "Color Primaries: 9", "Transfer Char. : 16",
                           "Matrix Coeffs. : 9", "Range          : Full"})
    EXPECT_SAYS(info, line) << line << "\n" << info;
}

TEST_F(HighRange, HoldsNoRecipeForItsFrameDoes) {
  make();
  expect_done(coppermoon("still f.exr -o again.avif"));
  EXPECT_TRUE(text_of(here("again.avif")) == text_of(here("a.avif")));
  EXPECT_SAYS_NOT(text_of(here("a.avif")), "coppermoon");
  EXPECT_EQ(coppermoon("still a.avif -o no.png").status, 1);
}

const Words film = Words(
                       "animate 2018-07-27 --at Nairobi --from U1+20min --to U1+30min --frames 2 "
                       "--time 0.05 --make frames,pictures --hdr --movie a.mp4 -o film") +
                   moon;

class MadeFilm : public ProgramFolder {
 public:
  MadeFilm() { expect_done(coppermoon(film)); }
};

class HighRangeFilm : public ProgramTest {
 protected:
  /// Once for all tests.
  void make() const {
    static const MadeFilm made;
    std::filesystem::copy(made.here(), here(), std::filesystem::copy_options::recursive);
  }
};

/// Luminance of a coded picture [cd/m²].
double luminance_of(const texture::Image& coded, std::size_t r, std::size_t c) {
  const auto light = [&](std::size_t k) { return 1e4 * uses::light_of_pq(coded(r, c, k)); };
  return luminance_2020(light(0), light(1), light(2));
}

TEST_F(HighRangeFilm, LightComesBackFromIt) {
  make();
  const auto read = run({"ffmpeg", "-v", "error", "-i", "a.mp4", "-vf",
                         "select=eq(n\\,1),scale=in_color_matrix=bt2020:flags=accurate_rnd+"
                         "full_chroma_int+full_chroma_inp,format=rgb48be",
                         "-frames:v", "1", "a.png"});
  ASSERT_EQ(read.status, 0) << read.err;
  const auto frame = texture::read_image(here("film/frame_lin_rec709.0002.exr")),
             picture = texture::read_image(here("a.png"));
  ASSERT_EQ(picture.width, frame.width);
  const double scale = 100 * colour::exposure_scale({time_s, 12.1, 800});
  constexpr std::size_t side = 4;
  std::vector<double> off;
  double brightest = 0;
  for (std::size_t top = 0; top + side <= frame.height; top += side)
    for (std::size_t left = 0; left + side <= frame.width; left += side) {
      double least = 1e9, most = 0, expected = 0, found = 0;
      for (std::size_t r = top; r < top + side; ++r)
        for (std::size_t c = left; c < left + side; ++c) {
          const double light =
              scale * luminance_709(frame(r, c, 0), frame(r, c, 1), frame(r, c, 2));
          least = std::min(least, light), most = std::max(most, light);
          expected += light, found += luminance_of(picture, r, c);
        }
      if (least < 1 || most > 1.5 * least) continue;  // dark, or not even
      off.push_back(std::abs(found / expected - 1));
      brightest = std::max(brightest, found / (side * side));
    }
  ASSERT_GT(off.size(), 80U);
  std::ranges::sort(off);
  EXPECT_LT(off[off.size() * 95 / 100], 0.02)
      << "10 bits of PQ: 0.2 % over 16 pixels; the encoder's loss: 1.2 % found";
  EXPECT_GT(brightest, 300) << "what saturates a sensor is not clipped";
}

TEST_F(HighRangeFilm, SaysWhatItHolds) {
  make();
  double brightest = 0, brightest_mean = 0;
  for (const char* name : {"film/frame_hdr.0001.png", "film/frame_hdr.0002.png"}) {
    const auto picture = texture::read_image(here(name));
    double sum = 0;
    for (std::size_t i = 0; i < picture.values.size(); i += 3) {
      const double light =
          1e4 * uses::light_of_pq(
                    std::max({picture.values[i], picture.values[i + 1], picture.values[i + 2]}));
      brightest = std::max(brightest, light);
      sum += light;
    }
    brightest_mean = std::max(brightest_mean, sum / static_cast<double>(picture.values.size() / 3));
  }
  const auto said =
      run("ffprobe -v error -show_streams -show_frames -read_intervals %+#1 a.mp4").out;
  for (const auto& line :
       {std::string("codec_name=hevc"), std::string("codec_tag_string=hvc1"),
        std::string("profile=Main 10"), std::string("pix_fmt=yuv420p10le"),
        std::string("color_range=tv"), std::string("color_space=bt2020nc"),
        std::string("color_primaries=bt2020"), std::string("color_transfer=smpte2084"),
        std::string("red_x=35400/50000"), std::string("nb_frames=2"),
        fmt::format("max_luminance={:.0f}/10000", 1e4 * std::ceil(brightest)),
        fmt::format("max_content={:.0f}", std::ceil(brightest)),
        fmt::format("max_average={:.0f}", std::ceil(brightest_mean))})
    EXPECT_SAYS(said, line + "\n") << line << "\n" << said;
  const std::string as_box_says("colrnclx\0\x09\0\x10\0\x09\0", 15);  // ITU-T H.273
  EXPECT_SAYS(text_of(here("a.mp4")), as_box_says);

  // pictures of the usual range are what they are without; the film goes on with or without
  const auto picture = text_of(here("film/frame.0001.png"));
  const auto kept = coppermoon(film);
  EXPECT_SAYS(kept.out, "0 frames made, 2 kept");
  std::filesystem::remove(here("film/frame_hdr.0001.png"));
  const auto other = coppermoon(film);
  EXPECT_SAYS(other.out, "0 frames made, 1 developed again from kept linear frames, 1 kept");
  EXPECT_EQ(text_of(here("film/frame.0001.png")), picture);
}

TEST_F(HighRangeFilm, WithoutPicturesOrInAViewThatIsNotIsRefused) {
  EXPECT_EQ(coppermoon(Words("animate 2018-07-27 --make frames --hdr -o film")).err,
            "coppermoon: --hdr is of pictures, allowed with pictures among --make\n");
  EXPECT_SAYS(coppermoon(film + "--view Dreamy").err, "view = Dreamy, allowed");
  EXPECT_EQ(listing(), std::set<std::string>{});
}

TEST_F(HighRange, OfAnotherDisplayOrWithoutTheEncoderIsRefused) {
  const Words still = Words("still 2018-07-27T18:44:28Z --at Nairobi -o a.avif") + moon;
  EXPECT_EQ(coppermoon(still + "--display 'Display P3'").err,
            "coppermoon: display = Display P3, allowed for a picture that ends in .avif "
            "Rec.2100-PQ\n");
  EXPECT_EQ(coppermoon(still + "--view Dreamy").status, 1);
  EXPECT_EQ(listing(), std::set<std::string>{});
}

TEST(Pq, IsThatOfThePublishedStandard) {
  // SMPTE ST 2084 and ITU-R BT.2100: 100 cd/m² is 0.508078, 1000 is 0.751827, 10 000 is 1
  for (const auto& [light, code] : {std::pair{100., 0.508078}, {1000., 0.751827}, {1e4, 1.}}) {
    EXPECT_WITHIN(uses::pq_of_light(light / 1e4), code, 1e-6, "printed to six digits");
    EXPECT_WITHIN_RELATIVE(uses::light_of_pq(code) * 1e4, light, 1e-4, "six digits of the code");
  }
  EXPECT_WITHIN(uses::light_of_pq(uses::pq_of_light(1e-7)), 1e-7, 1e-12, "rounding");
}

}  // namespace coppermoon::end_to_end::high_range_test
