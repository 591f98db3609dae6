// SPDX-License-Identifier: MIT
// Raw files as DNG has them: what is put under the mosaic comes back, read by LibRaw.
#include <tiffio.h>
#include <glm/matrix.hpp>
#include <memory>

#include "baker/texture/scratch_folder.h"
#include "support/testing.h"
#include "texture/read_image.h"
#include "texture/write_dng.h"
#include "texture/write_image.h"

namespace raw_test {

using namespace coppermoon::texture;
using Colour = glm::dvec3;  // linear Rec. 709

/// IEC 61966-2-1: XYZ of linear Rec. 709, by columns.
constexpr glm::dmat3 xyz_from_rec709{0.4124, 0.2126, 0.0193, 0.3576, 0.7152,
                                     0.1192, 0.1805, 0.0722, 0.9505};
/// A Canon EOS 6D's, by columns (dcraw's table).
constexpr glm::dmat3 canon{0.7034, -0.4420, -0.0851, -0.0804, 1.2564,
                           0.1994, -0.1014, 0.2058,  0.5758};
constexpr Colour white(1), copper(0.4, 0.12, 0.03), blue(0.05, 0.2, 0.3);

/// The camera's matrix such that its most sensitive channel has 1 of white.
glm::dmat3 camera_from_xyz() {
  const auto seen = canon * xyz_from_rec709 * white;
  return canon / std::max({seen.r, seen.g, seen.b});
}

struct Levels {
  double black_dn = 2047, white_dn = 15000;
};

/// What a sensor without noise counts of a picture, given as light by row and column.
template <class Light>
RawPhotograph photograph_of(std::size_t columns, std::size_t rows, const Light& light,
                            Levels levels = {}) {
  RawPhotograph photograph{.numbers = coppermoon::algebra::Grid<std::uint16_t>(rows, columns),
                           .black_dn = levels.black_dn,
                           .white_dn = levels.white_dn,
                           .camera_from_xyz = camera_from_xyz(),
                           .camera = "6d",
                           .focal_length_mm = 400};
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < columns; ++c) {
      const auto seen = photograph.camera_from_xyz * xyz_from_rec709 * light(r, c);
      const double number = levels.black_dn + (levels.white_dn - levels.black_dn) *
                                                  seen[static_cast<int>(r % 2 + c % 2)];
      photograph.numbers(r, c) =
          static_cast<std::uint16_t>(std::clamp(std::round(number), 0., levels.white_dn));
    }
  return photograph;
}

const auto evenly = [](const Colour& colour) {
  return [colour](std::size_t, std::size_t) { return colour; };
};

class Raw : public ScratchFolder {
 protected:
  /// Changes tags of a file that is there.
  template <class Change>
  void retag(const std::string& name, const Change& change) {
    const std::unique_ptr<TIFF, void (*)(TIFF*)> file(TIFFOpen(in_folder(name).c_str(), "r+"),
                                                      &TIFFClose);
    ASSERT_TRUE(file);
    change(file.get());
    ASSERT_EQ(TIFFRewriteDirectory(file.get()), 1);
  }

  Image written_and_read(const RawPhotograph& photograph) {
    write_dng(in_folder("a.dng"), photograph);
    return read_light(in_folder("a.dng"));
  }
};

void expect_colour(const Image& image, std::size_t row, std::size_t column, const Colour& colour) {
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_WITHIN(
        image(row, column, k), colour[static_cast<int>(k)], 5e-4,
        "half a step of 12953 and half one of 65535, by a matrix of up to 3 a row; XYZ of "
        "white differs by 1e-4")
        << "channel " << k << " at " << row << ", " << column;
}

TEST_F(Raw, EvenLightComesBack) {
  for (const auto& colour : {0.5 * white, copper, blue, 0.01 * white, 0. * white}) {
    const auto light = written_and_read(photograph_of(40, 30, evenly(colour)));
    ASSERT_EQ(light.width, 40U);
    ASSERT_EQ(light.height, 30U);
    EXPECT_EQ(light.channels, (std::vector<std::string>{"R", "G", "B"}));
    for (const auto& [r, c] : std::vector<std::pair<std::size_t, std::size_t>>{
             {0, 0}, {1, 39}, {15, 20}, {16, 21}, {29, 0}})
      expect_colour(light, r, c, colour);
  }
}

TEST_F(Raw, ColoursOutsideTheGamutStayBelowZero) {
  const Colour cyan(-0.05, 0.4, 0.3);
  expect_colour(written_and_read(photograph_of(40, 30, evenly(cyan))), 15, 20, cyan);
}

