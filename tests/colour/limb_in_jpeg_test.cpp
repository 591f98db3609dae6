// SPDX-License-Identifier: MIT
#include "colour/moon_limb.h"
#include "colour/taken_moons.h"
#include "support/testing.h"
#include "support/thorough.h"

namespace coppermoon::colour::limb_in_jpeg_test {

enum class Kind { full, shallow, deep, total, cut };

/// One in which a person sees a third of the limb, of quality 50, 51 … 100 in turn.
TakenMoon any_moon(std::uint64_t seed, double longest_px) {
  const auto kind = static_cast<Kind>(seed % 5);
  algebra::Random random(seed, 3);
  const auto any = [&](double from, double to) { return from + (to - from) * random.uniform(); };
  const auto any_ratio = [&](double from, double to) {
    return from * std::pow(to / from, random.uniform());
  };
  for (;;) {
    TakenMoon moon{.quality = 50 + static_cast<int>(seed % 51), .seed = seed};
    const double width = any_ratio(200, longest_px), height = width * any(0.55, 1);
    moon.columns = static_cast<std::size_t>(width);
    moon.rows = static_cast<std::size_t>(height);
    double radius = any_ratio(std::max(10., 0.02 * width), 0.47 * height), beyond = -radius - 2;
    if (kind == Kind::cut) radius = any_ratio(0.2 * height, 0.8 * width), beyond = 0.3 * radius;
    moon.disc = {any(-beyond, width + beyond), any(-beyond, height + beyond), radius};
    double away = 9;
    if (kind == Kind::shallow) away = any(2.3, 3.7);
    if (kind == Kind::deep) away = any(1.9, 2.3);
    if (kind == Kind::total) away = any(0, 1.6);
    if (kind == Kind::cut) away = any(2, 6);
    const double towards = any(0, 2 * std::numbers::pi);
    moon.shadow_x = away * std::cos(towards);
    moon.shadow_y = away * std::sin(towards);
    moon.umbra = any_ratio(1e-6, 3e-3);
    moon.exposure = kind == Kind::total ? any_ratio(0.01, 0.15) / moon.umbra : any_ratio(0.3, 30);
    moon.blur = static_cast<int>(any(0, 1) * any(0, 1) * std::min(8., radius / 8) + 0.5);
    moon.noise = any_ratio(0.001, 0.15);
    if (random.uniform() < 0.3) moon.sky = any_ratio(0.001, 0.2);
    if (random.uniform() < 0.4) moon.glow = any_ratio(0.001, 0.05);
    if (tellable(moon).degrees >= 120) return moon;
  }
}

/// That 99 of 100 are found where they are, or all but one of fewer than that, which one in three such
/// samples would miss at that rate; of all, those of 10 to 20 pixels' radius among them, which
/// JPEG's blocks of 8 pixels cover in a few, 97.
void expect_found(std::uint64_t first_seed, int count, double longest_px) {
  int found = 0, large = 0, found_large = 0;
  std::string others;
  for (int i = 0; i < count; ++i) {
    const auto moon = any_moon(first_seed + static_cast<std::uint64_t>(i), longest_px);
    const auto disc = limb_of(taken(moon));
    const double tolerance = tolerance_px(moon, tellable(moon));
    const auto& [x, y, radius] = moon.disc;
    const bool right = disc && std::hypot(disc->x_px - x, disc->y_px - y) < tolerance &&
                       std::abs(disc->radius_px - radius) < tolerance;
    if (radius >= 20) ++large;
    if (right && radius >= 20) ++found_large;
    if (right)
      ++found;
    else
      others += " " + std::to_string(moon.seed) + (disc ? " (elsewhere)" : " (lost)");
  }
  EXPECT_LE(large - found_large, std::max(1., 0.01 * large))
      << "of " << large << ", not those of seeds" << others;
  EXPECT_LE(count - found, std::max(1., 0.03 * count)) << "not those of seeds" << others;
  testing::Test::RecordProperty("found", found);
  testing::Test::RecordProperty("found_large", found_large);
  testing::Test::RecordProperty("large", large);
}

TEST(LimbInJpeg, OfFortyMoonsIsFound) { expect_found(1000, 40, 400); }

TEST(LimbInJpegThoroughly, OfSixHundredMoonsIsFound) {
  if (!support::thorough()) GTEST_SKIP() << "tests/thorough.sh";
  expect_found(10000, 600, 1500);
}

TEST(LimbInJpeg, OfEveryQualityIsFound) {
  TakenMoon moon{.columns = 240,
                 .rows = 180,
                 .disc = {126.9, 85.7, 61.6},
                 .shadow_x = 3.2,
                 .exposure = 20,
                 .glow = 0.01};
  const auto light = light_of(moon);
  const auto clipped = std::ranges::count_if(light[0].values(), [](float v) { return v >= 1; });
  EXPECT_GT(static_cast<double>(clipped), 0.16 * 240 * 180);
  const double tolerance = tolerance_px(moon, tellable(moon));
  for (moon.quality = 50; moon.quality <= 100; ++moon.quality) {
    SCOPED_TRACE(moon.quality);
    const auto found = limb_of(luminance_in_jpeg(light, moon));
    ASSERT_TRUE(found);
    EXPECT_LT(std::hypot(found->x_px - moon.disc.x_px, found->y_px - moon.disc.y_px), tolerance);
    EXPECT_LT(std::abs(found->radius_px - moon.disc.radius_px), tolerance);
  }
}

TEST(LimbInJpeg, OfASmallMoonInALargePictureIsFound) {
  for (const double radius_px : {15., 40.}) {
    const TakenMoon moon{
        .columns = 2400, .rows = 1600, .disc = {700.3, 500.7, radius_px}, .shadow_x = 3};
    const auto found = limb_of(taken(moon));
    ASSERT_TRUE(found);
    const double tolerance = tolerance_px(moon, tellable(moon));
    EXPECT_LT(std::hypot(found->x_px - moon.disc.x_px, found->y_px - moon.disc.y_px), tolerance);
    EXPECT_LT(std::abs(found->radius_px - radius_px), tolerance);
  }
}

/// Light by place, 0 to 1 across each side.
Channels drawn_by(const TakenMoon& moon,
                  const std::function<double(double x, double y)>& light_at) {
  Channels light;
  for (auto& channel : light) {
    channel = algebra::Grid<float>(moon.rows, moon.columns);
    for (std::size_t r = 0; r < moon.rows; ++r)
      for (std::size_t c = 0; c < moon.columns; ++c)
        channel(r, c) = static_cast<float>(
            light_at((static_cast<double>(c) + 0.5) / static_cast<double>(moon.columns),
                     (static_cast<double>(r) + 0.5) / static_cast<double>(moon.rows)));
  }
  return light;
}

TEST(LimbInJpeg, IsNotSeenWhereThereIsNoMoon) {
  const auto square = [](double x, double y) {
    return std::max(std::abs(x - 0.47), std::abs(y - 0.52)) < 0.23 ? 0.7 : 0.;
  };
  const auto horizon = [](double x, double y) {
    return y < 0.6 + 0.03 * std::sin(9 * x) ? 0.5 : 0.02;
  };
  for (const double noise : {0.001, 0.05})
    for (const int quality : {60, 85, 92}) {
      const TakenMoon picture{.columns = 240, .rows = 240, .noise = noise, .quality = quality};
      SCOPED_TRACE(testing::Message() << "noise " << noise << ", quality " << quality);
      const auto is_found = [&](const std::function<double(double, double)>& light_at) {
        return limb_of(luminance_in_jpeg(drawn_by(picture, light_at), picture)).has_value();
      };
      EXPECT_FALSE(is_found([](double, double) { return 0; })) << "black";
      EXPECT_FALSE(is_found([](double, double) { return 0.5; })) << "grey";
      EXPECT_FALSE(is_found([](double x, double y) { return 0.4 * x + 0.5 * y; })) << "gradient";
      EXPECT_FALSE(is_found(square)) << "square";
      EXPECT_FALSE(is_found(horizon)) << "horizon";
    }
}

}  // namespace coppermoon::colour::limb_in_jpeg_test
