// SPDX-License-Identifier: MIT
#include <OpenImageIO/imageio.h>
#include <sys/resource.h>
#include <chrono>
#include <csignal>
#include <thread>

#include "baker/texture/exr_header.h"
#include "baker/texture/scratch_folder.h"
#include "support/testing.h"
#include "texture/read_image.h"
#include "texture/write_image.h"

namespace write_image_test {

using namespace coppermoon::texture;

using WriteImage = ScratchFolder;

/// Luminances over six decades, as an eclipse has them.
Image eclipse_like(std::size_t height) {
  Image image(2 * height, height, {"R", "G", "B"});
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] = std::pow(10.0F, -3 + 6 * static_cast<float>(i * 7919 % 1000) / 1000);
  return image;
}

Image one_texel(float value) {
  Image image(2, 1, {"R", "G", "B"});
  image(0, 1, 2) = value;
  return image;
}

TEST_F(WriteImage, HalfKeepsElevenBits) {
  const auto image = eclipse_like(16);
  write_exr(in_folder("a.exr"), image, {});
  const auto back = read_image(in_folder("a.exr"));
  ASSERT_EQ(back.channels, image.channels);
  ASSERT_EQ(back.width, 32);
  for (std::size_t i = 0; i < image.values.size(); ++i)
    EXPECT_WITHIN_RELATIVE(back.values[i], image.values[i], 0x1p-11,
                           "half a step of 11 bits; PIZ loses nothing");
}

TEST_F(WriteImage, FloatingKeepsEveryBit) {
  const auto image = eclipse_like(16);
  write_exr(in_folder("a.exr"), image, {}, {.type = ExrType::floating});
  EXPECT_EQ(read_image(in_folder("a.exr")).values, image.values);
}

TEST_F(WriteImage, HalfIsPackedWithPiz) {
  write_exr(in_folder("a.exr"), eclipse_like(4), {});
  const auto header = exr_header(bytes_of(in_folder("a.exr")));
  EXPECT_EQ(header.at("compression").bytes, "\x04") << "4 is PIZ in the file format's list";
}

TEST_F(WriteImage, KeepsTexelsInTheirPlaces) {
  Image image(4, 2, {"X", "Y", "Z"});
  image(0, 3, 0) = 1;
  image(1, 0, 1) = 2;
  image(1, 2, 2) = 3;
  write_exr(in_folder("a.exr"), image, {});
  const auto back = read_image(in_folder("a.exr"));
  EXPECT_EQ(back.channels, image.channels);
  EXPECT_EQ(back.values, image.values);
}

TEST_F(WriteImage, StandardAttributesHaveTheirStandardTypes) {
  const std::vector<float> rec709{0.64F, 0.33F, 0.3F, 0.6F, 0.15F, 0.06F, 0.3127F, 0.329F};
  const Attributes attributes{{"chromaticities", rec709},
                              {"whiteLuminance", 1.0F},
                              {"capDate", "2008:02:21 03:26:05"},
                              {"utcOffset", 0.0F},
                              {"latitude", 42.73F},
                              {"longitude", -73.69F},
                              {"altitude", 60},
                              {"expTime", 0.5F},
                              {"aperture", 8.0F},
                              {"isoSpeed", 200.0F},
                              {"owner", "someone"},
                              {"comments", "a note"},
                              {"framesPerSecond", std::vector{24000.F, 1001.F}}};
  write_exr(in_folder("a.exr"), eclipse_like(4), attributes);
  const auto header = exr_header(bytes_of(in_folder("a.exr")));
  EXPECT_EQ(header.at("chromaticities").type, "chromaticities");
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_EQ(header.at("chromaticities").at<float>(i), rec709[i]) << i;
  for (const char* name : {"whiteLuminance", "utcOffset", "latitude", "longitude", "altitude",
                           "expTime", "aperture", "isoSpeed"}) {
    ASSERT_TRUE(header.contains(name)) << name;
    EXPECT_EQ(header.at(name).type, "float") << name;
  }
  EXPECT_EQ(header.at("whiteLuminance").at<float>(0), 1.0F);
  EXPECT_EQ(header.at("altitude").at<float>(0), 60.0F);
  EXPECT_EQ(header.at("expTime").at<float>(0), 0.5F);
  EXPECT_EQ(header.at("capDate").type, "string");
  EXPECT_EQ(header.at("capDate").bytes, "2008:02:21 03:26:05");
  EXPECT_EQ(header.at("owner").bytes, "someone");
  EXPECT_EQ(header.at("comments").bytes, "a note");
  EXPECT_EQ(header.at("framesPerSecond").type, "rational");
  EXPECT_EQ(header.at("framesPerSecond").at<std::int32_t>(0), 24000);
  EXPECT_EQ(header.at("framesPerSecond").at<std::uint32_t>(1), 1001U);
}

