// SPDX-License-Identifier: MIT
// Images that say how they are stored: each thing that changes what their numbers mean is heeded, or
// refused with its name.
#include <OpenImageIO/imageio.h>
#include <lcms2.h>
#include <tiffio.h>
#include <cstring>

#include "baker/texture/fits_bytes.h"
#include "baker/texture/scratch_folder.h"
#include "support/testing.h"
#include "texture/read_image.h"

namespace how_stored_test {

using namespace coppermoon::texture;

/// A TIFF of one strip, with whatever tags are set.
struct Tiff {
  std::uint32_t width = 2, height = 1;
  std::uint16_t photometric = PHOTOMETRIC_MINISBLACK, bits = 8, bands = 1,
                format = SAMPLEFORMAT_UINT;
  std::function<void(TIFF*)> more{};
};

/// GDAL's tags, which libtiff writes only when they are told to it.
void know_gdal(TIFF* tiff) {
  static char metadata[] = "GDAL_METADATA", no_data[] = "GDAL_NODATA";
  static const std::array fields{
      TIFFFieldInfo{42112, -1, -1, TIFF_ASCII, FIELD_CUSTOM, 1, 0, metadata},
      TIFFFieldInfo{42113, -1, -1, TIFF_ASCII, FIELD_CUSTOM, 1, 0, no_data}};
  TIFFMergeFieldInfo(tiff, fields.data(), static_cast<std::uint32_t>(fields.size()));
}

class HowStored : public ScratchFolder {
 protected:
  template <class Number>
  std::filesystem::path tiff(const std::vector<Number>& numbers, const Tiff& as = {}) const {
    const auto path = in_folder("a.tif");
    TIFF* made = TIFFOpen(path.c_str(), "w");
    know_gdal(made);
    TIFFSetField(made, TIFFTAG_IMAGEWIDTH, as.width);
    TIFFSetField(made, TIFFTAG_IMAGELENGTH, as.height);
    TIFFSetField(made, TIFFTAG_BITSPERSAMPLE, as.bits);
    TIFFSetField(made, TIFFTAG_SAMPLESPERPIXEL, as.bands);
    TIFFSetField(made, TIFFTAG_PHOTOMETRIC, as.photometric);
    TIFFSetField(made, TIFFTAG_SAMPLEFORMAT, as.format);
    TIFFSetField(made, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(made, TIFFTAG_ROWSPERSTRIP, as.height);
    if (as.more) as.more(made);
    auto bytes = numbers;
    TIFFWriteEncodedStrip(made, 0, bytes.data(),
                          static_cast<tmsize_t>(bytes.size() * sizeof(Number)));
    TIFFClose(made);
    return path;
  }

  std::filesystem::path fits(std::string_view name, const std::string& cards,
                             std::string data) const {
    return file(name, fits_bytes(cards, std::move(data)));
  }
};

std::vector<float> reds(const Image& image) {
  std::vector<float> values;
  for (std::size_t i = 0; i < image.values.size(); i += 3) values.push_back(image.values[i]);
  return values;
}

std::vector<float> numbers(const coppermoon::algebra::Grid<float>& map) {
  return {map.values().begin(), map.values().end()};
}

/// Numbers 0 to 7 of a picture 4 wide, as it is to be seen, from the eight ways to store it.
TEST_F(HowStored, OrientationTurnsPhotographsAndMapsUpright) {
  const std::vector<float> upright{0, 1, 2, 3, 4, 5, 6, 7};
  const std::array<std::vector<float>, 8> stored{{{0, 1, 2, 3, 4, 5, 6, 7},
                                                  {3, 2, 1, 0, 7, 6, 5, 4},
                                                  {7, 6, 5, 4, 3, 2, 1, 0},
                                                  {4, 5, 6, 7, 0, 1, 2, 3},
                                                  {0, 4, 1, 5, 2, 6, 3, 7},
                                                  {3, 7, 2, 6, 1, 5, 0, 4},
                                                  {7, 3, 6, 2, 5, 1, 4, 0},
                                                  {4, 0, 5, 1, 6, 2, 7, 3}}};
  for (std::uint16_t orientation = 1; orientation <= 8; ++orientation) {
    const bool on_side = orientation >= 5;
    const auto path =
        tiff(stored[orientation - 1U],
             {.width = on_side ? 2U : 4U,
              .height = on_side ? 4U : 2U,
              .bits = 32,
              .format = SAMPLEFORMAT_IEEEFP,
              .more = [&](TIFF* t) { TIFFSetField(t, TIFFTAG_ORIENTATION, orientation); }});
    const auto light = read_light(path);
    EXPECT_EQ(light.width, 4) << orientation;
    EXPECT_EQ(reds(light), upright) << orientation;
    require_albedo_map(path);
    const auto map = read_albedo_map(path);
    EXPECT_EQ(map.columns(), 4) << orientation;
    EXPECT_EQ(numbers(map), upright) << orientation;
  }
}

TEST_F(HowStored, WhereWhiteIsZeroNumbersAreTurnedRound) {
  for (const std::uint16_t bits : {std::uint16_t{8}, std::uint16_t{16}}) {
    const Tiff as{.photometric = PHOTOMETRIC_MINISWHITE, .bits = bits};
    const auto path = bits == 8 ? tiff(std::vector<std::uint8_t>{0, 255}, as)
                                : tiff(std::vector<std::uint16_t>{0, 65535}, as);
    EXPECT_EQ(numbers(read_albedo_map(path)), (std::vector<float>{1, 0})) << bits;
    EXPECT_EQ(reds(read_light(path)), (std::vector<float>{1, 0})) << bits;
  }
  const Tiff floats{
      .photometric = PHOTOMETRIC_MINISWHITE, .bits = 32, .format = SAMPLEFORMAT_IEEEFP};
  EXPECT_ERROR(read_light(tiff(std::vector<float>{0, 1}, floats)),
               "PhotometricInterpretation = 0 (white is zero)");
}

TEST_F(HowStored, OtherPhotometricInterpretationsAreRefusedByName) {
  const std::vector<std::uint8_t> grey{1, 2}, colours{1, 2, 3, 4, 5, 6};
  EXPECT_ERROR(read_light(tiff(colours, {.photometric = PHOTOMETRIC_CIELAB, .bands = 3})),
               "PhotometricInterpretation = 8 (CIE L*a*b*)");
  EXPECT_ERROR(read_albedo_map(tiff(grey, {.photometric = PHOTOMETRIC_MASK})),
               "PhotometricInterpretation = 4 (a mask)");
  EXPECT_ERROR(require_albedo_map(tiff(grey, {.photometric = PHOTOMETRIC_CFA})),
               "PhotometricInterpretation = 32803 (a camera's mosaic)");
}

TEST_F(HowStored, BandsThatAreNoColoursAreRefused) {
  const std::vector<std::uint8_t> data(14, 200);
  const auto extra = [](std::uint16_t count, std::uint16_t kind) {
    return [=](TIFF* t) {
      const std::vector<std::uint16_t> kinds(count, kind);
      TIFFSetField(t, TIFFTAG_EXTRASAMPLES, count, kinds.data());
    };
  };
  EXPECT_ERROR(read_light(tiff(data, {.bands = 7, .more = extra(6, EXTRASAMPLE_UNSPECIFIED)})),
               "7 bands, and nothing says which of them are colours");
  EXPECT_NO_THROW(read_albedo_map(tiff(data, {.bands = 2, .more = extra(1, 0)})))
      << "grey, and an alpha that does not say so";
  const Tiff more{.photometric = PHOTOMETRIC_RGB, .bands = 4, .more = extra(1, 0)};
  EXPECT_EQ(read_light(tiff(data, more)).width, 2);
}

TEST_F(HowStored, GroundWithoutDataIsRefused) {
  const std::vector<std::uint8_t> hole{200, 0};
  const auto no_data = [](const char* text) {
    return [=](TIFF* t) { TIFFSetField(t, 42113, text); };
  };
  EXPECT_ERROR(read_albedo_map(tiff(hole, {.more = no_data("0")})), "has no data (GDAL_NODATA)");
  EXPECT_ERROR(read_albedo_map(tiff(std::vector<std::uint16_t>{9, 65535},
                                    {.bits = 16, .more = no_data("65535")})),
               "has no data (GDAL_NODATA)");
  EXPECT_ERROR(
      read_albedo_map(tiff(std::vector<float>{1, 2e38F},
                           {.bits = 32, .format = SAMPLEFORMAT_IEEEFP, .more = no_data("2e38")})),
      "has no data (GDAL_NODATA)");
  EXPECT_EQ(read_albedo_map(tiff(hole, {.more = no_data("7")})).rows(), 1);
  const auto alpha = [](TIFF* t) {
    const std::uint16_t kind = EXTRASAMPLE_UNASSALPHA;
    TIFFSetField(t, TIFFTAG_EXTRASAMPLES, 1, &kind);
  };
  EXPECT_ERROR(read_albedo_map(
                   tiff(std::vector<std::uint8_t>{200, 255, 200, 0}, {.bands = 2, .more = alpha})),
               "is transparent at row 0");
}

TEST_F(HowStored, TagsThatNobodyHeedsAreRefusedByName) {
  const std::vector<std::uint8_t> data{100, 200};
  EXPECT_ERROR(
      read_light(tiff(
          data,
          {.more = [](TIFF* t) { TIFFSetField(t, TIFFTAG_SUBFILETYPE, FILETYPE_REDUCEDIMAGE); }})),
      "thumbnail");
  EXPECT_ERROR(read_light(tiff(data, {.more =
                                          [](TIFF* t) {
                                            const std::vector<std::uint16_t> curve(256, 7);
                                            TIFFSetField(t, TIFFTAG_TRANSFERFUNCTION, curve.data());
                                          }})),
               "TransferFunction");
  EXPECT_ERROR(
      read_light(tiff(data, {.more =
                                 [](TIFF* t) {
                                   const std::array xy{0.7F, 0.3F, 0.2F, 0.7F, 0.15F, 0.05F};
                                   TIFFSetField(t, TIFFTAG_PRIMARYCHROMATICITIES, xy.data());
                                 }})),
      "PrimaryChromaticities");
  EXPECT_ERROR(read_light(tiff(
                   data, {.more =
                              [](TIFF* t) {
                                TIFFSetField(t, 42112,
                                             "<GDALMetadata>\n<Item name=\"OFFSET\" sample=\"0\" "
                                             "role=\"offset\">10</Item>\n</GDALMetadata>");
                              }})),
               "GDAL's offset = 10");
  EXPECT_ERROR(read_light(tiff(data, {.more =
                                          [](TIFF* t) {
                                            const std::array<std::uint8_t, 4> dng{1, 4, 0, 0};
                                            TIFFSetField(t, TIFFTAG_DNGVERSION, dng.data());
                                          }})),
               "raw file that does not end as one");
}

/// A profile of linear light with the primaries of Rec. 709, red and green exchanged.
std::string exchanged_profile() {
  const cmsCIExyY white{0.3127, 0.329, 1};
  const cmsCIExyYTRIPLE primaries{{0.3, 0.6, 1}, {0.64, 0.33, 1}, {0.15, 0.06, 1}};
  cmsToneCurve* linear = cmsBuildGamma(nullptr, 1);
  cmsToneCurve* curves[]{linear, linear, linear};
  const auto profile = cmsCreateRGBProfile(&white, &primaries, curves);
  cmsUInt32Number size = 0;
  cmsSaveProfileToMem(profile, nullptr, &size);
  std::string bytes(size, '\0');
  cmsSaveProfileToMem(profile, bytes.data(), &size);
  cmsCloseProfile(profile);
  cmsFreeToneCurve(linear);
  return bytes;
}

TEST_F(HowStored, AColourProfileSaysWhatNumbersMean) {
  const auto icc = exchanged_profile();
  const auto path = tiff(std::vector<std::uint8_t>{51, 102, 153, 51, 102, 153},
                         {.photometric = PHOTOMETRIC_RGB, .bands = 3, .more = [&](TIFF* t) {
                            TIFFSetField(t, TIFFTAG_ICCPROFILE,
                                         static_cast<std::uint32_t>(icc.size()), icc.data());
                          }});
  const auto light = read_light(path);
  const char* reason = "an ICC profile's numbers have 16 bits behind the point";
  EXPECT_WITHIN(light(0, 0, 0), 0.4, 2e-4, reason);
  EXPECT_WITHIN(light(0, 0, 1), 0.2, 2e-4, reason);
  EXPECT_WITHIN(light(0, 0, 2), 0.6, 2e-4, reason);
  EXPECT_WITHIN(read_albedo_map(path)(0, 1), 0.2126 * 0.4 + 0.7152 * 0.2 + 0.0722 * 0.6, 2e-4,
                reason);
  EXPECT_WITHIN(read_light(path, Coding::linear)(0, 0, 0), 0.2, 1e-6, "as the user says");
  EXPECT_ERROR(read_light(tiff(std::vector<std::uint8_t>{1, 2},
                               {.more =
                                    [&](TIFF* t) {
                                      TIFFSetField(t, TIFFTAG_ICCPROFILE,
                                                   static_cast<std::uint32_t>(icc.size()),
                                                   icc.data());
                                    }})),
               "which is of other channels");
  EXPECT_ERROR(
      read_light(
          tiff(std::vector<std::uint8_t>{1, 2},
               {.more = [&](TIFF* t) { TIFFSetField(t, TIFFTAG_ICCPROFILE, 9U, icc.data()); }})),
      "a broken colour profile (ICC)");
}

TEST_F(HowStored, PrimariesOfAnExrAreHeeded) {
  OIIO::ImageSpec spec(1, 1, 3, OIIO::TypeDesc::FLOAT);
  const std::array chromaticities{0.3F, 0.6F, 0.64F, 0.33F, 0.15F, 0.06F, 0.3127F, 0.329F};
  spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), chromaticities.data());
  const auto output = OIIO::ImageOutput::create("openexr");
  const std::array rgb{1.F, 2.F, 3.F};
  ASSERT_TRUE(output->open(in_folder("a.exr").string(), spec));
  ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, rgb.data()));
  output->close();
  const auto light = read_light(in_folder("a.exr"));
  EXPECT_WITHIN(light(0, 0, 0), 2, 1e-4, "a matrix of floats");
  EXPECT_WITHIN(light(0, 0, 1), 1, 1e-4, "a matrix of floats");
}

