// SPDX-License-Identifier: MIT
#include "texture/read_image.h"

#include <OpenImageIO/imageio.h>
#include <unistd.h>
#include <cstring>

#include "baker/texture/scratch_folder.h"
#include "support/testing.h"
#include "texture/write_image.h"

namespace read_image_test {

using namespace coppermoon::texture;

using ReadImage = ScratchFolder;
using ReadLight = ScratchFolder;
using ReadAlbedoMap = ScratchFolder;

/// A portable float map, written by hand: rows from the bottom, little endian.
std::string float_map(int width, int height, const std::vector<float>& grey) {
  std::string bytes = "Pf\n" + std::to_string(width) + " " + std::to_string(height) + "\n-1\n";
  bytes.append(reinterpret_cast<const char*>(grey.data()), grey.size() * sizeof(float));
  return bytes;
}

/// An EXR file of one row of texels, 1, 2, 3 …, that stand from `x` of a picture that begins at 0.
std::filesystem::path row_from(const std::filesystem::path& path, int x, int texels, int shown,
                               const std::vector<std::string>& channels = {"R", "G", "B"}) {
  OIIO::ImageSpec spec(texels, 1, static_cast<int>(channels.size()), OIIO::TypeDesc::FLOAT);
  spec.x = x;
  spec.full_width = shown;
  spec.channelnames = channels;
  std::vector<float> values;
  for (int i = 0; i < texels; ++i)
    values.insert(values.end(), channels.size(), static_cast<float>(i + 1));
  const auto output = OIIO::ImageOutput::create("openexr");
  EXPECT_TRUE(output->open(path.string(), spec));
  EXPECT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, values.data()));
  return path;
}

/// What is said on stderr meanwhile.
std::string said_by(const std::function<void()>& act) {
  std::FILE* said = std::tmpfile();
  const int before = ::dup(STDERR_FILENO);
  ::dup2(::fileno(said), STDERR_FILENO);
  act();
  std::fflush(stderr);
  ::dup2(before, STDERR_FILENO);
  ::close(before);
  std::string text(static_cast<std::size_t>(std::ftell(said)), ' ');
  std::rewind(said);
  text.resize(std::fread(text.data(), 1, text.size(), said));
  std::fclose(said);
  return text;
}

TEST_F(ReadImage, GivesIntegersAsFractions) {
  const auto image = read_image(file("a.ppm", "P6\n2 1\n255\n\xFF\x80\x01\x02\x03\x04"));
  EXPECT_EQ(image.width, 2);
  EXPECT_EQ(image.height, 1);
  EXPECT_EQ(image.channels, (std::vector<std::string>{"R", "G", "B"}));
  EXPECT_WITHIN(image(0, 0, 1), 128.0 / 255, 1e-7, "a float's rounding");
  EXPECT_WITHIN(image(0, 1, 2), 4.0 / 255, 1e-7, "a float's rounding");
}

TEST_F(ReadImage, ReadsManyBandsOfRows) {
  Image tall(3, 1000, {"Y"});
  for (std::size_t i = 0; i < tall.values.size(); ++i) tall.values[i] = static_cast<float>(i);
  write_exr(in_folder("a.exr"), tall, {}, {.type = ExrType::floating});
  EXPECT_EQ(read_image(in_folder("a.exr")).values, tall.values);
}

TEST_F(ReadImage, SaysWhatIsWrongWithAFile) {
  EXPECT_ERROR(read_image(in_folder("no.exr")), "no.exr: cannot be read: no such file");
  EXPECT_ERROR(read_image(in_folder("")), "it is a directory");
  EXPECT_ERROR(read_image(file("empty.exr", "")), "empty.exr: cannot be read: it is empty");
  EXPECT_ERROR(read_image(file("text.exr", "not an image\n")), "text.exr: cannot be read: ");
  EXPECT_ERROR(read_image(file("text.what", "not an image\n")), "text.what: cannot be read: ");
  EXPECT_ERROR(read_image("/dev/null"), "/dev/null: cannot be read: it is no regular file");
}

TEST_F(ReadImage, SaysThatAFileEndsEarly) {
  Image image(64, 32, {"R", "G", "B"});
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] = static_cast<float>(i * 7919 % 1000);
  write_exr(in_folder("whole.exr"), image, {}, {.type = ExrType::floating});
  const auto bytes = bytes_of(in_folder("whole.exr"));
  const auto cut = file("cut.exr", std::string_view(bytes).substr(0, bytes.size() * 3 / 4));
  EXPECT_ERROR(read_image(cut), "cut.exr: cannot be read: ");
  EXPECT_ERROR(read_albedo_map(cut), "cut.exr: cannot be read: ");
}

