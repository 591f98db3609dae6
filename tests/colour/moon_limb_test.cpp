// SPDX-License-Identifier: MIT
#include "colour/moon_limb.h"

#include "colour/photographed_moon.h"
#include "support/testing.h"
#include "support/thorough.h"

namespace coppermoon::colour::moon_limb_test {

/// A disc at a random place.
struct Trial {
  Luminance photo;
  Disc truth;
};

Trial random_trial(const Moon& moon, const Camera& camera, algebra::Random& random) {
  const auto any = [&](double from, double to) { return from + (to - from) * random.uniform(); };
  const Disc disc{any(180, 220), any(180, 220), any(40, 160)};
  return {photographed(drawn(moon, {disc.radius_px, any(0, 6.28), disc.x_px, disc.y_px}, 400, 400),
                       camera, random),
          disc};
}

void expect_limb(const Luminance& photo, const Disc& truth, double tolerance_px,
                 const char* reason) {
  const auto found = limb_of(photo);
  ASSERT_TRUE(found);
  EXPECT_WITHIN(found->x_px, truth.x_px, tolerance_px, reason);
  EXPECT_WITHIN(found->y_px, truth.y_px, tolerance_px, reason);
  EXPECT_WITHIN(found->radius_px, truth.radius_px, tolerance_px, reason);
}

void expect_limbs(const Moon& moon, const Camera& camera, double tolerance_px, const char* reason) {
  algebra::Random random(8, 6);
  for (int i = 0; i < (support::thorough() ? 6 : 3); ++i) {
    const auto trial = random_trial(moon, camera, random);
    SCOPED_TRACE(trial.truth.radius_px);
    expect_limb(trial.photo, trial.truth, tolerance_px, reason);
  }
}

constexpr const char* of_ground =
    "ground beside the limb is uneven by a tenth over the twentieth of a radius that is looked at";

TEST(Limb, OfAnEvenDiscIsItsCircle) {
  Luminance photo(200, 240);
  for (std::size_t r = 0; r < 200; ++r)
    for (std::size_t c = 0; c < 240; ++c) {
      const double away =
          std::hypot(static_cast<double>(c) + 0.5 - 103.3, static_cast<double>(r) + 0.5 - 95.7);
      photo(r, c) = static_cast<float>(std::clamp(80.2 - away + 0.5, 0., 1.));
    }
  expect_limb(photo, {103.3, 95.7, 80.2}, 0.05, "covered shares of pixels, to a straight limb's");
}

TEST(Limb, OfAFullMoonIsFound) { expect_limbs(Moon(), {.blur_px = 1}, 0.25, of_ground); }

TEST(Limb, OfANoisyBlurredMoonIsFound) {
  expect_limbs(Moon(), {.blur_px = 2.5, .noise = 0.02}, 0.5,
               "the step of a blur of 2.5 pixels is wider than the 4 pixels looked at beside it");
}

TEST(Limb, OfAMoonThatIsMostlyDarkIsFound) {
  expect_limbs(Moon({{-1.9, 0.7}, 1e-4}), {.blur_px = 1, .noise = 0.002}, 0.6,
               "the dark side of the circle hangs on the bright, and light changes across the "
               "pixels looked at: "
               "0.55 measured, 0.58 of a Moon without markings");
}

TEST(Limb, OfAClippedMoonIsFoundALittleTooLarge) {
  expect_limbs(Moon(), {.blur_px = 1, .noise = 0.002, .saturation = 0.2}, 1.5,
               "a tenth of the light, half of what is left, is a blur and a half further out");
}

TEST(Limb, IsNotFoundWhereThereIsNone) {
  algebra::Random random(8, 7);
  EXPECT_FALSE(limb_of(Luminance(50, 60)));
  EXPECT_FALSE(limb_of(Luminance(50, 60, 3)));
  for (int i = 0; i < (support::thorough() ? 10 : 4); ++i)
    EXPECT_FALSE(limb_of(photographed(Luminance(120, 150, 1), {0, 0.1, 2}, random)));
  Luminance ramp(100, 100), stars(200, 200);
  for (std::size_t r = 0; r < 100; ++r)
    for (std::size_t c = 0; c < 100; ++c) ramp(r, c) = static_cast<float>(r + 2 * c);
  for (int i = 0; i < 300; ++i)
    stars(static_cast<std::size_t>(200 * random.uniform()),
          static_cast<std::size_t>(200 * random.uniform())) = 1;
  EXPECT_FALSE(limb_of(ramp));
  EXPECT_FALSE(limb_of(stars));
}

TEST(Limb, IsNotTheEdgeOfARectangle) {
  Luminance photo(200, 200);
  for (std::size_t r = 60; r < 140; ++r)
    for (std::size_t c = 40; c < 170; ++c) photo(r, c) = 1;
  EXPECT_FALSE(limb_of(photo));
}

TEST(Limb, RefusesWhatIsNoPicture) {
  Luminance photo(40, 40, 1);
  photo(3, 4) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(limb_of(photo), algebra::Error);
  EXPECT_THROW(limb_of(Luminance(15, 40)), algebra::Error);
}

}  // namespace coppermoon::colour::moon_limb_test
