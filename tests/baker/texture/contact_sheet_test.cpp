// SPDX-License-Identifier: MIT
#include "texture/contact_sheet.h"

#include "baker/texture/scratch_folder.h"
#include "support/testing.h"
#include "texture/write_image.h"

namespace contact_sheet_test {

using namespace coppermoon::texture;

class ContactSheetOf : public ScratchFolder {
 protected:
  /// A picture of 48 x 32 pixels in one grey.
  SheetPicture grey(float level, bool marked = false, const std::string& text = {}) const {
    Image picture(48, 32, {"R", "G", "B"});
    std::ranges::fill(picture.values, level);
    const auto file = in_folder(fmt::format("{}.png", level));
    write_png(file, picture, 8);
    return {file, text, text, marked};
  }
};

float brightest(const Image& sheet, std::size_t top, std::size_t left, std::size_t rows,
                std::size_t columns) {
  float most = 0;
  for (std::size_t r = top; r < top + rows; ++r)
    for (std::size_t c = left; c < left + columns; ++c) most = std::max(most, sheet(r, c, 0));
  return most;
}

TEST_F(ContactSheetOf, FiveStandsRowByRowInTheirOwnCells) {
  ContactSheet sheet{"", {}, 3, sheet_font()};
  for (const float level : {0.1F, 0.3F, 0.5F, 0.7F, 0.9F}) sheet.pictures.push_back(grey(level));
  const auto image = drawn(sheet);
  const auto grid = sheet_grid(5, 3, 48, 32);
  ASSERT_EQ(grid.rows, 2);
  ASSERT_EQ(image.width, grid.width());
  ASSERT_EQ(image.height, grid.height());
  for (std::size_t i = 0; i < 5; ++i)
    for (const std::size_t c : {std::size_t{0}, SheetGrid::picture_width - 1})
      EXPECT_WITHIN(image(grid.top(i) + grid.picture_height / 2, grid.left(i) + c, 0),
                    0.1F + 0.2F * static_cast<float>(i), 0.6F / 255, "half a step of 8 bits");
  EXPECT_EQ(brightest(image, grid.top(5), grid.left(5), grid.picture_height, 240), 0)
      << "no sixth picture";
  EXPECT_EQ(brightest(image, 0, 0, image.height, SheetGrid::gap), 0) << "black around";
}

TEST_F(ContactSheetOf, OnePictureIsNoWiderThanIt) {
  const auto image = drawn({"", {grey(0.5F)}, 8, sheet_font()});
  EXPECT_EQ(image.width, SheetGrid::picture_width + 2 * SheetGrid::gap);
}

TEST_F(ContactSheetOf, FinePatternsAveragesLightNotItsCode) {
  // Half white, half black is half of the light: sRGB 1.055 · 0.5^(1/2.4) − 0.055 = 0.7354.
  Image board(960, 640, {"R", "G", "B"});
  for (std::size_t r = 0; r < board.height; ++r)
    for (std::size_t c = 0; c < board.width; ++c)
      for (std::size_t k = 0; k < 3; ++k) board(r, c, k) = static_cast<float>((r + c) % 2);
  write_png(in_folder("board.png"), board, 8);
  const auto image = drawn({"", {{in_folder("board.png"), "", ""}}, 1, sheet_font()});
  const auto grid = sheet_grid(1, 1, 960, 640);
  EXPECT_WITHIN(image(grid.top(0) + 80, grid.left(0) + 120, 1), 0.7354, 0.002,
                "the filter's weights are even to single precision");
}

TEST_F(ContactSheetOf, ALongTitleFitsBetweenItsSides) {
  const std::string title = "Total eclipse of the Moon, 2018-07-27, seen from -1.28,36.82,1684";
  const auto image = drawn({title, {grey(0), grey(0.01F)}, 2, sheet_font()});
  const std::size_t side = SheetGrid::gap;
  EXPECT_EQ(brightest(image, 0, image.width - side, SheetGrid::title_height, side), 0);
  EXPECT_GT(brightest(image, 0, image.width - 4 * side, SheetGrid::title_height, 3 * side), 0.5F)
      << "its end is there";
}

TEST_F(ContactSheetOf, MarkedPicturesHasBrighterWords) {
  const auto image =
      drawn({"Title", {grey(0, false, "U1+3min"), grey(0.01F, true, "U2")}, 2, sheet_font()});
  const auto grid = sheet_grid(2, 2, 48, 32);
  const auto words = [&](std::size_t i, std::size_t from) {
    return brightest(image, grid.top(i) + grid.picture_height, grid.left(i) + from,
                     SheetGrid::label_height, 80);
  };
  for (const std::size_t from : {std::size_t{0}, SheetGrid::picture_width - 80}) {
    EXPECT_GT(words(0, from), 0.4F);
    EXPECT_LT(words(0, from), 0.7F);
    EXPECT_GT(words(1, from), 0.8F);
  }
  EXPECT_GT(brightest(image, 0, 0, SheetGrid::title_height, image.width), 0.8F);
}

TEST_F(ContactSheetOf, NothingAtAllIsRefused) {
  EXPECT_THROW(drawn({"", {}, 1, sheet_font()}), coppermoon::algebra::Error);
}

TEST_F(ContactSheetOf, PicturesWithoutColoursIsRefused) {
  write_png(in_folder("y.png"), Image(4, 4, {"Y"}), 8);
  EXPECT_THROW(drawn({"", {{in_folder("y.png"), "", ""}}, 1, sheet_font()}),
               coppermoon::algebra::Error);
}

TEST_F(ContactSheetOf, AMissingFontIsRefused) {
  EXPECT_THROW(drawn({"Title", {grey(0)}, 1, in_folder("missing.ttf")}),
               coppermoon::algebra::Error);
}

TEST(Captions, StandInTheLowerCorners) {
  Image picture(300, 200, {"R", "G", "B"});
  write_captions(picture, "left", "right", 0.8F, sheet_font());
  double left = 0, right = 0, elsewhere = 0;
  for (std::size_t r = 0; r < picture.height; ++r)
    for (std::size_t c = 0; c < picture.width; ++c) {
      const float value = picture(r, c, 0);
      EXPECT_LE(value, 0.8F);
      auto& sum = r < 180 || (c >= 50 && c < 250) ? elsewhere : c < 50 ? left : right;
      sum += value;
    }
  EXPECT_GT(left, 10);
  EXPECT_GT(right, 10);
  EXPECT_EQ(elsewhere, 0);
}

TEST(Captions, ShrinkUntilBothFit) {
  Image picture(250, 2000, {"R", "G", "B"});
  write_captions(picture, "2018-07-27 23:21:45 EAT", "U2+12min", 1, sheet_font());
  double above = 0, lowest = 0;
  for (std::size_t r = 0; r < picture.height; ++r)
    for (std::size_t c = 0; c < picture.width; ++c) (r < 1970 ? above : lowest) += picture(r, c, 1);
  EXPECT_EQ(above, 0) << "letters of 55 pixels would be wider than the picture";
  EXPECT_GT(lowest, 10);
}

}  // namespace contact_sheet_test