/// Numbers of AP1 are of light whose white is D60: white stays white, and red is deeper than Rec.709's.
TEST_F(HowStored, SpaceThatAnExrNamesIsHeeded) {
  const auto red = [&](const std::string& id, bool chromaticities) {
    OIIO::ImageSpec spec(2, 1, 3, OIIO::TypeDesc::FLOAT);
    const std::array rec709{0.64F, 0.33F, 0.3F, 0.6F, 0.15F, 0.06F, 0.3127F, 0.329F};
    if (chromaticities)
      spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), rec709.data());
    spec.attribute("colorInteropID", id);
    const auto output = OIIO::ImageOutput::create("openexr");
    const std::array rgb{1.F, 0.F, 0.F, 1.F, 1.F, 1.F};
    EXPECT_TRUE(output->open(in_folder("a.exr").string(), spec));
    EXPECT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, rgb.data()));
    output->close();
    const auto light = read_light(in_folder("a.exr"));
    EXPECT_WITHIN(light(0, 1, 1), 1, 1e-4, "a matrix of floats");
    return light(0, 0, 0);
  };
  for (const bool chromaticities : {false, true}) {
    EXPECT_WITHIN(red("lin_ap1_scene", chromaticities), 1.70505, 1e-3,
                  "published to as many digits: ACEScg to linear Rec.709, Bradford");
    for (const char* as_it_is : {"lin_rec709_scene", "data", "unknown"})
      EXPECT_EQ(red(as_it_is, chromaticities), 1) << as_it_is;
  }
  EXPECT_ERROR(red("srgb_rec709_scene", false),
               "a.exr: cannot be read: colorInteropID = \"srgb_rec709_scene\", allowed data, "
               "unknown, lin_rec709_scene, lin_ap0_scene");
}

