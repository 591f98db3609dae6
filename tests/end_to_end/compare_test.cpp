// SPDX-License-Identifier: MIT
// Photographs are made here, of the program's own frame: what a comparison must find is known.
#include <OpenImageIO/imagebuf.h>
#include <nlohmann/json.hpp>

#include "colour/exposure.h"
#include "colour/measured_tone_curves.h"
#include "colour/similarity.h"
#include "support/program.h"
#include "texture/read_image.h"
#include "texture/write_image.h"

namespace coppermoon::end_to_end::compare_test {

using nlohmann::json;

constexpr colour::Exposure exposure{2, 8, 400};
constexpr colour::Similarity turned{1.3, 2.5, 330, 90, true};
constexpr std::size_t side = 400;

/// IEC 61966-2-1.
float coded(double light) {
  const double v = light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
  return static_cast<float>(std::clamp(v, 0., 1.));
}

/// A light frame in another picture's geometry, as bright as told.
texture::Image photographed(const texture::Image& frame, const colour::Similarity& similarity,
                            double value_per_cd_m2) {
  texture::Image photo(side, side, {"R", "G", "B"});
  for (std::size_t k = 0; k < 3; ++k) {
    algebra::Grid<float> channel(frame.height, frame.width);
    for (std::size_t i = 0; i < channel.values().size(); ++i)
      channel.values()[i] = frame.values[3 * i + k];
    const auto there = colour::resampled(channel, similarity, side, side);
    for (std::size_t i = 0; i < there.values().size(); ++i)
      photo.values[3 * i + k] = coded(value_per_cd_m2 * double{there.values()[i]});
  }
  return photo;
}

/// Moves the middle of the frame's disc to a place.
colour::Similarity centred(colour::Similarity similarity, const glm::dvec2& at) {
  const auto lands = colour::moved(similarity, {100, 90});
  similarity.x_px += at.x - lands.x;
  similarity.y_px += at.y - lands.y;
  return similarity;
}

class Compare : public ProgramTest {
 protected:
  Compare() {
    static const auto bytes = still();  // once for all tests
    file("frame.exr", bytes.first);
    file("still.png", bytes.second);
    frame_ = texture::read_image(here("frame.exr"));
  }

  /// A frame and a still of 2008, in the umbra, from the Earth's centre; the disc is in the middle.
  std::pair<std::string, std::string> still() const {
    expect_done(
        coppermoon("still 2008-02-21T03:26:05Z --width 200 --height 180 --field 0.7 --albedo-map "
                   "built-in --quality draft --frame frame.exr -o still.png"));
    return {text_of(here("frame.exr")), text_of(here("still.png"))};
  }

  void write_photo(const char* name, int bits, double value_per_cd_m2,
                   const texture::Attributes& attributes = {}) const {
    texture::write_png(here(name), photographed(frame_, truth_, value_per_cd_m2), bits, attributes);
  }

  /// photo.jpg of a camera with the tone curve of a Canon EOS 6D, and its pixels.
  OIIO::ImageBuf write_jpeg(const texture::Image& frame) const {
    const auto curve = measured_tone_curves().at("Canon EOS 6D").smooth();
    auto shown = photographed(frame, truth_, scale_);
    for (float& value : shown.values) {
      const double v = value, light = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
      value = coded(curve(light));
    }
    OIIO::ImageSpec spec(static_cast<int>(side), static_cast<int>(side), 3, OIIO::TypeDesc::UINT8);
    spec.attribute("compression", "jpeg:95");
    spec.attribute("Make", "Canon");
    OIIO::ImageBuf photo(spec);
    photo.set_pixels(OIIO::ROI(), OIIO::TypeDesc::FLOAT, shown.values.data());
    EXPECT_TRUE(photo.write(here("photo.jpg").string()));
    return photo;
  }

  /// The frame behind a blue sky. Where all is sky, its blue is `share` of white in the photograph.
  texture::Image behind_sky(double share) const {
    auto frame = frame_;
    for (std::size_t i = 2; i < frame.values.size(); i += 3)
      frame.values[i] += static_cast<float>(share / scale_);
    return frame;
  }

  json compared(const Words& words) const { return json_of(Words{"compare"} + words); }

