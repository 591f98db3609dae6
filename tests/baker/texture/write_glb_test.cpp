// SPDX-License-Identifier: MIT
#include "texture/write_glb.h"

#include <sys/resource.h>
#include <csignal>
#include <cstring>
#include <nlohmann/json.hpp>

#include "baker/texture/scratch_folder.h"
#include "support/testing.h"
#include "texture/read_image.h"

namespace write_glb_test {

using namespace coppermoon::texture;
using nlohmann::json;

using WriteGlb = ScratchFolder;

const std::string generator = "coppermoon 9.8.7";

Image picture(std::size_t width = 64) {
  Image image(width, width / 2, {"R", "G", "B"});
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] = static_cast<float>(i * 7919 % 256) / 255;
  return image;
}

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data() + at, 4);
  return number;
}

/// A file taken apart as its standard says.
struct Parts {
  explicit Parts(const std::string& bytes)
      : magic(bytes.substr(0, 4)),
        version(number_at(bytes, 4)),
        length(number_at(bytes, 8)),
        document(json::parse(bytes.substr(20, number_at(bytes, 12)), nullptr, false)),
        binary(bytes.substr(28 + number_at(bytes, 12))) {}

  std::string view(const json& index) const {
    const auto& at = document["bufferViews"][index.get<std::size_t>()];
    return binary.substr(at["byteOffset"], at["byteLength"]);
  }

  std::string magic;
  std::uint32_t version, length;
  json document;
  std::string binary;
};

TEST_F(WriteGlb, IsOneFileOfTheLengthItSays) {
  write_glb(in_folder("moon.glb"), picture(), generator);
  const auto bytes = bytes_of(in_folder("moon.glb"));
  const Parts parts(bytes);
  EXPECT_EQ(parts.magic, "glTF");
  EXPECT_EQ(parts.version, 2U);
  EXPECT_EQ(parts.length, bytes.size());
  EXPECT_EQ(parts.document["buffers"][0]["byteLength"], parts.binary.size());
  EXPECT_FALSE(parts.document["buffers"][0].contains("uri"));
  EXPECT_EQ(files_in_folder(), 1U);
}

TEST_F(WriteGlb, HoldsThePictureTexelByTexel) {
  const auto image = picture();
  write_glb(in_folder("moon.glb"), image, generator);
  const Parts parts(bytes_of(in_folder("moon.glb")));
  const auto& held = parts.document["images"][0];
  EXPECT_EQ(held["mimeType"], "image/png");
  const auto back = read_image(file("held.png", parts.view(held["bufferView"])));
  ASSERT_EQ(back.width, image.width);
  ASSERT_EQ(back.values.size(), image.values.size());
  for (std::size_t i = 0; i < image.values.size(); ++i)
    EXPECT_WITHIN(back.values[i], image.values[i], 1e-6F, "they are 256ths; float's rounding");
}

TEST_F(WriteGlb, ShinesByItselfWithAndWithoutTheExtension) {
  write_glb(in_folder("moon.glb"), picture(), generator);
  const Parts parts(bytes_of(in_folder("moon.glb")));
  const auto& material = parts.document["materials"][0];
  EXPECT_TRUE(material["extensions"].contains("KHR_materials_unlit"));
  EXPECT_EQ(parts.document["extensionsUsed"], json::array({"KHR_materials_unlit"}));
  EXPECT_FALSE(parts.document.contains("extensionsRequired"));
  EXPECT_EQ(material["pbrMetallicRoughness"]["baseColorTexture"]["index"], 0);
  EXPECT_EQ(material["emissiveTexture"]["index"], 0);
  EXPECT_EQ(material["emissiveFactor"], json::array({1, 1, 1}));
  EXPECT_EQ(material["doubleSided"], false);
  EXPECT_EQ(parts.document["samplers"][0]["wrapS"], 10497);
  EXPECT_EQ(parts.document["samplers"][0]["wrapT"], 33071);
  EXPECT_EQ(parts.document["samplers"][0]["minFilter"], 9987);
}

/// glTF 2.0, 3.6.2.5: the least and greatest of each coordinate, as floats.
TEST_F(WriteGlb, SaysTheBoundsOfItsPoints) {
  write_glb(in_folder("moon.glb"), picture(), generator);
  const Parts parts(bytes_of(in_folder("moon.glb")));
  const auto& document = parts.document;
  const auto& accessor =
      document["accessors"]
              [document["meshes"][0]["primitives"][0]["attributes"]["POSITION"].get<std::size_t>()];
  const auto bytes = parts.view(accessor["bufferView"]);
  std::vector<float> points(bytes.size() / sizeof(float));
  std::memcpy(points.data(), bytes.data(), bytes.size());
  ASSERT_EQ(points.size(), 3 * accessor["count"].get<std::size_t>());
  for (std::size_t k = 0; k < 3; ++k) {
    float low = points[k], high = points[k];
    for (std::size_t i = k; i < points.size(); i += 3)
      low = std::min(low, points[i]), high = std::max(high, points[i]);
    EXPECT_EQ(accessor["min"][k].get<float>(), low);
    EXPECT_EQ(accessor["max"][k].get<float>(), high);
  }
}