TEST_F(ReadImage, FindsAttributesByTheirStandardNames) {
  const Attributes attributes{{"capDate", "2008:02:21 03:26:05"}, {"expTime", 0.5F}};
  write_exr(in_folder("a.exr"), Image(1, 1, {"Y"}), attributes);
  EXPECT_EQ(read_attribute(in_folder("a.exr"), "capDate"), "2008:02:21 03:26:05");
  EXPECT_EQ(read_attribute(in_folder("a.exr"), "expTime"), "0.5");
  EXPECT_EQ(read_attribute(in_folder("a.exr"), "coppermoon:recipe"), std::nullopt);
}

TEST_F(ReadImage, IsTheDisplayWindowBlackOutsideTheData) {
  const auto reds = [](const Image& image) {
    std::vector<float> values;
    for (std::size_t c = 0; c < image.width; ++c) values.push_back(image(0, c, 0));
    return values;
  };
  const auto within = row_from(in_folder("within.exr"), 2, 3, 6),
             beyond = row_from(in_folder("beyond.exr"), -1, 5, 3),
             apart = row_from(in_folder("apart.exr"), 9, 2, 3);
  const std::vector<std::string> red{"R"};
  for (const auto& image : {read_image(within), read_channels(within, red), read_light(within)})
    EXPECT_EQ(reds(image), (std::vector<float>{0, 0, 1, 2, 3, 0}));
  for (const auto& image : {read_image(beyond), read_channels(beyond, red), read_light(beyond)})
    EXPECT_EQ(reds(image), (std::vector<float>{2, 3, 4}));
  EXPECT_EQ(reds(read_image(apart)), (std::vector<float>{0, 0, 0}));
  EXPECT_EQ(windows_of(beyond), (Windows{{-1, 0, 5, 1}, {0, 0, 3, 1}}));
}

TEST_F(ReadImage, TakesChannelsByTheirNames) {
  Image image(1, 1, {"A", "B", "G", "R", "valid"});
  image.values = {1, 2, 3, 4, 5};
  write_exr(in_folder("a.exr"), image, {}, {.type = ExrType::floating});
  EXPECT_EQ(read_channels(in_folder("a.exr"), {"R", "G", "B", "valid"}).values,
            (std::vector<float>{4, 3, 2, 5}));
  EXPECT_ERROR(read_channels(in_folder("a.exr"), {"X", "Y", "Z"}), "a.exr: channels ");
  EXPECT_ERROR(read_channels(in_folder("a.exr"), {"X", "Y", "Z"}), "valid, allowed X, Y, Z");
}

TEST_F(ReadImage, TakesNoCodesForLight) {
  const auto photograph = file("a.ppm", "P6\n1 1\n255\n\xFF\x80\x01");
  EXPECT_ERROR(read_channels(photograph, {"R", "G", "B"}), "a.ppm: holds whole numbers");
}

TEST_F(ReadImage, ClaimsOfADisplayWindowAreNotBelieved) {
  EXPECT_ERROR(read_image(row_from(in_folder("a.exr"), 0, 2, 1 << 21)),
               "a.exr: cannot be read: width [texels] = 2.09715e+06, allowed up to ");
}

/// OpenEXR looks at no pixel type of a part whose own type it does not know; OpenImageIO 2.4.7 then ends
/// the program.
TEST_F(ReadImage, PixelTypesThatOpenExrDoesNotHaveAreRefused) {
  const Layout layout{4, 2, {"R"}};
  const Rows black = [](std::size_t, std::span<float> values) { std::ranges::fill(values, 0.F); };
  const std::vector<Part> parts{{"one", layout, black}, {"two", layout, black}};
  write_exr(in_folder("a.exr"), parts, {});
  const auto whole = bytes_of(in_folder("a.exr"));
  const std::string channel("R\0\x01\0\0\0", 6);
  const auto first = whole.find(channel), second = whole.find(channel, first + 1);
  const auto unknown = whole.find("scanlineimage");
  ASSERT_NE(std::max({first, second, unknown}), std::string::npos);
  for (const auto at : {first, second}) {
    auto bytes = whole;
    bytes[at + 2] = '\x07';
    bytes[unknown] = 'S';
    EXPECT_ERROR(
        read_image(file("b.exr", bytes)),
        "b.exr: cannot be read: pixel type of channel \"R\" = 7, allowed 0 (whole numbers), "
        "1 (half) and 2 (float)");
  }
}