  void expect_registered(const json& found) const {
    const auto& is = found["registration"];
    const colour::Similarity similarity{is["scale"],
                                        is["rotation_deg"].get<double>() * std::numbers::pi / 180,
                                        is["x_px"], is["y_px"], is["mirrored"]};
    EXPECT_TRUE(similarity.mirrored);
    EXPECT_WITHIN_RELATIVE(similarity.scale, truth_.scale, 0.001, "a seventh pixel at the limb");
    EXPECT_WITHIN(similarity.rotation_rad, truth_.rotation_rad, 0.002, "a third of a pixel there");
    const auto is_at = colour::moved(similarity, {100, 90}),
               should = colour::moved(truth_, {100, 90});
    EXPECT_WITHIN(std::hypot(is_at.x - should.x, is_at.y - should.y), 0, 0.1, "of a pixel");
    EXPECT_GT(is["correlation"].get<double>(), 0.99);
  }

  /// That every bin says what the photograph was made with.
  static void expect_alike(const json& found, double stops, const char* reason) {
    ASSERT_EQ(found["bins"].size(), 6U);
    for (const auto& bin : found["bins"]) {
      EXPECT_GT(bin["pixels"].get<int>(), 500);
      EXPECT_WITHIN(bin["difference_stops"].get<double>(), 0, stops, reason);
      for (const char* axis : {"u", "v"})
        EXPECT_WITHIN(bin["photo_" + std::string(axis)].get<double>(),
                      bin["render_" + std::string(axis)].get<double>(), 0.003,
                      "the eye's own step is about that; a deep red's blue is a few steps of 8 "
                      "bits, whose rounding the mean over hundreds of pixels takes out");
      EXPECT_LT(bin["delta_e_2000"].get<double>(), 1.5);  // 1 is just seen
    }
  }