TEST_F(WriteImage, FrameRatesAreRatiosOfWholeNumbers) {
  for (const Attribute& value :
       {Attribute(23.976F), Attribute(std::vector{24.F}), Attribute(std::vector{24.F, 0.F}),
        Attribute(std::vector{12.5F, 1.F})})
    EXPECT_THROW(write_exr(in_folder("a.exr"), eclipse_like(1), {{"framesPerSecond", value}}),
                 coppermoon::algebra::Error);
}

TEST_F(WriteImage, TheRecipeComesBack) {
  const std::string recipe = "instant = \"2008-02-21T03:26:05Z\"\nozone_du = 300\n# \xC2\xB5\n";
  write_exr(in_folder("a.exr"), eclipse_like(4), {{"coppermoon:recipe", recipe}});
  EXPECT_EQ(read_attribute(in_folder("a.exr"), "coppermoon:recipe"), recipe);
  write_png(in_folder("a.png"), one_texel(0.5F), 8, {{"coppermoon:recipe", recipe}});
  EXPECT_EQ(read_attribute(in_folder("a.png"), "coppermoon:recipe"), recipe);
}

TEST_F(WriteImage, SpectralChannelsKeepTheirNames) {
  const std::vector<std::string> names{"S0.380,000000nm", "S0.550,000000nm", "S0.780,000000nm"};
  Image image(2, 1, names);
  image(0, 1, 1) = 5;
  write_exr(in_folder("a.exr"), image, {{"spectralLayoutVersion", "1.0"}});
  const auto back = read_image(in_folder("a.exr"));
  EXPECT_EQ(back.channels, names);
  EXPECT_EQ(back(0, 1, 1), 5.0F);
}

TEST_F(WriteImage, TheSameBytesAgainLater) {
  const auto image = eclipse_like(64);
  for (const char* name : {"a.exr", "b.exr"}) {
    write_exr(in_folder(name), image, {{"isoSpeed", 100.0F}});
    std::this_thread::sleep_for(
        std::chrono::milliseconds(1100));  // beyond a stamp of whole seconds
  }
  EXPECT_EQ(bytes_of(in_folder("a.exr")), bytes_of(in_folder("b.exr")));
  for (const char* name : {"a.png", "b.png"}) {
    write_png(in_folder(name), one_texel(0.5F), 16);
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  }
  EXPECT_EQ(bytes_of(in_folder("a.png")), bytes_of(in_folder("b.png")));
}

TEST_F(WriteImage, RefusesWhatHalfCannotHold) {
  const auto path = in_folder("a.exr");
  const auto place = "a.exr: texel row 0, column 1, channel B = ";
  EXPECT_ERROR(write_exr(path, one_texel(65505), {}),
               place + std::string("65505, allowed 0 to 65504"));
  EXPECT_ERROR(write_exr(path, one_texel(NAN), {}), place + std::string("nan"));
  EXPECT_ERROR(write_exr(path, one_texel(INFINITY), {}), place + std::string("inf"));
  EXPECT_ERROR(write_exr(path, one_texel(-1e-3F), {}), place + std::string("-0.001"));
  EXPECT_EQ(files_in_folder(), 0);
  EXPECT_EQ(coppermoon::refusal_of([&] { write_exr(path, one_texel(65504), {}); }), "");
  EXPECT_EQ(read_image(path)(0, 1, 2), 65504.0F);
}