/// Opening such a file would take 2 GB, or more bytes than OpenImageIO 2.4.7 can count.
TEST_F(ReadImage, ClaimsOfSidesAreNotBelieved) {
  using namespace std::string_literals;
  const auto begin = "\xFF\xD8"s, comment = "\xFF\xFE\0\6\xFF\xC2\0\7"s,
             sides = "\0\x11\x08\x3F\xFF\xC4\x20\3\1\x22\0\2\x11\1\3\x11\1"s;
  for (const auto& before : {""s, comment, "junk"s, "\xFF\xFF"s})
    EXPECT_ERROR(read_image(file("a.jpg", begin + before + "\xFF\xC2"s + sides)),
                 "a.jpg: cannot be read: numbers in a file so small = 2.46767e+09, allowed up to ");
  EXPECT_ERROR(read_image(file("a.gif", "GIF89a\xFA\xFA\xFA\x25\0\0\0"s)),
               "a.gif: cannot be read: numbers in a file so small = 2.49855e+09, allowed up to ");
  const std::string padding(1 << 19, '\0');
  EXPECT_ERROR(read_image(file("b.gif", "GIF89a\xFA\xFA\xFA\x25\0\0\0"s + padding)),
               "b.gif: cannot be read: numbers of a GIF = 2.49855e+09, allowed up to 2.14748e+09");
}

/// libpng and libtiff say a line of their own of such files.
TEST_F(ReadImage, OfBrokenFilesNobodyPrints) {
  Image image(64, 32, {"R", "G", "B"});
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] = static_cast<float>(i * 7919 % 1000) / 1000;
  write_png(in_folder("a.png"), image, 8);
  write_tiff(in_folder("a.tif"), image, {});
  for (const char* name : {"a.png", "a.tif"}) {
    const auto bytes = bytes_of(in_folder(name));
    const auto cut =
        file(std::string("cut") + name, std::string_view(bytes).substr(0, bytes.size() * 2 / 3));
    EXPECT_EQ(said_by([&] { EXPECT_ERROR(read_image(cut), "cannot be read: "); }), "") << name;
    EXPECT_EQ(said_by([&] { EXPECT_ERROR(read_light(cut), "cannot be read: "); }), "") << name;
  }
}

TEST_F(ReadImage, FilesAreReadAsWhatTheyAreOrItIsSaid) {
  using namespace std::string_literals;
  const auto bmp =
      "BM\x3A\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\1\0\0\0\1\0\0\0\1\0\x18\0\0\0\0\0\4\0\0\0"s +
      std::string(16, '\0') + "\0\0\xFF\0"s;
  EXPECT_EQ(read_image(file("a.png", bmp)).values, (std::vector<float>{1, 0, 0}));
  write_tiff(in_folder("a.tif"), Image(4, 2, {"R", "G", "B"}), {});
  EXPECT_ERROR(read_image(file("a.CR2", bytes_of(in_folder("a.tif")))),
               "; it begins as a TIFF does, whose name ends in .tif");
  EXPECT_ERROR(read_image(file("b.png", std::string(100, ')'))),
               "b.png: cannot be read: Not a PNG file");
}

TEST_F(ReadLight, TakesRedGreenAndBlueByTheirNamesOrGreyAlone) {
  const auto light_of = [&](const std::vector<std::string>& channels) {
    return read_light(row_from(in_folder("a.exr"), 0, 1, 1, channels));
  };
  for (const auto& other : std::vector<std::vector<std::string>>{
           {"Y", "RY", "BY"}, {"B", "A", "Z"}, {"X", "Y", "Z"}, {"Z"}, {"a.R", "a.G", "a.B"}})
    EXPECT_ERROR(light_of(other), "allowed R, G and B, or Y alone");
  EXPECT_ERROR(light_of({"B", "A", "Z"}), "a.exr: cannot be read: channels ");
  EXPECT_EQ(light_of({"Y", "A"}).values, (std::vector<float>{1, 1, 1}));
  EXPECT_ERROR(read_albedo_map(row_from(in_folder("a.exr"), 0, 2, 2, {"Y", "RY", "BY"})),
               "allowed R, G and B, or Y alone");
}