  texture::Image frame_;
  colour::Similarity truth_ = centred(turned, {205.3, 196.8});
  double scale_ = colour::exposure_scale(exposure);
  texture::Attributes header_{{"expTime", static_cast<float>(exposure.time_s)},
                              {"aperture", static_cast<float>(exposure.f_number)},
                              {"isoSpeed", static_cast<float>(exposure.iso)}};
};

TEST_F(Compare, FindsAPhotographItselfInSixteenBits) {
  write_photo("photo.png", 16, scale_, header_);
  const auto found = compared("photo.png frame.exr --bins 6");
  expect_registered(found);
  EXPECT_EQ(found["exposure"]["from"], "exif");
  EXPECT_WITHIN_RELATIVE(found["exposure"]["value_per_cd_m2"].get<double>(), scale_, 1e-6,
                         "a float's digits");
  EXPECT_WITHIN(found["exposure"]["fitted_over_used_stops"].get<double>(), 0, 0.005,
                "16 bits; a tenth of a pixel beside the truth");
  expect_alike(found, 0.005, "16 bits; a tenth of a pixel beside the truth");
}

TEST_F(Compare, FindsAPhotographInEightBits) {
  write_photo("photo.png", 8, scale_, header_);
  const auto found = compared("photo.png frame.exr --bins 6");
  expect_registered(found);
  expect_alike(found, 0.03,
               "codes are rounded; their curve is straight over a step but below code 11, and the "
               "darkest bin is not much above");
}

TEST_F(Compare, KnowsTheFieldOfACameraByItsName) {
  expect_done(coppermoon(
      "still 2008-02-21T03:26:05Z --camera refractor --noise off --stars off --width 600 --height "
      "400 --quality draft --atmosphere undated --frame seen.exr -o seen.png"));
  const auto frame = texture::read_image(here("seen.exr"));
  double lit = 0;
  for (std::size_t i = 0; i < frame.values.size(); i += 3) lit += frame.values[i] > 0;
  const auto found = compared({"seen.png", "seen.exr"});
  EXPECT_WITHIN_RELATIVE(found["disc"]["pixels"].get<double>(), 0.94 * lit, 0.08,
                         "the disc to 0.97 of its radius: of 37 pixels, whose limb lights 3 % of "
                         "them in part; 1 % are clipped. Another field has times as many");
}

/// A photograph of our own camera, a part in the umbra, as JPEG of usual qualities.
TEST_F(Compare, FindsAPartialEclipseInJpeg) {
  expect_done(
      coppermoon("still 2019-01-21T04:10:00Z --camera refractor --time 0.05 --width 600 --height "
                 "400 --quality draft --atmosphere undated --view Un-tone-mapped --frame "
                 "partial.exr -o partial.png"));
  for (const int quality : {85, 90, 92, 95}) {
    SCOPED_TRACE(quality);
    OIIO::ImageBuf photo(here("partial.png").string());
    photo.specmod().attribute("Compression", "jpeg:" + std::to_string(quality));
    ASSERT_TRUE(photo.write(here("partial.jpg").string(), OIIO::TypeDesc::UINT8));
    const auto is = compared({"partial.jpg", "partial.exr"})["registration"];
    EXPECT_WITHIN(is["scale"].get<double>(), 1, 0.02, "2 % of the radius is what limb_of promises");
  }
}

TEST_F(Compare, KnowsTheGlowOfACamera) {
  const auto darkest = [&](const char* glow) {
    expect_done(coppermoon(words_of(
        "still 2008-02-21T02:05:00Z --camera refractor --noise off --stars off --width 400 "
        "--height 300 --field 0.9 --quality draft --atmosphere undated --time 0.002 --glow "
        "{} --frame frame.exr --photograph photo.exr -o a.png",
        glow)));
    // the photograph is always the first one's, with the glow of a lens
    if (!std::filesystem::exists(here("taken.exr")))
      std::filesystem::copy(here("photo.exr"), here("taken.exr"));
    const auto found = compared("taken.exr frame.exr --exposure fit --bins 6");
    return found["bins"].front()["difference_stops"].get<double>();
  };
  EXPECT_WITHIN(darkest("auto"), 0, 0.1,
                "a tenth of a pixel beside the truth, where light doubles in a pixel and a half");
  EXPECT_GT(darkest("0"), 0.5) << "a crescent's glow is as bright as the umbra's edge";
}

TEST_F(Compare, FitsTheExposureWhereTheHeaderIsSilent) {
  write_photo("photo.png", 16, 0.6 * scale_);
  const auto found = compared("photo.png frame.exr --bins 6");
  EXPECT_EQ(found["exposure"]["from"], "fit");
  EXPECT_WITHIN_RELATIVE(found["exposure"]["value_per_cd_m2"].get<double>(), 0.6 * scale_, 0.003,
                         "16 bits; a tenth of a pixel beside the truth");
  expect_alike(found, 0.005, "16 bits; a tenth of a pixel beside the truth");
}

TEST_F(Compare, FindsTheToneCurveOfACamera) {
  auto photo = write_jpeg(frame_);
  const auto found = compared("photo.jpg frame.exr --bins 6");
  EXPECT_EQ(found["light"]["coding"], "camera");
  EXPECT_EQ(found["light"]["tone_curve"].size(), 3U);
  for (const char* channel : {"red", "blue"})
    EXPECT_WITHIN(found["white_balance"][channel].get<double>(), 1, 0.1,
                  "each step of light has an error of 3 %, and the curve's toe, 10 %, is free");
  EXPECT_FALSE(found["white_balance"].contains("as_shot_red")) << "no maker's notes";
  for (const auto& bin : found["bins"])
    EXPECT_WITHIN(
        bin["difference_stops"].get<double>(), 0, 0.2,
        "green and blue of the darkest ground are below level 0.047, where curves are not "
        "known; elsewhere 2.5 %, 0.04")
        << bin;
  const auto as_srgb = compared("photo.jpg frame.exr --bins 6 --coding srgb");
  EXPECT_EQ(as_srgb["light"]["coding"], "srgb");
  EXPECT_FALSE(as_srgb.contains("white_balance")) << "colours are compared as they are";
  double most = 0;
  for (const auto& bin : as_srgb["bins"])
    most = std::max(most, std::abs(bin["difference_stops"].get<double>()));
  EXPECT_GT(most, 0.3) << "without the curve it is not the same light";
  photo.specmod().attribute("Software", "darktable 4.2.1");
  ASSERT_TRUE(photo.write(here("developed.jpg").string()));
  const auto developed = coppermoon("compare developed.jpg frame.exr --json");
  EXPECT_EQ(json::parse(developed.out)["light"]["coding"], "as-file-says");
  EXPECT_EQ(
      developed.err,
      "coppermoon: developed.jpg: developed by darktable 4.2.1, so read as sRGB, as the file says; "
      "--coding camera takes the camera's own tone curve\n");
}

TEST_F(Compare, FindsNoWhiteBalanceInASkyThatTheFrameLacks) {
  write_jpeg(behind_sky(0.007));
  const auto balance = compared("photo.jpg frame.exr")["white_balance"];
  EXPECT_WITHIN(balance["red"].get<double>(), 1, 0.1, "as without a sky");
  EXPECT_WITHIN(balance["blue"].get<double>(), 1, 0.3,
                "sky adds a half to the darkest blue used, and few steps are brighter");
  auto bright = behind_sky(0.1);
  OIIO::ImageBuf frame(here("frame.exr").string());
  ASSERT_TRUE(frame.read(0, 0, true, OIIO::TypeDesc::FLOAT));
  frame.set_pixels(OIIO::ROI(), OIIO::TypeDesc::FLOAT, bright.values.data());
  ASSERT_TRUE(frame.write(here("sky.exr").string()));
  for (std::size_t i = 2; i < bright.values.size(); i += 3) bright.values[i] *= 1.3F;
  write_jpeg(bright);
  const auto of_both = compared("photo.jpg sky.exr")["white_balance"];
  EXPECT_WITHIN_RELATIVE(of_both["blue"].get<double>(), 1.3, 0.1,
                         "the frame has this sky, too, so dark blue counts");
}

TEST_F(Compare, SaysByHowManyStopsAHeaderIsWrong) {
  write_photo("photo.png", 16, scale_ / 2, header_);
  const auto found = compared({"photo.png", "frame.exr"});
  EXPECT_EQ(found["bins"].size(), 12U);
  EXPECT_WITHIN(found["exposure"]["fitted_over_used_stops"].get<double>(), -1, 0.005,
                "half the light is a stop; 16 bits");
  EXPECT_WITHIN(found["disc"]["difference_stops"].get<double>(), -1, 0.005,
                "half the light is a stop; 16 bits");
  const auto csv = coppermoon("compare photo.png frame.exr --csv").out;
  EXPECT_TRUE(csv.starts_with("axis_distance_from_km,axis_distance_to_km,pixels,")) << csv;
  EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 12 + 1) << "names, bins, disc";
}