TEST_F(WriteImage, FloatingHoldsMoreButNoInfinity) {
  const auto path = in_folder("a.exr");
  const ExrOptions floating{.type = ExrType::floating};
  write_exr(path, one_texel(1e30F), {}, floating);
  EXPECT_EQ(read_image(path)(0, 1, 2), 1e30F);
  EXPECT_ERROR(write_exr(path, one_texel(INFINITY), {}, floating), "channel B = inf");
  EXPECT_ERROR(write_exr(path, one_texel(NAN), {}, floating), "channel B = nan");
}

TEST_F(WriteImage, NegativesPassWhenAllowed) {
  const auto path = in_folder("a.exr");
  write_exr(path, one_texel(-0.25F), {}, {.allow_negative = true});
  EXPECT_EQ(read_image(path)(0, 1, 2), -0.25F);
  EXPECT_ERROR(write_exr(path, one_texel(-70000), {}, {.allow_negative = true}), "-70000");
}

TEST_F(WriteImage, RefusesImagesThatDoNotHangTogether) {
  const auto path = in_folder("a.exr");
  EXPECT_ERROR(write_exr(path, Image(), {}), "0 x 0 texels");
  auto short_one = one_texel(1);
  short_one.values.pop_back();
  EXPECT_ERROR(write_exr(path, short_one, {}), "5 values");
  EXPECT_ERROR(write_exr(path, Image(1, 1, {"Y", "Y"}), {}), "channel \"Y\"");
}

TEST_F(WriteImage, RefusesAttributesThatWouldBeLost) {
  const auto path = in_folder("a.exr");
  const auto with = [&](const char* name, const Attribute& value) {
    return coppermoon::refusal_of([&] { write_exr(path, one_texel(1), {{name, value}}); });
  };
  EXPECT_EQ(with("chromaticities", std::vector<float>(6)),
            "image attribute chromaticities, allowed 8 numbers");
  EXPECT_EQ(with("expTime", "1/2"), "image attribute expTime, allowed one number");
  EXPECT_EQ(with("capDate", 2008), "image attribute capDate, allowed text");
  EXPECT_NE(with("compression", "dwaa"), "");
  EXPECT_NE(with("", "x"), "");
}