TEST_F(ReadLight, ChannelsOfTheOnlyLayerNeedNoLayer) {
  const std::vector<std::string> rgb{"R", "G", "B"};
  const auto channels_of = [&](const std::vector<std::string>& channels) {
    Image image(1, 1, channels);
    for (std::size_t i = 0; i < channels.size(); ++i) image.values[i] = static_cast<float>(i);
    write_exr(in_folder("a.exr"), image, {});
    return read_channels(in_folder("a.exr"), rgb).values;
  };
  const std::string combined = "ViewLayer.Combined.", depth = "ViewLayer.Depth.Z";
  EXPECT_EQ(channels_of({combined + "R", combined + "G", combined + "B", combined + "A", depth}),
            (std::vector<float>{0, 1, 2}));
  EXPECT_EQ(channels_of({"R", "G", "B", "a.R", "a.G", "a.B"}), (std::vector<float>{0, 1, 2}));
  EXPECT_ERROR(channels_of({"a.R", "a.G", "a.B", "b.R", "b.G", "b.B"}), "allowed R, G, B");
  EXPECT_ERROR(channels_of({"a.R", "a.G", "b.B"}), "allowed R, G, B");
}

TEST_F(ReadLight, UndoesTheCodingOfIntegers) {
  const auto light = read_light(file("a.ppm", "P6\n1 1\n255\n\x0A\xBC\xFF"));
  EXPECT_EQ(light.channels, (std::vector<std::string>{"R", "G", "B"}));
  EXPECT_WITHIN(light(0, 0, 0), 10. / 255 / 12.92, 1e-8, "a float's rounding");
  EXPECT_WITHIN(light(0, 0, 1), std::pow((188. / 255 + 0.055) / 1.055, 2.4), 1e-6,
                "a float's rounding, and its power's");
  EXPECT_EQ(light(0, 0, 2), 1);
  const auto linear = read_light(in_folder("a.ppm"), Coding::linear);
  EXPECT_WITHIN(linear(0, 0, 1), 188. / 255, 1e-7, "a float's rounding");
}

TEST_F(ReadLight, TakesGreyAndFloatsAsTheyAre) {
  const auto light = read_light(file("a.pfm", float_map(2, 1, {0.25F, 3.F})));
  EXPECT_EQ(light.values, (std::vector<float>{0.25F, 0.25F, 0.25F, 3, 3, 3}));
}

TEST_F(ReadLight, LeavesOutAlpha) {
  Image image(1, 1, {"R", "G", "B", "A"});
  image.values = {0.5F, 0.25F, 0.125F, 1};
  write_exr(in_folder("a.exr"), image, {});
  EXPECT_EQ(read_light(in_folder("a.exr")).values, (std::vector<float>{0.5F, 0.25F, 0.125F}));
}

TEST_F(ReadLight, RefusesWhatIsNotFinite) {
  const float infinite = std::numeric_limits<float>::infinity();
  EXPECT_ERROR(read_light(file("a.pfm", float_map(2, 1, {0, infinite}))), "not finite");
}

TEST_F(ReadAlbedoMap, LinearisesEightBitsAsSrgb) {
  const auto map = read_albedo_map(file("a.pgm", std::string("P5\n2 1\n255\n\x80\x08")));
  // IEC 61966-2-1 by hand: ((128/255 + 0.055)/1.055)^2.4 = 0.215861; 8/255/12.92 = 0.00242822
  EXPECT_WITHIN(map(0, 0), 0.215861, 1e-6, "six digits worked out");
  EXPECT_WITHIN(map(0, 1), 0.00242822, 1e-8, "the straight part, as many digits");
}

TEST_F(ReadAlbedoMap, WeighsColoursByRec709) {
  const auto red =
      read_albedo_map(file("a.ppm", std::string("P6\n2 1\n255\n\xFF\0\0\0\xFF\0", 17)));
  EXPECT_WITHIN(red(0, 0), 0.2126, 1e-6, "the weight of red alone");
  EXPECT_WITHIN(red(0, 1), 0.7152, 1e-6, "the weight of green alone");
}

TEST_F(ReadAlbedoMap, GreyIsItself) {
  const auto grey = read_albedo_map(file("a.ppm", "P6\n2 1\n255\n\xFF\xFF\xFF\x80\x80\x80"));
  EXPECT_WITHIN(grey(0, 0), 1, 1e-6, "the weights add up to 1");
  EXPECT_WITHIN(grey(0, 1), 0.215861, 1e-6, "as one channel would be");
}