/// A WebP of two pixels, white and black, with no loss; chunks behind it.
std::string webp(const std::filesystem::path& path, const std::string& chunks) {
  OIIO::ImageSpec spec(2, 1, 3, OIIO::TypeDesc::UINT8);
  spec.attribute("compression", "lossless:100");
  const auto output = OIIO::ImageOutput::create("webp");
  const std::array<std::uint8_t, 6> rgb{255, 255, 255, 0, 0, 0};
  EXPECT_TRUE(output->open(path.string(), spec));
  EXPECT_TRUE(output->write_image(OIIO::TypeDesc::UINT8, rgb.data()));
  output->close();
  return bytes_of(path) + chunks;
}

TEST_F(HowStored, OrientationOfAWebPIsHeeded) {
  using namespace std::string_literals;
  // one tag, Orientation = 6, a SHORT
  const auto exif = "II*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0\x06\0\0\0\0\0\0\0"s;
  const auto path = in_folder("a.webp");
  const auto upright = read_light(file("b.webp", webp(path, "")));
  EXPECT_EQ(upright.width, 2);
  const auto light = read_light(file("c.webp", webp(path, "EXIF\x1A\0\0\0"s + exif)));
  EXPECT_EQ(light.width, 1);
  EXPECT_EQ(light.height, 2);
}

