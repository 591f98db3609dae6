// SPDX-License-Identifier: MIT
#include "colour/photograph.h"

#include <tbb/global_control.h>

#include "support/testing.h"

namespace coppermoon::colour::photograph_test {

constexpr auto rec709 = WorkingSpace::linear_rec709;

/// One pixel of the sensor, seen from the telescope.
double pixel_rad(const Camera& camera) {
  return camera.sensor.pixel_um * 1e-3 / camera.optics.focal_length_mm;
}

/// No blur, no noise: what is left is the exposure law.
Camera quiet() {
  Camera camera;
  camera.diffraction = camera.noise = false;
  camera.sensor.bits = 16;
  camera.sensor.full_well_e = 1e9;
  return camera;
}

Image even(double luminance, std::size_t side = 1) {
  const float value = static_cast<float>(luminance);
  return Image(side, side, Rgb{value, value, value});
}

Photograph of(const Image& scene, const Camera& camera, const Exposure& exposure,
              std::uint64_t seed = 1) {
  return photographed(scene, rec709, camera,
                      {.exposure = exposure, .pixel_rad = pixel_rad(camera), .seed = seed});
}

TEST(Camera, CollectsTheElectronsWorkedByHand) {
  // E = π/4 · 0.8 · (1 − 0.09) · 1 cd/m² / 10² = 5.7177e-3 lx; over 2 s and 36 µm² 4.1167e-13 lm s;
  // times 4.0914e15 /lm/s and 0.5: 842.2
  Camera camera = quiet();
  camera.optics = {1000, 100, 0.3, 0.8};
  camera.sensor.pixel_um = 6;
  EXPECT_WITHIN(electrons_per_cd_m2(camera, {2, 10, 100}), 842.2, 0.1, "worked to 4 digits");
}

TEST(Camera, SaturatesAsIso12232HasIt) {
  // an exposure of 78/S lx s in the focus: L = 78 N² / (S t π/4)
  EXPECT_WITHIN_RELATIVE(saturation_cd_m2(quiet(), {2, 5, 400}),
                         78 * 25 / (400 * 2 * std::numbers::pi / 4), 1e-12, "rounding");
}

TEST(Camera, ThatIsFullSaturatesBefore) {
  auto camera = quiet();
  camera.sensor.full_well_e = 1000;
  const Exposure slow{1, 8, 1};
  EXPECT_WITHIN_RELATIVE(saturation_cd_m2(camera, slow), 1000 / electrons_per_cd_m2(camera, slow),
                         1e-12, "rounding");
}

TEST(Photograph, FollowsTheExposureLaw) {
  const auto camera = quiet();
  const Exposure exposure{1, 8, 200};
  const double half = saturation_cd_m2(camera, exposure) / 2;
  const auto raw = [&](double luminance, const Exposure& e) {
    return of(even(luminance), camera, e).raw(0, 0)[1];
  };
  const double reference = raw(half, exposure);
  EXPECT_WITHIN(reference, 65535 / 2., 1, "rounded to whole numbers");
  EXPECT_EQ(raw(half / 4, {4, 8, 200}), reference);
  EXPECT_EQ(raw(half * 4, {1, 16, 200}), reference);
  EXPECT_EQ(raw(half / 2, {1, 8, 400}), reference);
  EXPECT_WITHIN(raw(half / 8, exposure), reference / 8, 1, "rounded to whole numbers");
}

TEST(Photograph, OfASceneIsTheSceneForEverySensor) {
  Image scene(1, 1, Rgb{0.30F, 0.12F, 0.05F});  // copper
  for (const auto& response : response_names()) {
    if (response == "luminance") continue;
    auto camera = quiet();
    camera.sensor.response = response;
    const auto photograph = of(scene, camera, {1, 8, 6400});
    const double step = photograph.saturation_cd_m2 / 65535;
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_WITHIN(photograph.scene_linear(0, 0)[k], scene(0, 0)[k], 12 * step,
                    "half a step of each channel, through a matrix whose rows come to 20 at most, "
                    "and a channel less sensitive by half")
          << response;
  }
}

TEST(Photograph, InOtherSpacesIsTheSame) {
  auto camera = quiet();
  camera.sensor.response = "canon-6d";
  const glm::dvec3 xyz(0.2, 0.15, 0.06);
  for (const auto space : {WorkingSpace::acescg, WorkingSpace::ciexyz_d65}) {
    const auto raw_in = [&](WorkingSpace in) {
      const auto c = channels_from_xyz(in) * xyz;
      const Image scene(
          1, 1, Rgb{static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b)});
      return photographed(scene, in, camera, {.exposure = {1, 8, 6400}}).raw(0, 0);
    };
    const auto here = raw_in(space), there = raw_in(rec709);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_WITHIN(here[k], there[k], 1, "ACEScg's white is adapted by Bradford's and back");
  }
}