TEST_F(WriteGlb, EmitsItsLuminance) {
  Image moon(64, 32, {"R", "G", "B"});
  for (std::size_t i = 0; i < moon.values.size(); ++i)
    moon.values[i] = 4000 * std::pow(10.F, -6 * static_cast<float>(i) / 6143);
  moon.values[5] = -0.1F;
  write_glb(in_folder("moon.glb"), moon, generator, GlbTexels::luminance);
  const Parts parts(bytes_of(in_folder("moon.glb")));
  const auto& material = parts.document["materials"][0];
  EXPECT_EQ(parts.document["extensionsUsed"], json::array({"KHR_materials_emissive_strength"}));
  const double strength =
      material["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"];
  EXPECT_EQ(strength, 4000);
  EXPECT_EQ(material["pbrMetallicRoughness"]["baseColorFactor"], json::array({0, 0, 0, 1}));
  EXPECT_EQ(material["emissiveTexture"]["index"], 0);
  const auto& held = parts.document["images"][0];
  const auto back = read_image(file("held.png", parts.view(held["bufferView"])));
  for (std::size_t i = 0; i < moon.values.size(); ++i) {
    const double code = double{back.values[i]};  // by IEC 61966-2-1
    const double share = code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
    const double wanted = std::max(0., double{moon.values[i]});
    const double slope =
        code <= 0.04045 ? 1 / 12.92 : 2.4 / 1.055 * std::pow((code + 0.055) / 1.055, 1.4);
    EXPECT_WITHIN(strength * share, wanted, 1.01 * strength * slope / 131070 + 1e-6 * wanted,
                  "half of a 65535th of the code, and a hundredth of that for the slope's change; "
                  "floats");
  }
  moon.values[7] = std::numeric_limits<float>::infinity();
  EXPECT_ERROR(write_glb(in_folder("bad.glb"), moon, generator, GlbTexels::luminance),
               "bad.glb: a luminance is inf");
}

TEST_F(WriteGlb, EmitsNothingWhereNothingShines) {
  write_glb(in_folder("dark.glb"), Image(64, 32, {"Y"}), generator, GlbTexels::luminance);
  const Parts parts(bytes_of(in_folder("dark.glb")));
  EXPECT_EQ(parts.document["materials"][0]["extensions"]["KHR_materials_emissive_strength"]
                          ["emissiveStrength"],
            1);
}

TEST_F(WriteGlb, NamesItsProgramAndTheMoonsRadius) {
  write_glb(in_folder("moon.glb"), picture(), generator);
  const auto asset = Parts(bytes_of(in_folder("moon.glb"))).document["asset"];
  EXPECT_EQ(asset["generator"], generator);
  EXPECT_EQ(asset["extras"]["coppermoon:radius_m"], 1737400.0);
}

TEST_F(WriteGlb, TheSameInputGivesTheSameBytes) {
  write_glb(in_folder("a.glb"), picture(), generator);
  write_glb(in_folder("b.glb"), picture(), generator);
  EXPECT_EQ(bytes_of(in_folder("a.glb")), bytes_of(in_folder("b.glb")));
}

TEST_F(WriteGlb, RefusesWhatViewersCannotShow) {
  const auto path = in_folder("moon.glb");
  const auto refused = [&](Image image) { write_glb(path, image, generator); };
  EXPECT_ERROR(refused(Image(8194, 4097, {"Y"})),
               "moon.glb: picture 8194 texels wide, allowed 2 to 8192");
  EXPECT_ERROR(refused(Image(64, 30, {"Y"})), "picture of 64 x 30 texels, allowed 2:1");
  EXPECT_ERROR(refused(Image(64, 32, {"Y", "A"})), "picture of 2 channels, allowed 1 or 3");
  for (const float bad : {-0.1F, 1.1F, std::numeric_limits<float>::quiet_NaN()}) {
    auto image = picture();
    image.values[5] = bad;
    EXPECT_ERROR(refused(image), "allowed 0 to 1");
  }
  EXPECT_EQ(files_in_folder(), 0U);
}

TEST_F(WriteGlb, GreyAndAlmostTwoToOneAreTaken) {
  write_glb(in_folder("grey.glb"), Image(64, 32, {"Y"}), generator);
  write_glb(in_folder("odd.glb"), Image(65, 32, {"Y"}), generator);
  EXPECT_EQ(files_in_folder(), 2U);
}

TEST_F(WriteGlb, AFullDiskLeavesTheOldFile) {
  const auto path = file("moon.glb", "old");
  struct rlimit before {};
  ::getrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{4096, before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &small);
  EXPECT_ERROR(write_glb(path, picture(), {}), "moon.glb: cannot be written");
  ::setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(bytes_of(path), "old");
  EXPECT_EQ(files_in_folder(), 1U);
}

}  // namespace write_glb_test