const std::string two_by_two = "NAXIS   = 2\nNAXIS1  = 2\nNAXIS2  = 2\n";

TEST_F(HowStored, FitsIsLightByItsScaleFromTheTop) {
  using namespace std::string_literals;
  const auto unsigned_16 = fits(
      "a.fit",
      "SIMPLE  = T\nBITPIX  = 16\n" + two_by_two + "BZERO   = 32768 / offset\nBSCALE  = 1.D0\n",
      "\x80\x00\x7f\xff\x00\x00\xff\xff"s);
  const auto is = reds(read_light(unsigned_16));
  EXPECT_WITHIN(is[0], 32768. / 65535, 1e-6, "a float's rounding");
  EXPECT_WITHIN(is[1], 32767. / 65535, 1e-6, "a float's rounding");
  EXPECT_EQ(is[2], 0);
  EXPECT_EQ(is[3], 1);
  const auto floats = fits("a.fts",
                           "SIMPLE  = T\nBITPIX  = -32\n" + two_by_two +
                               "BZERO   = 1\nBSCALE  = 2\nROWORDER= 'TOP-DOWN'\n",
                           "\0\0\0\0\x3f\x80\0\0\x40\0\0\0\x3f\0\0\0"s);
  EXPECT_EQ(reds(read_light(floats)), (std::vector<float>{1, 3, 5, 2}));
  const auto bytes = fits("a.png",
                          "SIMPLE  = T\nBITPIX  = 8\nNAXIS   = 3\nNAXIS1  = 1\n"
                          "NAXIS2  = 1\nNAXIS3  = 3\n",
                          "\x33\x66\xff"s);
  EXPECT_EQ(read_light(bytes).values, (std::vector<float>{0.2F, 0.4F, 1}));
}

