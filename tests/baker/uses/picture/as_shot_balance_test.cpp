// SPDX-License-Identifier: MIT
// Photographs whose maker's notes Exiv2 writes here.
#include "uses/picture/as_shot_balance.h"

#include <exiv2/exiv2.hpp>

#include "baker/texture/scratch_folder.h"
#include "support/testing.h"
#include "uses/picture/camera_colours.h"

namespace coppermoon::uses {
namespace {

class AsShotBalance : public ScratchFolder {
 protected:
  /// A grey photograph with a header.
  std::string photograph(const Exiv2::ExifData& header) const {
    auto photo =
        Exiv2::ImageFactory::create(Exiv2::ImageType::jpeg, in_folder("photo.jpg").string());
    photo->setExifData(header);
    photo->writeMetadata();
    return in_folder("photo.jpg").string();
  }

  /// A photograph of a Canon EOS 550D, whose colour data have 1338 numbers: red, green, green and blue from the 64th on.
  std::string by_canon(std::uint16_t red, std::uint16_t green, std::uint16_t blue,
                       std::size_t count = 1338) const {
    Exiv2::UShortValue value;
    value.value_.assign(count, 7);
    value.value_[63] = red;
    value.value_[64] = value.value_[65] = green;
    value.value_[66] = blue;
    Exiv2::ExifData header;
    header["Exif.Image.Make"] = "Canon";
    header["Exif.Image.Model"] = "Canon EOS 550D";
    header.add(Exiv2::ExifKey("Exif.Canon.ColorData"), &value);
    return photograph(header);
  }

  std::string by_nikon(const char* red_and_blue) const {
    Exiv2::ExifData header;
    header["Exif.Image.Make"] = "NIKON CORPORATION";
    header["Exif.Image.Model"] = "NIKON D3300";
    Exiv2::URationalValue value;
    value.read(red_and_blue);
    header.add(Exiv2::ExifKey("Exif.Nikon3.WB_RBLevels"), &value);
    return photograph(header);
  }
};

TEST_F(AsShotBalance, IsReadFromCanonsNotes) {
  const auto found = as_shot_balance(by_canon(1536, 1024, 2304));
  ASSERT_TRUE(found);
  EXPECT_EQ(*found, (std::array{1.5, 1., 2.25}));
}

TEST_F(AsShotBalance, IsReadFromNikonsNotes) {
  const auto found = as_shot_balance(by_nikon("468/256 406/256 256/256 256/256"));
  ASSERT_TRUE(found);
  EXPECT_EQ(*found, (std::array{1.828125, 1., 1.5859375}));
}

TEST_F(AsShotBalance, IsMissingWhereNotesDoNotTellIt) {
  EXPECT_FALSE(as_shot_balance(by_canon(1536, 1024, 2304, 1000))) << "a length of no camera";
  EXPECT_FALSE(as_shot_balance(by_canon(0, 1024, 2304))) << "outside 0.1 to 10";
  EXPECT_FALSE(as_shot_balance(photograph({})));
  EXPECT_FALSE(as_shot_balance(in_folder("nothing.jpg").string()));
}

TEST_F(AsShotBalance, MultipliesACamerasOwnChannels) {
  const auto daylight = camera_colours("canon-eos-600d", {});
  EXPECT_EQ(daylight.gains, glm::dvec3(1));
  const auto warm = camera_colours("canon-eos-600d", std::array{1.5, 1., 2.25}),
             cold = camera_colours("canon-eos-600d", std::array{3., 1., 1.125});
  EXPECT_NEAR(cold.gains.r / warm.gains.r, 2, 1e-12) << "a ratio of doubles";
  EXPECT_NEAR(cold.gains.b / warm.gains.b, 0.5, 1e-12) << "a ratio of doubles";
  EXPECT_EQ(camera_colours("colorimetric", std::array{1.5, 1., 2.25}).gains, glm::dvec3(1))
      << "whose channels are not known";
}

}  // namespace
}  // namespace coppermoon::uses