TEST(Photograph, WithoutColoursIsGrey) {
  auto camera = quiet();
  camera.sensor.response = "luminance";
  const Image scene(1, 1, Rgb{0.3F, 0.1F, 0.02F});
  const auto pixel = of(scene, camera, {1, 8, 6400}).scene_linear(0, 0);
  const double y = 0.2126 * 0.3 + 0.7152 * 0.1 + 0.0722 * 0.02;
  for (const float value : pixel)
    EXPECT_WITHIN(value, y, 1e-4, "a step of 16 bits, Rec. 709's digits");
}

TEST(Photograph, ClipsToWhite) {
  for (const auto& name : camera_names()) {
    auto camera = camera_named(name);
    camera.noise = false;
    const Exposure exposure{1, 8, 800};
    const auto photograph = of(even(1e4), camera, exposure);
    EXPECT_EQ(photograph.raw(0, 0)[1], (1 << camera.sensor.bits) - 1) << name;
    const auto& pixel = photograph.scene_linear(0, 0);
    for (const float value : pixel)
      EXPECT_WITHIN_RELATIVE(value, photograph.saturation_cd_m2, 1e-6, "single precision") << name;
    EXPECT_WITHIN_RELATIVE(photograph.saturation_cd_m2, saturation_cd_m2(camera, exposure), 1e-9,
                           "rounding");
  }
}

TEST(Photograph, OfAFullWellClipsBelowTheConverter) {
  auto camera = camera_named("paper");
  camera.noise = false;
  const auto photograph = of(even(1e4), camera, {1, 8, 25});
  EXPECT_LT(photograph.raw(0, 0)[1], 3000);
  EXPECT_EQ(photograph.scene_linear(0, 0)[0], photograph.scene_linear(0, 0)[2]);
}

struct Statistics {
  double mean = 0, variance = 0;
};

Statistics of_green(const Photograph& photograph) {
  Statistics s;
  const double n = static_cast<double>(photograph.raw.values().size());
  for (const auto& raw : photograph.raw.values()) s.mean += raw[1] / n;
  for (const auto& raw : photograph.raw.values())
    s.variance += (raw[1] - s.mean) * (raw[1] - s.mean) / (n - 1);
  return s;
}

TEST(Photograph, HasTheMeanVarianceLine) {
  // variance = K (mean − black) + (K read)² + converter² + 1/12, K: DN for each electron
  auto camera = camera_named("400mm");
  camera.diffraction = false;
  camera.glow = 0;  // an even field would lose what leaves the frame
  constexpr std::size_t side = 250;
  for (const double iso : {100., 1600.}) {
    const Exposure exposure{1, 5.6, iso};
    const double saturation = saturation_cd_m2(camera, exposure);
    const auto& sensor = camera.sensor;
    const double range = 16383 - sensor.black_level_dn;
    auto bottomless = camera;
    bottomless.sensor.full_well_e = 1e9;
    const double k =
        range / (electrons_per_cd_m2(camera, exposure) * saturation_cd_m2(bottomless, exposure));
    for (const double share : {0., 0.01, 0.1, 0.3, 0.6}) {
      const auto s = of_green(of(even(share * saturation, side), camera, exposure, 7));
      const double signal = s.mean - sensor.black_level_dn;
      const double variance = k * signal + std::pow(k * sensor.read_noise_e, 2) +
                              std::pow(sensor.converter_noise_dn, 2) + 1. / 12;
      EXPECT_WITHIN_RELATIVE(s.variance, variance, 4 * std::sqrt(2. / (side * side)),
                             "four standard errors of a variance: once in 16000");
      const double expected = share * saturation * electrons_per_cd_m2(camera, exposure) * k;
      EXPECT_WITHIN(signal, expected, 4 * std::sqrt(variance) / side,
                    "four standard errors of a mean");
    }
  }
}