TEST_F(WriteImage, AFullDiskLeavesNothing) {
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before;
  ::getrlimit(RLIMIT_FSIZE, &before);
  for (const rlim_t size :
       {0, 100, 20000}) {  // in the header, in the table of lines, in the texels
    const rlimit small{size, before.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
    EXPECT_ERROR(write_exr(in_folder("a.exr"), eclipse_like(128), {}),
                 "a.exr: cannot be written: File too large");
    Image noisy = eclipse_like(128);
    for (std::size_t i = 0; i < noisy.values.size(); ++i)
      noisy.values[i] = static_cast<float>(i * i % 65521) / 65521;  // hardly to be packed
    EXPECT_ERROR(write_png(in_folder("a.png"), noisy, 16),
                 "a.png: cannot be written: File too large");
    ::setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_EQ(files_in_folder(), 0);
  }
}

TEST_F(WriteImage, NeedsItsFolder) {
  EXPECT_ERROR(write_exr(in_folder("no/a.exr"), one_texel(1), {}),
               "no/a.exr: cannot be written: No such file or directory");
}

TEST_F(WriteImage, TheFileNameDoesNotChooseTheFormat) {
  write_exr(in_folder("frame.0001"), one_texel(1), {});
  EXPECT_EQ(bytes_of(in_folder("frame.0001")).substr(0, 4), "\x76\x2f\x31\x01");
}

TEST_F(WriteImage, PngRoundsToItsSteps) {
  Image image(256, 1, {"R", "G", "B"});
  for (std::size_t c = 0; c < 256; ++c) image(0, c, 0) = static_cast<float>(c) / 255;
  for (const int bits : {8, 16}) {
    write_png(in_folder("a.png"), image, bits);
    const auto back = read_image(in_folder("a.png"));
    for (std::size_t c = 0; c < 256; ++c)
      EXPECT_WITHIN(back(0, c, 0), image(0, c, 0), 1e-6,
                    "these are steps of both, but for rounding");
  }
}

TEST_F(WriteImage, PngSaysThatItIsSrgb) {
  write_png(in_folder("a.png"), one_texel(0.5F), 8);
  EXPECT_SAYS(bytes_of(in_folder("a.png")), "sRGB") << "the chunk's name";
}

TEST_F(WriteImage, PngKeepsNumbersAsText) {
  write_png(in_folder("a.png"), one_texel(0.5F), 8,
            {{"expTime", 0.25F}, {"isoSpeed", 800.F}, {"owner", std::string("me")}});
  EXPECT_EQ(read_attribute(in_folder("a.png"), "expTime"), "0.25");
  EXPECT_EQ(read_attribute(in_folder("a.png"), "isoSpeed"), "800");
  EXPECT_EQ(read_attribute(in_folder("a.png"), "owner"), "me");
}

TEST_F(WriteImage, PngRefusesWhatItCannotHold) {
  const auto path = in_folder("a.png");
  EXPECT_ERROR(write_png(path, one_texel(1.01F), 8), "= 1.01, allowed 0 to 1");
  EXPECT_ERROR(write_png(path, one_texel(NAN), 8), "= nan");
  EXPECT_ERROR(write_png(path, one_texel(1), 12), "12 bits, allowed 8 or 16");
  EXPECT_ERROR(write_png(path, Image(1, 1, {"a", "b"}), 8), "2 channels, allowed 1 or 3");
}

/// So wide that the writer takes 64 rows at a time; each value tells its row and column.
const Layout wide{30000, 130, {"R", "G", "B"}};

void number_rows(std::size_t first_row, std::span<float> values) {
  const std::size_t length = wide.width * wide.channels.size();
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = static_cast<float>((first_row + i / length) * 10 + i % length % 7);
}

TEST_F(WriteImage, RowsMadeAsTheyAreWrittenStandInTheirPlaces) {
  std::size_t most = 0;
  const auto rows = [&](std::size_t first_row, std::span<float> values) {
    most = std::max(most, values.size());
    number_rows(first_row, values);
  };
  write_exr(in_folder("a.exr"), wide, rows, {});
  Image whole(wide.width, wide.height, wide.channels);
  number_rows(0, whole.values);
  EXPECT_TRUE(read_image(in_folder("a.exr")).values == whole.values);
  EXPECT_EQ(most, 64 * wide.width * 3) << "not the whole image at once";
}

TEST_F(WriteImage, WhatMakingRowsThrowsLeavesNoFile) {
  const auto failing = [](std::size_t first_row, std::span<float>) {
    if (first_row > 0) throw coppermoon::algebra::Error("no more light");
  };
  EXPECT_ERROR(write_exr(in_folder("a.exr"), wide, failing, {}), "no more light");
  const auto wrong = [](std::size_t first_row, std::span<float> values) {
    if (first_row > 0) values[wide.width * 3 + 4] = NAN;
  };
  EXPECT_ERROR(write_exr(in_folder("a.exr"), wide, wrong, {}),
               "a.exr: texel row 65, column 1, channel G = nan, allowed 0 to 65504");
  EXPECT_EQ(files_in_folder(), 0);
}

TEST_F(WriteImage, MayBeLeftUnpacked) {
  const auto image = eclipse_like(16);
  write_exr(in_folder("a.exr"), image, {}, {.packed = false});
  EXPECT_EQ(exr_header(bytes_of(in_folder("a.exr"))).at("compression").bytes, std::string(1, '\0'));
  write_exr(in_folder("b.exr"), image, {});
  EXPECT_EQ(read_image(in_folder("a.exr")).values, read_image(in_folder("b.exr")).values);
}

/// All levels of a mip-mapped file.
std::vector<Image> levels_of(const std::filesystem::path& path) {
  std::vector<Image> levels;
  const auto input = OIIO::ImageInput::open(path);
  for (int level = 0; input && input->seek_subimage(0, level); ++level) {
    const auto spec = input->spec();
    Image image(static_cast<std::size_t>(spec.width), static_cast<std::size_t>(spec.height),
                spec.channelnames);
    EXPECT_TRUE(
        input->read_image(0, level, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, image.values.data()));
    levels.push_back(std::move(image));
  }
  return levels;
}

/// Means over areas: the mean of a plane over a texel is its value in the texel's middle, whatever
/// part of each smaller texel lies in it.
TEST_F(WriteImage, MipmapsOfAnySizeHoldTheMeanOfEachTexelsArea) {
  for (const std::size_t height : {64U, 75U, 333U}) {
    Image plane(2 * height, height, {"R", "G", "B"});
    const auto at = [&](double row, double column) {  // of places from 0 to 1
      return 1 + 3 * row + 2 * column;
    };
    const auto middle = [](std::size_t i, std::size_t of) {
      return (static_cast<double>(i) + 0.5) / static_cast<double>(of);
    };
    for (std::size_t r = 0; r < height; ++r)
      for (std::size_t c = 0; c < 2 * height; ++c)
        for (std::size_t k = 0; k < 3; ++k)
          plane(r, c, k) = static_cast<float>(at(middle(r, height), middle(c, 2 * height)));
    write_mipmapped(in_folder("a.tx"), {plane.width, plane.height, plane.channels}, rows_of(plane),
                    {}, ExrType::floating);
    const auto levels = levels_of(in_folder("a.tx"));
    ASSERT_EQ(levels.size(), 1 + static_cast<std::size_t>(std::log2(2 * height)));
    EXPECT_EQ(levels.front().values, plane.values);
    EXPECT_EQ(levels.back().width * levels.back().height, 1U);
    for (const auto& level : levels)
      for (std::size_t r = 0; r < level.height; ++r)
        for (std::size_t c = 0; c < level.width; ++c)
          EXPECT_WITHIN(level(r, c, 1), at(middle(r, level.height), middle(c, level.width)),
                        height == 64 ? 1e-5 : 1.5 / static_cast<double>(level.height),
                        "exact where texels come in pairs; else a plane of steps, half of one off "
                        "where they are cut");
  }
}

TEST_F(WriteImage, PartsHaveNamesOfTheirOwn) {
  const auto image = eclipse_like(4);
  const Layout layout{image.width, image.height, image.channels};
  const std::vector<Part> parts{{"lit", layout, rows_of(image)}, {"lit", layout, rows_of(image)}};
  EXPECT_THROW(write_exr(in_folder("a.exr"), parts, {}), coppermoon::algebra::Error);
  EXPECT_THROW(write_exr(in_folder("a.exr"), std::span<const Part>(), {}),
               coppermoon::algebra::Error);
  EXPECT_FALSE(std::filesystem::exists(in_folder("a.exr")));
}

TEST_F(WriteImage, PartsAppearWholeOrNotAtAll) {
  const auto image = eclipse_like(4);
  auto spoilt = image;
  spoilt(3, 0, 0) = std::numeric_limits<float>::quiet_NaN();
  const Layout layout{image.width, image.height, image.channels};
  const std::vector<Part> parts{{"lit", layout, rows_of(image)},
                                {"direct", layout, rows_of(spoilt)}};
  EXPECT_THROW(write_exr(in_folder("a.exr"), parts, {}), coppermoon::algebra::Error);
  EXPECT_TRUE(std::filesystem::is_empty(in_folder(".")));
}

TEST_F(WriteImage, PicturesByRowsHaveTheBytesOfWholeOnes) {
  Image image(wide.width, wide.height, wide.channels);
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] = static_cast<float>(i % 7919) / 7919;
  const Attributes attributes{{"expTime", 0.5F}, {"coppermoon:recipe", std::string("a recipe")}};
  std::size_t most = 0;
  const Rows rows = [&, all = rows_of(image)](std::size_t row, std::span<float> values) {
    most = std::max(most, values.size());
    all(row, values);
  };
  write_png(in_folder("a.png"), image, 8, attributes);
  write_picture(in_folder("b.png"), wide, rows, {"png", 8}, attributes);
  EXPECT_TRUE(bytes_of(in_folder("a.png")) == bytes_of(in_folder("b.png")));
  EXPECT_EQ(most, 64 * wide.width * 3) << "not the whole picture at once";
}

