// SPDX-License-Identifier: MIT
// What is made of a film's rendered frames.
#include <fmt/format.h>

#include "support/program.h"
#include "texture/contact_sheet.h"
#include "texture/read_image.h"

namespace coppermoon::end_to_end::film_pictures_test {

double coded(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

class FilmPictures : public ProgramTest {
 protected:
  static Words film(const Words& more) {
    return Words(
               "animate 2018-07-27 --at -21.1,55.5 --frames 5 --from U1+20min --to U2+10min --make "
               "frames,pictures --width 33 --height 25 --field 0.9 --texture-width 64 --albedo-map "
               "built-in --atmosphere undated -o film") +
           more;
  }

  texture::Image picture(int frame) const {
    return texture::read_image(here(fmt::format("film/frame.{:04}.png", frame)));
  }

  /// A folder with a program named ffmpeg that says its version, and else some words, and fails.
  std::string path_of_failing_ffmpeg(const std::string& status = "1") const {
    std::filesystem::create_directory(here("bin"));
    script("bin/ffmpeg",
           "[ \"$1\" = -version ] && exit 0\necho 'out of moonlight' >&2\necho end >&2\nexit " +
               status);
    return here("bin").string() + ":/usr/bin:/bin";
  }

  /// Sum of two frames' exposures; the greater one of frames that hold a sky.
  void expect_composite(bool sky) {
    std::vector<double> sum(25 * 33 * 3);
    for (const char* name : {"film/frame_lin_rec709.0002.exr", "film/frame_lin_rec709.0004.exr"}) {
      const auto number = [&](const char* attribute) {
        return std::stod(*texture::read_attribute(here(name), attribute));
      };
      const auto frame = texture::read_image(here(name));
      // ISO 12232: q t S / (78 N²), q = 0.65.
      const double scale =
          0.65 * number("expTime") * number("isoSpeed") / (78 * std::pow(number("aperture"), 2));
      for (std::size_t i = 0; i < sum.size(); ++i) {
        const double more = scale * frame.values[i];
        sum[i] = sky ? std::max(sum[i], more) : sum[i] + more;
      }
    }
    const auto composite = texture::read_image(here("all.png"));
    ASSERT_EQ(composite.values.size(), sum.size());
    EXPECT_GT(*std::ranges::max_element(sum), 0.3);
    for (std::size_t i = 0; i < sum.size(); ++i)
      EXPECT_WITHIN(
          composite.values[i], std::min(1., coded(sum[i])), 1.2 / 65535,
          "half a step of 16 bits; near black OpenColorIO's curve has the slope 12.9232 for "
          "12.92, up to 0.66 steps");
  }
};

double linear(double coded) {
  return coded <= 0.04045 ? coded / 12.92 : std::pow((coded + 0.055) / 1.055, 2.4);
}

/// The mean of what `of` makes of some pixels' middle channel.
template <class Of>
double mean(const texture::Image& image, std::size_t top, std::size_t left, std::size_t rows,
            std::size_t columns, Of of) {
  double sum = 0;
  for (std::size_t r = top; r < top + rows; ++r)
    for (std::size_t c = left; c < left + columns; ++c) sum += of(image(r, c, 1));
  return sum / static_cast<double>(rows * columns);
}

TEST_F(FilmPictures, OnAContactSheetHaveTheirOwnLight) {
  expect_done(coppermoon(film("--contact-sheet film/sheet.png")));
  const auto sheet = texture::read_image(here("film/sheet.png"));
  const auto grid = texture::sheet_grid(5, 3, 33, 25);
  ASSERT_EQ(sheet.width, grid.width());
  for (int i = 0; i < 5; ++i) {
    const double alone = mean(picture(i + 1), 0, 0, 25, 33, linear);
    EXPECT_GT(alone, 0.01);
    EXPECT_WITHIN_RELATIVE(mean(sheet, grid.top(i), grid.left(i), grid.picture_height, 240, linear),
                           alone, 0.02, "the filter's edge on 25 rows, and 8 bits");
  }
}

/// A movie's tags as its container has them: primaries, transfer characteristics and matrix by ITU-T H.273.
std::string colour_box(int primaries, int transfer, int matrix) {
  std::string box = "colrnclx";
  for (const int code : {primaries, transfer, matrix})
    for (const int byte : {0, code}) box += static_cast<char>(byte);
  return box;
}

constexpr int bt709 = 1, p3_d65 = 12, srgb = 13;

TEST_F(FilmPictures, AsAMovieAreAllThereInOrder) {
  expect_done(coppermoon(film("--range 1-5x2 --movie film.mp4 --fps 23.976")));
  const auto probed =
      run("ffprobe -v error -count_frames -show_entries "
          "stream=codec_name,width,height,pix_fmt,color_range,color_space,color_transfer,color_"
          "primaries,r_frame_rate,nb_read_frames -of csv=p=0 film.mp4");
  EXPECT_EQ(probed.out, "h264,34,26,yuv420p,tv,bt709,iec61966-2-1,bt709,24000/1001,3\n");
  const auto bytes = text_of(here("film.mp4"));
  EXPECT_LT(bytes.find("moov"), bytes.find("mdat")) << "it can be shown while it comes";
  EXPECT_SAYS(bytes, colour_box(bt709, srgb, bt709));
}

TEST_F(FilmPictures, AsAMovieForEditingAreProRes) {
  expect_done(
      coppermoon(film("--range 3 --make textures --movie film.mov --fps 23.976 --time auto --view "
                      "Un-tone-mapped")));
  const auto probed =
      run("ffprobe -v error -show_entries "
          "stream=codec_name,profile,width,height,pix_fmt,color_range,color_space,color_transfer,"
          "color_primaries,r_frame_rate -of csv=p=0 film.mov");
  EXPECT_EQ(probed.out, "prores,HQ,34,26,yuv422p10le,tv,bt709,iec61966-2-1,bt709,24000/1001\n");
  ASSERT_EQ(run("ffmpeg -v error -i film.mov -pix_fmt rgb24 one.png").status, 0);
  const auto same = [](double level) { return level; };
  EXPECT_WITHIN(mean(texture::read_image(here("one.png")), 0, 0, 25, 33, same),
                mean(picture(3), 0, 0, 25, 33, same), 1.5 / 255,
                "4:2:2, 10 bits, and two conversions to 8 bits");
}

TEST_F(FilmPictures, AsAMovieAreTaggedAsTheirDisplayIs) {
  for (const auto& [display, stream, box] :
       {std::tuple("Rec.1886 Rec.709", "bt709,bt709,bt709\n", colour_box(bt709, bt709, bt709)),
        std::tuple("Display P3", "bt709,iec61966-2-1,smpte432\n",
                   colour_box(p3_d65, srgb, bt709))}) {
    expect_done(
        coppermoon(film(words_of("--range 3 --movie film.mp4 --display {} --replace", display))));
    const auto probed =
        run("ffprobe -v error -show_entries stream=color_space,color_transfer,color_primaries -of "
            "csv=p=0 film.mp4");
    EXPECT_EQ(probed.out, stream) << display;
    EXPECT_SAYS(text_of(here("film.mp4")), box) << display;
  }
}

TEST_F(FilmPictures, AsAMovieKeepTheirLight) {
  expect_done(coppermoon(film("--range 1-5x2 --movie film.mp4")));
  ASSERT_EQ(run(words_of("ffmpeg -v error -i film.mp4 -vf {} -frames:v 1 -pix_fmt rgb24 middle.png",
                         "select=eq(n\\,1)"))
                .status,
            0);
  const auto same = [](double level) { return level; };
  EXPECT_WITHIN(mean(texture::read_image(here("middle.png")), 0, 0, 25, 33, same),
                mean(picture(3), 0, 0, 25, 33, same), 1.5 / 255,
                "4:2:0, crf 16, and two conversions to 8 bits");
}

TEST_F(FilmPictures, AsACompositeAreTheSumOfTheirExposures) {
  for (const bool sky : {false, true}) {
    expect_done(coppermoon(film(words_of(
        "--range 2,4 --composite all.png --bits 16 --view Un-tone-mapped --replace --sky {}",
        sky ? "14" : "off"))));
    expect_composite(sky);
  }
}

TEST_F(FilmPictures, HaveTheirMomentInTheHeaderAndACaptionWhereAskedFor) {
  const Words frames = "--width 300 --height 240 --range 5";
  expect_done(coppermoon(film(frames)));
  const auto plain = picture(5);
  EXPECT_EQ(
      texture::read_attribute(here("film/frame.0005.png"), "capDate").value_or("").substr(0, 16),
      "2018:07:27 19:40")
      << "ten minutes after U2, 19:30:15 by NASA's catalogue";
  expect_done(coppermoon(film(frames + "--caption --replace")));
  const auto captioned = picture(5);
  std::size_t above = 0, left = 0, right = 0;
  for (std::size_t r = 0; r < plain.height; ++r)
    for (std::size_t c = 0; c < plain.width; ++c)
      if (plain(r, c, 1) != captioned(r, c, 1)) ++(r < 216 ? above : c < 200 ? left : right);
  EXPECT_EQ(above, 0U) << "the caption is in the lowest tenth";
  EXPECT_GT(left, 200U) << "local time and place";
  EXPECT_GT(right, 30U) << "U2+10min";
}

TEST_F(FilmPictures, LeaveNoMovieThatFailed) {
  file("film.mp4", "an earlier film");
  const auto outcome = coppermoon(film("--movie film.mp4"), {.path = path_of_failing_ffmpeg()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err, "coppermoon: ffmpeg: out of moonlight\n");
  const auto silent = coppermoon(film("--movie film.mp4"), {.path = path_of_failing_ffmpeg("0")});
  EXPECT_EQ(silent.err, "coppermoon: ffmpeg: ended without a result\n");
  EXPECT_EQ(text_of(here("film.mp4")), "an earlier film");
  for (const auto& name : listing())
    EXPECT_TRUE(name.starts_with("here")) << name << " was left behind";
}

}  // namespace coppermoon::end_to_end::film_pictures_test
