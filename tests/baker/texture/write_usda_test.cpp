// SPDX-License-Identifier: MIT
#include "texture/write_usda.h"

#include "baker/texture/scratch_folder.h"
#include "support/testing.h"

namespace write_usda_test {

using namespace coppermoon::texture;

using WriteUsda = ScratchFolder;

bool holds(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

TEST_F(WriteUsda, StatesItsStage) {
  write_usda(in_folder("moon.usda"), "moon_lin_rec709.exr", "lin_rec709_scene");
  const auto text = bytes_of(in_folder("moon.usda"));
  EXPECT_TRUE(text.starts_with("#usda 1.0\n(\n"));
  for (const auto* part :
       {"defaultPrim = \"Moon\"", "metersPerUnit = 1", "upAxis = \"Y\"", "def Xform \"Moon\"",
        "@./moon_lin_rec709.exr@", "inputs:sourceColorSpace = \"raw\"", "inputs:wrapS = \"repeat\"",
        "inputs:wrapT = \"clamp\"", "colorSpace = \"lin_rec709_scene\"",
        "float radius_m = 1737400"})
    EXPECT_TRUE(holds(text, part)) << part;
}

TEST_F(WriteUsda, NamesTheTexturesColourSpace) {
  write_usda(in_folder("moon.usda"), "moon_acescg.exr", "lin_ap1_scene");
  EXPECT_TRUE(holds(bytes_of(in_folder("moon.usda")), "colorSpace = \"lin_ap1_scene\""));
  write_usda(in_folder("moon.usda"), "moon_acescg.exr", "lin_ap1_scene", "moon_lin_rec709.exr");
  const auto layer = bytes_of(in_folder("moon.usda"));
  EXPECT_TRUE(
      holds(layer, "@./moon_acescg.exr@ (\n                    colorSpace = \"lin_ap1_scene\""));
  EXPECT_TRUE(
      holds(layer,
            "@./moon_lin_rec709.exr@ (\n                    colorSpace = \"lin_rec709_scene\"\n"
            "                )\n                token inputs:sourceColorSpace"));
  EXPECT_ERROR(write_usda(in_folder("xyz.usda"), "moon.exr", "lin_ciexyzd65_scene"),
               "= lin_ciexyzd65_scene, allowed lin_rec709_scene or lin_ap1_scene");
  EXPECT_EQ(files_in_folder(), 1U);
}

TEST_F(WriteUsda, TheSameInputGivesTheSameBytes) {
  write_usda(in_folder("a.usda"), "moon.exr", "lin_rec709_scene");
  write_usda(in_folder("b.usda"), "moon.exr", "lin_rec709_scene");
  EXPECT_EQ(bytes_of(in_folder("a.usda")), bytes_of(in_folder("b.usda")));
}

TEST_F(WriteUsda, TakesAPlainFileNameOnly) {
  for (const auto* name : {"", "..", "a/b.exr", "/b.exr", "a\nb.exr"})
    EXPECT_ERROR(write_usda(in_folder("moon.usda"), name, "lin_rec709_scene"),
                 "allowed a name in its folder");
  EXPECT_ERROR(write_usda(in_folder("moon.usda"), "st\\b.exr", "lin_rec709_scene"),
               R"("st\\b.exr", allowed a name in its folder without control characters, \ and)");
  for (const char* layer : {"st\\b.usda", "a:SDF_FORMAT_ARGS:b.usda"})
    EXPECT_ERROR(write_usda(in_folder(layer), "moon.exr", "lin_rec709_scene"), "USD does not find");
  EXPECT_EQ(files_in_folder(), 0U);
  write_usda(in_folder("moon.usda"), "a@@@b@.exr", "lin_rec709_scene");
  EXPECT_TRUE(holds(bytes_of(in_folder("moon.usda")), "@@@./a\\@@@b@.exr@@@"));
}

}  // namespace write_usda_test