TEST_F(WriteImage, PicturesThatCannotBeMadeLeaveNothingAndPrintNothing) {
  const Rows failing = [](std::size_t row, std::span<float> values) {
    if (row > 0) values[5] = 2;
  };
  for (const char* format : {"png", "jpeg"}) {
    testing::internal::CaptureStderr();
    EXPECT_ERROR(write_picture(in_folder("a"), wide, failing, {format, 8}), "= 2, allowed 0 to 1");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << format;
  }
  EXPECT_ERROR(write_picture(in_folder("a"), wide, failing, {"jpeg", 16}),
               "JPEG of 16 bits, allowed 8");
  EXPECT_EQ(files_in_folder(), 0U);
}

TEST_F(WriteImage, JpegHasItsExposureAsExif) {
  Image grey(16, 16, {"R", "G", "B"});
  std::ranges::fill(grey.values, 0.5F);
  write_picture(in_folder("a.jpg"), {16, 16, grey.channels}, rows_of(grey), {"jpeg", 8},
                {{"expTime", 0.5F},
                 {"aperture", 8.F},
                 {"isoSpeed", 800.F},
                 {"capDate", std::string("2018:07:27 20:21:45")},
                 {"coppermoon:recipe", std::string("a recipe")}});
  EXPECT_TRUE(bytes_of(in_folder("a.jpg")).starts_with("\xff\xd8"));
  for (const float value : read_image(in_folder("a.jpg")).values)
    EXPECT_WITHIN(value, 0.5, 2.01 / 255, "of quality 95; half a step is dithered");
  EXPECT_EQ(read_attribute(in_folder("a.jpg"), "DateTime"), "2018:07:27 20:21:45");
  EXPECT_EQ(read_attribute(in_folder("a.jpg"), "expTime"), "0.5");
  EXPECT_EQ(read_attribute(in_folder("a.jpg"), "Exif:PhotographicSensitivity"), "800");
}