TEST_F(Compare, LeavesOutWhatIsClipped) {
  write_photo("photo.png", 16, 3 * scale_, header_);
  const auto found = compared("photo.png frame.exr --bins 6 --exposure fit");
  EXPECT_GT(found["disc"]["clipped_pixels"].get<int>(), 1000);
  EXPECT_WITHIN_RELATIVE(found["exposure"]["value_per_cd_m2"].get<double>(), 3 * scale_, 0.01,
                         "bilinear pixels beside clipped ones, a tenth of a pixel off");
  EXPECT_WITHIN(found["disc"]["difference_stops"].get<double>(), 0, 0.015, "as before");
}

TEST_F(Compare, KnowsTheAxisDistancesOfTheDisc) {
  write_photo("photo.png", 16, scale_, header_);
  const auto found = compared({"photo.png", "frame.exr"});
  const auto sky = coppermoon("sky 2008-02-21T03:26:05Z --json");
  const double centre_km = json::parse(sky.out)["axis_distance_km"], radius_km = 1737.4;
  const char* reason =
      "0.97 of the radius is measured, its sphere bends away, and the axis goes through it aslant";
  EXPECT_WITHIN(found["disc"]["axis_distance_from_km"].get<double>(),
                std::abs(centre_km - 0.97 * radius_km), 20, reason);
  EXPECT_WITHIN(found["disc"]["axis_distance_to_km"].get<double>(), centre_km + 0.97 * radius_km,
                20, reason);
}

TEST_F(Compare, DrawsAllThreeSideBySide) {
  write_photo("photo.png", 16, scale_, header_);
  const auto found = compared("photo.png frame.exr -o sheet.png");
  EXPECT_EQ(found["file"], "sheet.png");
  const auto sheet = texture::read_image(here("sheet.png"));
  const std::size_t panel = sheet.height;
  ASSERT_EQ(sheet.width, 3 * panel);
  double off = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    off = std::max(off, std::abs(double{sheet(panel / 2, panel / 2, k)} -
                                 sheet(panel / 2, panel + panel / 2, k)));
    EXPECT_WITHIN(sheet(panel / 2, 2 * panel + panel / 2, k), 0.5F, 0.02F,
                  "grey: no difference; 0.02 of grey is a twelfth of a stop");
  }
  EXPECT_WITHIN(off, 0, 0.02, "the same light; five codes");
}

TEST_F(Compare, RefusesWhatIsNoPairOfMoons) {
  write_photo("photo.png", 8, scale_);
  texture::write_png(here("black.png"), texture::Image(64, 64, {"Y"}), 8);
  texture::write_exr(here("stranger.exr"), frame_, {});
  expect_refused("compare black.png frame.exr", "no Moon");
  expect_refused("compare photo.png stranger.exr", "no recipe");
  expect_refused("compare photo.png still.png", "ends in .exr");
  expect_refused("compare nothing.png frame.exr", "no such file");
  expect_refused("compare photo.png frame.exr --exposure exif", "--exposure fit");
  expect_refused("compare photo.png frame.exr --bins 0", "allowed 1 to 1000");
  expect_refused("compare photo.png frame.exr -o sheet.jpg", ".png");
  expect_refused("compare photo.png", "render", wrong_usage);
}

}  // namespace coppermoon::end_to_end::compare_test