TEST_F(HowStored, FitsThatIsNoPictureIsRefused) {
  using namespace std::string_literals;
  const std::string begin = "SIMPLE  = T\nBITPIX  = 16\n" + two_by_two;
  EXPECT_ERROR(read_light(fits("a.fits", begin + "BLANK   = 7\n", "\0\7\0\1\0\1\0\1"s)),
               "not finite");
  EXPECT_ERROR(read_light(fits("a.fits", begin + "BAYERPAT= 'RGGB    '\n", std::string(8, 'a'))),
               "BAYERPAT = RGGB, a mosaic");
  EXPECT_ERROR(read_light(fits("a.fits", begin, "")), "it ends early");
  EXPECT_ERROR(read_light(fits("a.fits", "SIMPLE  = T\nBITPIX  = 8\nNAXIS   = 0\n", "")),
               "NAXIS = 0");
  EXPECT_ERROR(read_light(file("b.fits", "SIMPLE  =  T")), "error reading from FITS file");
  EXPECT_ERROR(
      read_light(fits(
          "a.fits", "SIMPLE  = T\nBITPIX  = 8\nNAXIS   = 2\nNAXIS1  = 1048577\nNAXIS2  = 1\n", "")),
      "NAXIS1 = 1048577, allowed 1 to 1048576");
  EXPECT_ERROR(
      read_light(fits(
          "a.fits", "SIMPLE  = T\nBITPIX  = 8\nNAXIS   = 2\nNAXIS1  = 1000000\nNAXIS2  = 1000000\n",
          "")),
      "it ends early");
  EXPECT_ERROR(read_light(file("packed.fits", "\x1F\x8B\x08")),
               "no FITS file, which begins with SIMPLE");
}