TEST_F(Raw, LevelsAreTheFilesOwn) {
  for (const Levels levels : {Levels{0, 65535}, Levels{124, 4095}, Levels{512, 16383}}) {
    const auto light = written_and_read(photograph_of(40, 30, evenly(copper), levels));
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_WITHIN(light(15, 20, k), copper[static_cast<int>(k)], 1e-3,
                    "half a step of 3971, by a matrix of up to 3 a row");
  }
}

TEST_F(Raw, EveryPatchStaysWhereItIs) {
  const auto light = written_and_read(photograph_of(64, 48, [](std::size_t r, std::size_t c) {
    if (r >= 8 && r < 20 && c >= 40 && c < 56) return copper;
    return r >= 30 && c < 10 ? blue : 0.2 * white;
  }));
  expect_colour(light, 14, 48, copper);
  expect_colour(light, 40, 5, blue);
  for (const auto& [r, c] :
       std::vector<std::pair<std::size_t, std::size_t>>{{14, 15}, {34, 48}, {5, 5}, {40, 50}})
    expect_colour(light, r, c, 0.2 * white);
}

TEST_F(Raw, LightThatGrowsEvenlyIsInterpolatedWithoutError) {
  const auto slope = [](std::size_t r, std::size_t c) {
    return copper * (0.5 + 0.01 * static_cast<double>(c) + 0.005 * static_cast<double>(r));
  };
  const auto light = written_and_read(photograph_of(64, 48, slope));
  for (std::size_t r = 1; r < 47; ++r)
    for (std::size_t c = 1; c < 63; ++c) expect_colour(light, r, c, slope(r, c));
}

TEST_F(Raw, APixelIsMadeOfItsNeighboursAlone) {
  const auto spot = [](std::size_t r, std::size_t c) {
    return r == 20 && c == 30 ? 0.9 * white : 0.1 * white;
  };
  const auto light = written_and_read(photograph_of(64, 48, spot));
  EXPECT_GT(light(20, 30, 0), 0.4F);
  for (std::size_t r = 0; r < 48; ++r)
    for (std::size_t c = 0; c < 64; ++c)
      if (r < 19 || r > 21 || c < 29 || c > 31) expect_colour(light, r, c, 0.1 * white);
}

TEST_F(Raw, TheCamerasWhiteBalanceDoesNotMatter) {
  const auto by_daylight = written_and_read(photograph_of(40, 30, evenly(copper)));
  retag("a.dng", [](TIFF* file) {
    const std::array<float, 3> lamps{0.9F, 1, 0.3F};
    EXPECT_EQ(TIFFSetField(file, TIFFTAG_ASSHOTNEUTRAL, 3, lamps.data()), 1);
  });
  EXPECT_EQ(read_light(in_folder("a.dng")).values, by_daylight.values);
}

TEST_F(Raw, IsTurnedUprightOnce) {
  write_dng(in_folder("a.dng"), photograph_of(64, 40, [](std::size_t r, std::size_t c) {
              return r < 10 && c < 16 ? copper : 0.2 * white;
            }));
  retag("a.dng", [](TIFF* file) {
    EXPECT_EQ(TIFFSetField(file, TIFFTAG_ORIENTATION, ORIENTATION_RIGHTTOP), 1);
  });
  const auto light = read_light(in_folder("a.dng"));
  ASSERT_EQ(light.width, 40U) << "its right side is up: it is turned by a quarter, clockwise";
  ASSERT_EQ(light.height, 64U);
  expect_colour(light, 8, 35, copper);
  expect_colour(light, 8, 5, 0.2 * white);
  expect_colour(light, 55, 35, 0.2 * white);
}

TEST_F(Raw, WhatIsClippedIsWhiteAndNothingIsAbove) {
  // 0.9 of white is not clipped; of the light beside it green is, in the second red alone
  for (const Colour& bright : {1.3 * white, Colour(2, 0.5, 0.1)}) {
    const auto light = written_and_read(photograph_of(
        64, 48, [&](std::size_t, std::size_t c) { return c >= 32 ? bright : 0.9 * white; }));
    for (const float value : light.values) EXPECT_LE(value, 1.F);
    for (std::size_t r = 4; r < 44; ++r) {
      for (std::size_t c = 31; c < 60; ++c)
        for (std::size_t k = 0; k < 3; ++k)
          EXPECT_EQ(light(r, c, k), 1.F) << "an even field, and what is interpolated from it";
      for (std::size_t c = 4; c < 30; ++c) expect_colour(light, r, c, 0.9 * white);
    }
  }
}

TEST_F(Raw, WhiteSaturatesAtOne) {
  expect_colour(written_and_read(photograph_of(40, 30, evenly(0.985 * white))), 15, 20,
                0.985 * white);
  const auto light = written_and_read(photograph_of(40, 30, evenly(white)));
  EXPECT_EQ(light(15, 20, 0), 1.F);
}