TEST_F(WriteImage, GradientsOf8BitsAreDitheredAndWholeStepsAreNot) {
  constexpr std::size_t width = 4096, rows = 16;
  Image ramp(width, rows, {"R", "G", "B"}), steps(256, 1, {"R", "G", "B"});
  for (std::size_t i = 0; i < ramp.values.size(); ++i)  // 51 to 53 of 255
    ramp.values[i] =
        static_cast<float>((51 + 2. * static_cast<double>((i / 3) % width) / width) / 255);
  for (std::size_t i = 0; i < steps.values.size(); ++i)
    steps.values[i] = static_cast<float>(static_cast<double>(i / 3) / 255);
  write_png(in_folder("ramp.png"), ramp, 8);
  write_png(in_folder("again.png"), ramp, 8);
  write_png(in_folder("steps.png"), steps, 8);
  const auto read = read_image(in_folder("ramp.png"));
  EXPECT_EQ(read.values, read_image(in_folder("again.png")).values);
  for (std::size_t block = 0; block < width / 128; ++block) {
    double mean = 0, wanted = 0;
    for (std::size_t r = 0; r < rows; ++r)
      for (std::size_t c = 0; c < 128; ++c) {
        mean += 255. * static_cast<double>(read(r, 128 * block + c, 1));
        wanted += 255. * static_cast<double>(ramp(r, 128 * block + c, 1));
      }
    EXPECT_WITHIN((mean - wanted) / (128 * rows), 0, 0.1,
                  "steps: of 2048 texels half a step each way leaves 0.011, nine times of which");
  }
  const auto whole = read_image(in_folder("steps.png"));
  for (std::size_t i = 0; i < steps.values.size(); ++i)
    ASSERT_EQ(std::lround(255 * whole.values[i]), static_cast<long>(i / 3));
}

}  // namespace write_image_test