TEST(Photograph, OfBinnedPixelsIsAsMuchQuieter) {
  auto camera = camera_named("refractor");
  camera.diffraction = false;
  const Exposure exposure{1, 6, 800};
  const auto scene = even(0.3 * saturation_cd_m2(camera, exposure), 200);
  const auto variance = [&](double binned) {
    return of_green(photographed(
                        scene, rec709, camera,
                        {.exposure = exposure, .pixel_rad = std::sqrt(binned) * pixel_rad(camera)}))
               .variance -
           1. / 12;
  };
  EXPECT_WITHIN_RELATIVE(variance(9), variance(1) / 9, 4 * std::sqrt(2 * 2. / 40000),
                         "four standard errors of two variances");
}

TEST(Photograph, NoiseIsCountedAndNotOfThreads) {
  const auto camera = camera_named("paper");
  const auto scene = even(0.5, 64);
  const Exposure exposure{2, 12.1, 800};
  const auto first = of(scene, camera, exposure, 5);
  {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const auto again = of(scene, camera, exposure, 5);
    EXPECT_TRUE(std::ranges::equal(first.raw.values(), again.raw.values()));
  }
  EXPECT_FALSE(std::ranges::equal(first.raw.values(), of(scene, camera, exposure, 6).raw.values()));
  const auto next = photographed(scene, rec709, camera, {exposure, pixel_rad(camera), 0, 5, 1});
  EXPECT_FALSE(std::ranges::equal(first.raw.values(), next.raw.values()));
}

TEST(Photograph, OfDarkIsNeitherBrighterNorDarkerOnTheMean) {
  // what is black keeps its noise's lower half: the developed mean is 0
  auto camera = camera_named("400mm");
  const auto photograph = of(even(0, 200), camera, {1, 5.6, 3200});
  double mean = 0, square = 0;
  for (const auto& pixel : photograph.scene_linear.values()) {
    mean += pixel[1];
    square += pixel[1] * pixel[1];
  }
  const double n = 40000, deviation = std::sqrt(square / n);
  EXPECT_GT(deviation, 0);
  EXPECT_WITHIN(mean / n, 0, 4 * deviation / std::sqrt(n), "four standard errors");
}

TEST(Photograph, HasTheSkysLight) {
  auto camera = quiet();
  const auto with =
      photographed(even(0.2), rec709, camera, {.exposure = {1, 8, 1600}, .sky_cd_m2 = 0.3});
  EXPECT_EQ(with.raw(0, 0), of(even(0.5), camera, {1, 8, 1600}).raw(0, 0));
}

TEST(Photograph, AtTheExtremesIsFinite) {
  const auto camera = camera_named("paper");
  for (const double time : {1e-6, 1e6})
    for (const double iso : {1., 1e7})
      for (const double light : {0., 1e-30, 1., 1e30}) {
        const auto photograph = of(even(light, 2), camera, {time, 12.1, iso});
        for (const auto& pixel : photograph.scene_linear.values())
          for (const float value : pixel) EXPECT_TRUE(std::isfinite(value)) << time << iso << light;
      }
}

TEST(Photograph, RefusesWhatIsNone) {
  const auto camera = quiet();
  auto scene = even(1);
  scene(0, 0)[1] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(of(scene, camera, {}), algebra::Error);
  EXPECT_THROW(photographed(even(1), rec709, camera, {.sky_cd_m2 = -1}), algebra::Error);
  auto blind = camera;
  blind.sensor.quantum_efficiency = 0;
  EXPECT_THROW(of(even(1), blind, {}), algebra::Error);
  EXPECT_THROW(camera_named("brownie"), algebra::Error);
  EXPECT_THROW(response_named("infrared"), algebra::Error);
}

TEST(Cameras, AreSound) {
  for (const auto& name : camera_names())
    EXPECT_NO_THROW(require_sound(camera_named(name))) << name;
}

}  // namespace coppermoon::colour::photograph_test