TEST_F(Raw, ExifSaysTimeExposureAndFocalLength) {
  write_dng(in_folder("a.dng"), photograph_of(40, 30, evenly(copper)),
            {{"capDate", "2008:02:21 03:08:26"},
             {"expTime", 0.004F},
             {"aperture", 0.95F},
             {"isoSpeed", 800.F}});
  const auto number = [&](const char* name) {
    return std::stod(read_attribute(in_folder("a.dng"), name).value_or("nan"));
  };
  EXPECT_WITHIN_RELATIVE(number("expTime"), 0.004, 1e-5, "read in six digits");
  EXPECT_WITHIN_RELATIVE(number("aperture"), 0.95, 1e-5, "read in six digits");
  EXPECT_WITHIN_RELATIVE(number("Exif:FocalLength"), 400, 1e-5, "read in six digits");
  EXPECT_EQ(number("Exif:PhotographicSensitivity"), 800);
  EXPECT_EQ(read_attribute(in_folder("a.dng"), "Exif:DateTimeOriginal"), "2008:02:21 03:08:26");
  EXPECT_EQ(read_attribute(in_folder("a.dng"), "Exif:OffsetTimeOriginal"), "+00:00");
}

TEST_F(Raw, TheSameGivesTheSameBytes) {
  const auto photograph = photograph_of(40, 30, evenly(copper));
  for (const char* name : {"a.dng", "b.dng"}) write_dng(in_folder(name), photograph);
  EXPECT_EQ(bytes_of(in_folder("a.dng")), bytes_of(in_folder("b.dng")));
}

TEST_F(Raw, IsKnownByTheEndingOfItsName) {
  write_dng(in_folder("A.DNG"), photograph_of(40, 30, evenly(copper)));
  EXPECT_TRUE(is_raw_file(in_folder("A.DNG")));
  write_tiff(in_folder("a.tif"), Image(40, 30, {"R", "G", "B"}));
  EXPECT_FALSE(is_raw_file(in_folder("a.tif")));
  expect_colour(read_light(in_folder("A.DNG")), 15, 20, copper);
  expect_colour(read_light(in_folder("A.DNG"), Coding::linear), 15, 20, copper);
}

TEST_F(Raw, IsRefusedWhereItCannotBeLight) {
  write_dng(in_folder("a.dng"), photograph_of(40, 30, evenly(copper)));
  EXPECT_ERROR(read_light(in_folder("a.dng"), Coding::srgb), "a raw file coded as sRGB");
  write_dng(in_folder("map.dng"), photograph_of(80, 40, evenly(copper)));
  EXPECT_ERROR(read_albedo_map(in_folder("map.dng")), "albedo map in a raw file");
  retag("a.dng", [](TIFF* file) { EXPECT_EQ(TIFFUnsetField(file, TIFFTAG_COLORMATRIX1), 1); });
  EXPECT_ERROR(read_light(in_folder("a.dng")),
               "no colour matrix is known of the camera coppermoon 6d");
}

TEST_F(Raw, ThatEndsEarlyIsRefused) {
  write_dng(in_folder("a.dng"), photograph_of(40, 30, evenly(copper)));
  const auto bytes = bytes_of(in_folder("a.dng"));
  for (const std::size_t length : {std::size_t{8}, std::size_t{100}, bytes.size() / 2})
    EXPECT_THROW(read_light(file("cut.dng", bytes.substr(0, length))), coppermoon::algebra::Error)
        << length << " bytes";
}

TEST_F(Raw, OfNoUseIsNotWritten) {
  const auto refused = [&](auto change) {
    auto photograph = photograph_of(40, 30, evenly(copper));
    change(photograph);
    write_dng(in_folder("no.dng"), photograph);
  };
  EXPECT_ERROR(refused([](auto& p) { p.numbers = {}; }), "without a pixel");
  EXPECT_ERROR(refused([](auto& p) { p.white_dn = p.black_dn; }), "white level [DN] = 2047");
  EXPECT_ERROR(refused([](auto& p) { p.white_dn = 70000; }), "white level [DN] = 70000");
  EXPECT_ERROR(refused([](auto& p) { p.camera_from_xyz = glm::dmat3(0); }),
               "least channel of white = 0");
  EXPECT_ERROR(refused([](auto& p) { p.focal_length_mm = 0; }), "focal length [mm] = 0");
  EXPECT_FALSE(std::filesystem::exists(in_folder("no.dng")));
  EXPECT_ERROR(write_dng(in_folder("no/a.dng"), photograph_of(40, 30, evenly(copper))), "a.dng");
}

}  // namespace raw_test
