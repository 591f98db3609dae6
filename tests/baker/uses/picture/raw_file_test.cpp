// SPDX-License-Identifier: MIT
// A sensor's counts as raw files: what they say of the scene is what the photograph says of it.
#include "uses/picture/camera_request.h"

#include "almanac/instant.h"
#include "baker/texture/scratch_folder.h"
#include "support/testing.h"
#include "texture/read_image.h"
#include "uses/picture/photo_file.h"

namespace coppermoon::uses::raw_file_test {

constexpr auto space = colour::WorkingSpace::linear_rec709;

class RawFile : public ScratchFolder {
 protected:
  /// The light of an even field, photographed without noise, written and read back; in units of the
  /// sensor's saturation.
  texture::Image read_back(const colour::Camera& camera, const std::string& model,
                           const std::array<float, 3>& over_saturation, double iso) {
    const colour::Exposure exposure{1, camera.optics.focal_length_mm / camera.optics.aperture_mm,
                                    iso};
    const double white = colour::saturation_cd_m2(camera, exposure);
    colour::Image scene(30, 40);
    for (auto& pixel : scene.values())
      for (std::size_t k = 0; k < 3; ++k) pixel[k] = static_cast<float>(white * over_saturation[k]);
    const auto photograph = colour::photographed(scene, space, camera, {.exposure = exposure});
    texture::Attributes attributes{{"capDate", "2008:02:21 03:08:26"}};
    attributes["expTime"] = 1.F;
    attributes["aperture"] = static_cast<float>(exposure.f_number);
    attributes["isoSpeed"] = static_cast<float>(iso);
    write_raw(in_folder("a.dng"), {.model = model}, camera, iso, photograph, attributes);
    return texture::read_light(in_folder("a.dng"));
  }
};

TEST_F(RawFile, OfEachCameraHasTheScenesColoursOverSaturation) {
  const std::array<float, 3> copper{0.4F, 0.15F, 0.05F};
  for (const auto& model : colour::camera_names())
    for (const double iso : {100., 3200.}) {
      auto camera = colour::camera_named(model);
      camera.noise = camera.diffraction = false;
      camera.glow = 0;  // light that leaves the frame is another matter
      const auto light = read_back(camera, model, copper, iso);
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_WITHIN(light(15, 20, k), copper[k], 1.5e-3,
                      "half a step of 2000 numbers or more, by a matrix of up to 3 a row")
            << model << " at ISO " << iso << ", channel " << k;
    }
}

TEST_F(RawFile, SaysWhenAndHowItWasTaken) {
  auto camera = colour::camera_named("refractor");
  for (const double iso : {800., 409600.}) {
    read_back(camera, "refractor", {0.1F, 0.1F, 0.1F}, iso);
    const auto exif = exif_of(in_folder("a.dng"));
    ASSERT_TRUE(exif);
    EXPECT_EQ(exif->time_s, 1);
    EXPECT_WITHIN_RELATIVE(exif->f_number, 6, 1e-5, "read in six digits");
    EXPECT_EQ(exif->iso, iso) << "more than the 65535 that EXIF's older tag holds, too";
  }
  const auto when = almanac::instant_from_utc("2008-02-21T03:08:26");
  EXPECT_EQ(taken_at_s(in_folder("a.dng")), (when.tt_day + when.tt_fraction) * 86400);
}

TEST_F(RawFile, IsLightByItsExposure) {
  auto camera = colour::camera_named("refractor");
  camera.noise = camera.diffraction = false;
  camera.glow = 0;  // light that leaves the frame is another matter
  const std::array<float, 3> copper{0.4F, 0.15F, 0.05F};
  read_back(camera, "refractor", copper, 800);
  const double saturation = 1 / colour::exposure_scale({1, 6, 800});
  const auto light = raw_light(in_folder("a.dng"), space);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_WITHIN(light(15, 20, k) / saturation, copper[k], 1.5e-3, "as above");
  const auto xyz = raw_light(in_folder("a.dng"), colour::WorkingSpace::ciexyz_d65);
  EXPECT_WITHIN(xyz(15, 20, 1) / saturation, 0.2126 * 0.4 + 0.7152 * 0.15 + 0.0722 * 0.05, 1.5e-3,
                "as above");
}

TEST_F(RawFile, EndsInOneOfTwoWays) {
  auto camera = colour::camera_named("paper");
  EXPECT_ERROR(require_raw_file("a.cr2", camera), "a raw file ends in .tif, or in .dng");
  camera.sensor.response = "luminance";
  EXPECT_NO_THROW(require_raw_file("a.tif", camera));
  EXPECT_ERROR(require_raw_file("a.dng", camera), "response = luminance");
}

}  // namespace coppermoon::uses::raw_file_test