TEST_F(ReadAlbedoMap, TakesLinearFormatsAsTheyAre) {
  Image image(4, 2, {"Y"});
  image.values = {0, 0.1F, 0.2F, 0.3F, 0.4F, 0.5F, 7, 100};
  write_exr(in_folder("a.exr"), image, {}, {.type = ExrType::floating});
  const auto map = read_albedo_map(in_folder("a.exr"));
  EXPECT_TRUE(std::equal(image.values.begin(), image.values.end(), map.values().begin()));
  const auto floats = read_albedo_map(file("a.pfm", float_map(2, 1, {0.5F, 2.5F})));
  EXPECT_EQ(floats(0, 0), 0.5F);
  EXPECT_EQ(floats(0, 1), 2.5F);
}

TEST_F(ReadAlbedoMap, NorthIsTheFirstRow) {
  const auto map =
      read_albedo_map(file("a.pgm", std::string("P5\n4 2\n255\n\xFF\0\0\0\0\0\0\0", 19)));
  EXPECT_EQ(map.rows(), 2);
  EXPECT_EQ(map.columns(), 4);
  EXPECT_WITHIN(map(0, 0), 1, 1e-6, "white");
  EXPECT_EQ(map(1, 0), 0);
}

TEST_F(ReadAlbedoMap, TheUserMaySayTheCoding) {
  const auto path = file("a.pgm", "P5\n2 1\n255\n\x80\x80");
  EXPECT_WITHIN(read_albedo_map(path, Coding::linear)(0, 0), 128.0 / 255, 1e-7, "untouched");
  const auto floats = file("a.pfm", float_map(2, 1, {0.5F, 0.5F}));
  // ((0.5 + 0.055)/1.055)^2.4 = 0.214041
  EXPECT_WITHIN(read_albedo_map(floats, Coding::srgb)(0, 0), 0.214041, 1e-6, "six digits");
}

TEST_F(ReadAlbedoMap, PngIsSrgb) {
  Image image(2, 1, {"Y"});
  image.values = {0.5F, 1};
  write_png(in_folder("a.png"), image, 16);
  EXPECT_WITHIN(read_albedo_map(in_folder("a.png"))(0, 0), 0.214041, 2e-5,
                "half a step of 16 bits");
}

TEST_F(ReadAlbedoMap, MustBeTwiceAsWideAsHigh) {
  EXPECT_ERROR(read_albedo_map(file("a.pgm", "P5\n3 2\n255\nabcdef")),
               "a.pgm: cannot be read: albedo map of 3 x 2 texels, allowed 2:1");
}

TEST_F(ReadAlbedoMap, MustBeWhole) {
  for (const int x : {-1, 1})
    EXPECT_ERROR(read_albedo_map(row_from(in_folder("a.exr"), x, 2, 2, {"Y"})),
                 "cropped from 2 x 1");
}

TEST_F(ReadAlbedoMap, MustBeNumbersOfZeroOrMore) {
  EXPECT_ERROR(read_albedo_map(file("a.pfm", float_map(2, 1, {1, NAN}))), "column 1 = nan");
  EXPECT_ERROR(read_albedo_map(file("b.pfm", float_map(2, 1, {1, -1}))), "column 1 = -1");
  EXPECT_ERROR(read_albedo_map(file("c.pfm", float_map(2, 1, {INFINITY, 1}))), "column 0 = inf");
}

/// Its mean would be of the one texel, and all others would be dark.
TEST_F(ReadAlbedoMap, MustNotBeOfOneTexelsLight) {
  std::vector<float> values(64 * 32, 0.3F);
  values[700] = 5;
  EXPECT_EQ(read_albedo_map(file("a.pfm", float_map(64, 32, values)))
                .values()[700 % 64 + (31 - 700 / 64) * 64],
            5)
      << "0.8 % of the light: a bright crater";
  values[700] = 1e5F;
  EXPECT_ERROR(read_albedo_map(file("a.pfm", float_map(64, 32, values))),
               "a.pfm: cannot be read: albedo at row 21, column 60 = 100000, and 99.9 % of the map "
               "is at most 0.3: the few "
               "beyond it give 99 % of its light, allowed 1 %");
}

}  // namespace read_image_test