/// CFITSIO's extended syntax would take them for filters, for files of memory, and for addresses.
TEST_F(HowStored, NamesOfFitsFilesAreOnlyNames) {
  std::filesystem::create_directories(in_folder("mem:"));
  for (const char* name : {"a.fits[1]", "!a.fits", "~a.fits", "a.fits(b.fits)", "mem:/a.fits"}) {
    const auto path = fits(name, "SIMPLE  = T\nBITPIX  = 8\n" + two_by_two, "\x33\x66\xff\xff");
    EXPECT_EQ(read_light(path).width, 2) << name;
  }
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(in_folder("."));
  EXPECT_EQ(read_light("~a.fits").width, 2);
  std::filesystem::current_path(before);
}

TEST_F(HowStored, CardsOfFitsAreAttributes) {
  const auto path =
      fits("a.fits",
           "SIMPLE  = T\nBITPIX  = 16\n" + two_by_two +
               "BZERO   = 32768\nDATE-OBS= '2022-05-16'\nTIME-OBS= '04:11:32'\n"
               "EXPTIME = 2.5D0 / [s]\nGAIN    = 120\nISOSPEED= 800\nDATAMAX = 16383.75\n",
           std::string(8, 'a'));
  using namespace std::string_view_literals;
  const std::array names{"Exif:DateTimeOriginal"sv,
                         "TIMESYS"sv,
                         "expTime"sv,
                         "GAIN"sv,
                         "Exif:PhotographicSensitivity"sv,
                         "coppermoon:clipped_at"sv};
  const auto is = read_attributes(path, names);
  const std::array should{"2022-05-16T04:11:32", "UTC", "2.5", "120", "800", "0.25"};
  for (std::size_t i = 0; i < names.size(); ++i) EXPECT_EQ(is[i], should[i]) << names[i];
}

TEST_F(HowStored, EndingsDoNotSayWhatAFileIs) {
  const auto hdr = file("a.png",
                        "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n+Y 1 +X 2\n"
                        "\x80\x80\x80\x81\x40\x40\x40\x81");
  EXPECT_EQ(reds(read_light(hdr)).size(), 2);
}

}  // namespace how_stored_test
