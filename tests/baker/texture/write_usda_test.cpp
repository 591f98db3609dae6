// SPDX-License-Identifier: MIT
#include "texture/write_usda.h"

#include "baker/texture/scratch_folder.h"

namespace {

using namespace coppermoon::texture;

using WriteUsda = ScratchFolder;

const std::string recipe = "instant = '2008-02-21T03:26:05Z'\nname = \"a \\\"b\\\" ☾ \\ \t\"\n";
const Attributes layer_data{{"capDate", std::string("2008:02:21 03:26:05")},
                            {"coppermoon:recipe", recipe},
                            {"coppermoon:relative_error", 0.001F},
                            {"whiteLuminance", 1.F}};

bool holds(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

TEST_F(WriteUsda, StatesItsStage) {
  write_usda(in_folder("moon.usda"), "moon_lin_rec709.exr", "lin_rec709", layer_data);
  const auto text = bytes_of(in_folder("moon.usda"));
  EXPECT_TRUE(text.starts_with("#usda 1.0\n(\n"));
  for (const auto* part :
       {"defaultPrim = \"Moon\"", "metersPerUnit = 1", "upAxis = \"Y\"", "def Xform \"Moon\"",
        "@./moon_lin_rec709.exr@", "inputs:sourceColorSpace = \"raw\"", "inputs:wrapS = \"repeat\"",
        "inputs:wrapT = \"clamp\"", "colorSpace = \"lin_rec709\"", "float radius_m = 1737400",
        "string capDate = \"2008:02:21 03:26:05\"", "float relative_error = 0.001"})
    EXPECT_TRUE(holds(text, part)) << part;
}

TEST_F(WriteUsda, NamesTheTexturesColourSpace) {
  write_usda(in_folder("moon.usda"), "moon_acescg.exr", "acescg", {});
  EXPECT_TRUE(holds(bytes_of(in_folder("moon.usda")), "colorSpace = \"acescg\""));
  write_usda(in_folder("moon.usda"), "moon_acescg.exr", "acescg", {}, "moon_lin_rec709.exr");
  const auto layer = bytes_of(in_folder("moon.usda"));
  EXPECT_TRUE(holds(layer, "@./moon_acescg.exr@ (\n                    colorSpace = \"acescg\""));
  EXPECT_TRUE(holds(layer, "@./moon_lin_rec709.exr@\n                token inputs:sourceColorSpace"));
  EXPECT_ERROR(write_usda(in_folder("xyz.usda"), "moon.exr", "lin_ciexyzd65_scene", {}),
               "= lin_ciexyzd65_scene, allowed lin_rec709 or acescg");
  EXPECT_EQ(files_in_folder(), 1U);
}

TEST_F(WriteUsda, GivesItsRecipeBack) {
  write_usda(in_folder("moon.usda"), "moon.exr", "lin_rec709", layer_data);
  EXPECT_EQ(recipe_in_usda(in_folder("moon.usda")), recipe);
  write_usda(in_folder("none.usda"), "moon.exr", "lin_rec709", {});
  EXPECT_EQ(recipe_in_usda(in_folder("none.usda")), std::nullopt);
}

TEST_F(WriteUsda, GivesBackEveryByteOfAText) {
  std::string all;
  for (int c = 1; c < 256; ++c) all += static_cast<char>(c);
  all += "0123456789\\\"'''\"\"\"#(){}[]";
  write_usda(in_folder("moon.usda"), "moon.exr", "lin_rec709",
             {{"coppermoon:recipe", all}, {"coppermoon:" + all, all}, {all, all}});
  EXPECT_EQ(recipe_in_usda(in_folder("moon.usda")), all);
}

TEST_F(WriteUsda, ReadsRecipesThatOtherProgramsWroteAgain) {
  const auto read = [&](const std::string& data) {
    return recipe_in_usda(file("theirs.usda", "#usda 1.0\n(\n    \"\"\"A Moon: { ( \" [\n\"\"\"\n" +
                                                  data + ")\n\ndef Xform \"Moon\"\n{\n}\n"));
  };
  EXPECT_EQ(
      read("customLayerData = {\n dictionary coppermoon = {\n string recipe = '''a\n\"b\"'''\n"
           " }\n}\n"),
      "a\n\"b\"");
  EXPECT_EQ(read("customLayerData = { dictionary \"coppermoon\" = { double[] x = [1, 2]\n"
                 "string \"recipe\" = 'a\\x41\\102\\n' } }"),
            "aAB\n");
  EXPECT_EQ(read("# customLayerData = { dictionary coppermoon = { string recipe = 'no' } }\n"),
            std::nullopt);
  EXPECT_EQ(read("customLayerData = { dictionary other = { string recipe = 'no' } }\n"),
            std::nullopt);
  EXPECT_EQ(
      read("doc = 'customLayerData = { dictionary coppermoon = { string recipe = \"no\" } }'"),
      std::nullopt);
}

TEST_F(WriteUsda, TheSameInputGivesTheSameBytes) {
  write_usda(in_folder("a.usda"), "moon.exr", "lin_rec709", layer_data);
  write_usda(in_folder("b.usda"), "moon.exr", "lin_rec709", layer_data);
  EXPECT_EQ(bytes_of(in_folder("a.usda")), bytes_of(in_folder("b.usda")));
}

TEST_F(WriteUsda, TakesAPlainFileNameOnly) {
  for (const auto* name : {"", "..", "a/b.exr", "/b.exr", "a\nb.exr"})
    EXPECT_ERROR(write_usda(in_folder("moon.usda"), name, "lin_rec709", {}),
                 "allowed a name in its folder");
  EXPECT_EQ(files_in_folder(), 0U);
  write_usda(in_folder("moon.usda"), "a@@@b@.exr", "lin_rec709", {});
  EXPECT_TRUE(holds(bytes_of(in_folder("moon.usda")), "@@@./a\\@@@b@.exr@@@"));
}

TEST_F(WriteUsda, ReadsSpoiltFilesWithoutHarm) {
  write_usda(in_folder("moon.usda"), "moon.exr", "lin_rec709", layer_data);
  const auto whole = bytes_of(in_folder("moon.usda")).substr(0, 1500);
  const auto try_one = [&](const std::string& bytes) {
    const auto path = file("spoilt.usda", bytes);
    const auto text = error_of([&] { recipe_in_usda(path); });
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  };
  for (std::size_t at = 0; at < whole.size(); ++at) {
    auto bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ 0x55);
    try_one(bytes);
    if (at % 8 == 0) try_one(whole.substr(0, at));
  }
  try_one("#usda 1.0\n" + std::string(1 << 20, '('));
  try_one("#usda 1.0\n(" + std::string(1 << 20, '"') + "\\");
  EXPECT_ERROR(recipe_in_usda(file("garbage.usda", "PXR-USDC\1\2")),
               "garbage.usda: is no USD text");
  EXPECT_ERROR(recipe_in_usda(in_folder("absent.usda")), "absent.usda: cannot be read");
}

}  // namespace
