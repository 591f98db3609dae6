// SPDX-License-Identifier: MIT
#include "colour/registration.h"

#include "colour/photographed_moon.h"
#include "support/testing.h"

namespace coppermoon::colour::registration_test {

using std::numbers::pi;

constexpr Shadow partial{{-2.4, 0.9}, 1e-3}, total{{-0.9, 1.1}, 0.1};

/// A render, and a photograph that shows it under a known similarity.
struct Trial {
  Luminance render, photo;
  Similarity truth;
  glm::dvec2 disc_in_render;
  double radius_px;  ///< in the photograph
};

/// Given  as_rendered  the shadow where it is not that of the photograph
Trial random_trial(const Shadow& shadow, const Camera& camera, algebra::Random& random,
                   const std::optional<Shadow>& as_rendered = {}) {
  const auto any = [&](double from, double to) { return from + (to - from) * random.uniform(); };
  const double radius_px = any(60, 75);
  const Similarity of_render{radius_px, 0, any(85, 95), any(85, 95)};
  Similarity truth{std::exp(any(std::log(0.4), std::log(2))), any(0, 2 * pi), 0, 0,
                   random.uniform() < 0.5};
  const double room = 1.3 * radius_px * truth.scale;
  const auto side = static_cast<std::size_t>(2 * room + 30);
  const glm::dvec2 centre(room + any(0, 30), room + any(0, 30));
  const auto lands = moved(truth, {of_render.x_px, of_render.y_px});
  truth.x_px = centre.x - lands.x;
  truth.y_px = centre.y - lands.y;
  const Moon moon(shadow);
  return {drawn(Moon(as_rendered.value_or(shadow)), of_render, 180, 180),
          photographed(drawn(moon, composed(of_render, truth), side, side + 20), camera, random),
          truth,
          {of_render.x_px, of_render.y_px},
          radius_px * truth.scale};
}

/// How far a registration may be off.
struct Tolerance {
  double rotation_deg = 0.2, scale = 0.003;
  double at_limb_px = 0.2;  ///< instead of these two, where it is more
  double shift_px = 0.25;
  const char* reason =
      "a fifth of a degree leaves a mare of 0.3 radii where it is to a thousandth of the disc; a "
      "quarter pixel cannot be seen in a pixel's difference";
};

void expect_found(const Trial& trial, const Tolerance& tolerance, const KnownBefore& known = {}) {
  const auto found = registered(trial.photo, trial.render, known);
  const auto& is = found.render_to_photo;
  const auto off = moved(is, trial.disc_in_render) - moved(trial.truth, trial.disc_in_render);
  const double turn = std::remainder(is.rotation_rad - trial.truth.rotation_rad, 2 * pi);
  const double of_limb = tolerance.at_limb_px / trial.radius_px;
  EXPECT_EQ(is.mirrored, trial.truth.mirrored);
  EXPECT_WITHIN(turn, 0, std::max(tolerance.rotation_deg * pi / 180, of_limb), tolerance.reason);
  EXPECT_WITHIN_RELATIVE(is.scale, trial.truth.scale, std::max(tolerance.scale, of_limb),
                         tolerance.reason);
  EXPECT_WITHIN(std::hypot(off.x, off.y), 0, tolerance.shift_px, tolerance.reason);
  EXPECT_GT(found.correlation, 0.9);  // the same Moon
}

void expect_all_found(const Shadow& shadow, const Camera& camera, const Tolerance& tolerance = {}) {
  algebra::Random random(8, 1);
  for (int i = 0; i < 4; ++i) {
    const auto trial = random_trial(shadow, camera, random);
    SCOPED_TRACE(testing::Message()
                 << "scale " << trial.truth.scale << ", rotation " << trial.truth.rotation_rad
                 << ", mirrored " << trial.truth.mirrored);
    expect_found(trial, tolerance);
  }
}

TEST(Registration, HoldsInAPhotographThatIsEnlarged) {
  algebra::Random random(8, 1);
  auto trial = random_trial({}, {}, random);
  const double larger = 1400 / trial.radius_px;
  const auto side = [=](std::size_t pixels) {
    return static_cast<std::size_t>(larger * static_cast<double>(pixels));
  };
  const Similarity enlarged{larger};
  trial.photo =
      resampled(trial.photo, enlarged, side(trial.photo.rows()), side(trial.photo.columns()));
  trial.truth = composed(trial.truth, enlarged);
  trial.radius_px *= larger;
  expect_found(trial, {.at_limb_px = 0.2 * larger,
                       .shift_px = 0.25 * larger,
                       .reason = "as of the photograph that was enlarged"});
}

TEST(Registration, OfAPhotographWithoutFaultIsItsSimilarity) {
  expect_all_found(
      {}, {}, {0.05, 0.0005, 0.04, 0.05, "what bilinear pixels of 3 x 3 rays leave of places"});
}

TEST(Registration, HoldsForBlur) { expect_all_found({}, {.blur_px = 2}); }

TEST(Registration, HoldsForNoise) { expect_all_found({}, {.blur_px = 1, .noise = 0.02}); }

TEST(Registration, HoldsForAClippedDisc) {
  expect_all_found({}, {.blur_px = 1, .noise = 0.005, .saturation = 0.6});
}

TEST(Registration, HoldsInAPartialEclipseThatHidesTheUmbra) {
  expect_all_found(partial, {.blur_px = 1, .noise = 0.005});
}

TEST(Registration, HoldsInTheUmbraWhereTheRestIsClipped) {
  expect_all_found(partial, {.blur_px = 1, .noise = 0.001, .saturation = 0.03},
                   {0.3, 0.01, 0.5, 0.6,
                    "a limb 33 times too bright is moved outward by about two blurs, and only the "
                    "thin rest of the disc tells"});
}

TEST(Registration, HoldsInATotalEclipseBeforeABrightSky) {
  expect_all_found(total, {.blur_px = 1.5, .noise = 0.02, .saturation = 0.9, .sky = 0.05});
}

TEST(Registration, HoldsForARenderOfAnotherAir) {
  algebra::Random random(8, 9);
  for (int i = 0; i < 2; ++i) {
    const auto trial = random_trial(total, {.blur_px = 1}, random, Shadow{total.middle, 0.003});
    expect_found(trial, {0.5, 0.01, 0.3, 0.5,
                         "an umbra 33 times as dark ends elsewhere, and pulls the disc with it"});
  }
}

TEST(Registration, HoldsFromDiscsThatAreKnown) {
  algebra::Random random(8, 10);
  for (const auto& shadow : {partial, total}) {
    const auto trial = random_trial(shadow, {.blur_px = 1, .noise = 0.005}, random);
    const auto in_photo = moved(trial.truth, trial.disc_in_render);
    // begun 1 % of the radius beside the photograph's disc
    KnownBefore known{
        .in_photo = Disc{in_photo.x + 0.01 * trial.radius_px, in_photo.y, trial.radius_px},
        .in_render = Disc{trial.disc_in_render.x, trial.disc_in_render.y,
                          trial.radius_px / trial.truth.scale}};
    expect_found(trial, {}, known);
    known.scale = trial.truth.scale;
    expect_found(trial, {}, known);
    known.roughly = true;
    expect_found(trial,
                 {.rotation_deg = 0.6,
                  .shift_px = 0.01 * trial.radius_px,
                  .reason = "a hundredth of the radius"},
                 known);
  }
}

TEST(Registration, HoldsForADiscCutByThePicturesEdge) {
  algebra::Random random(8, 2);
  auto trial = random_trial({}, {.blur_px = 1, .noise = 0.01}, random);
  const auto cut = static_cast<std::size_t>(trial.radius_px);
  Luminance rest(trial.photo.rows(), trial.photo.columns() - cut);
  for (std::size_t r = 0; r < rest.rows(); ++r)
    for (std::size_t c = 0; c < rest.columns(); ++c) rest(r, c) = trial.photo(r, c + cut);
  trial.photo = rest;
  trial.truth.x_px -= static_cast<double>(cut);
  expect_found(trial, {});
}

TEST(Registration, DoesNotDependOnEitherExposure) {
  algebra::Random random(8, 3);
  const auto trial = random_trial(total, {.blur_px = 1}, random);
  auto bright = trial.photo, dark = trial.render;
  for (float& value : bright.values()) value *= 1024;
  for (float& value : dark.values()) value /= 1024;
  const auto one = registered(trial.photo, trial.render), other = registered(bright, dark);
  EXPECT_WITHIN(one.render_to_photo.rotation_rad, other.render_to_photo.rotation_rad, 1e-6,
                "a power of two changes no float's digits");
  EXPECT_WITHIN(one.correlation, other.correlation, 1e-6, "as before");
}

TEST(Registration, RefusesAnotherMoon) {
  algebra::Random random(8, 4);
  const Similarity at{60, 0, 90, 90};
  const auto near_side = drawn(Moon(), at, 180, 180);
  for (const double longitude_deg : {40., 90., 180., 270.}) {
    const auto other = drawn(Moon({}, longitude_deg), at, 180, 180);
    EXPECT_THROW(registered(photographed(other, {1, 0.01}, random), near_side), algebra::Error);
  }
}

TEST(Registration, RefusesPicturesWithoutAMoon) {
  algebra::Random random(8, 5);
  const auto moon = drawn(Moon(), {60, 0, 90, 90}, 180, 180);
  const auto noise = photographed(Luminance(180, 180, 1), {0, 0.1, 2}, random);
  EXPECT_THROW(registered(noise, moon), algebra::Error);
  EXPECT_THROW(registered(moon, noise), algebra::Error);
}

/// A Sun of 100 pixels: darker towards its limb or, as in hydrogen's light, brighter; with two spots.
Luminance sun(double limb, const Camera& camera, algebra::Random& random) {
  constexpr std::size_t side = 260;
  constexpr double radius_px = 100, middle = 0.5 * side;
  Luminance light(side, side);
  for (std::size_t r = 0; r < side; ++r)
    for (std::size_t c = 0; c < side; ++c) {
      const double x = (static_cast<double>(c) + 0.5 - middle) / radius_px,
                   y = (static_cast<double>(r) + 0.5 - middle) / radius_px;
      if (x * x + y * y >= 1) continue;
      const bool spot = std::hypot(x - 0.3, y - 0.2) < 0.04 || std::hypot(x + 0.4, y + 0.3) < 0.03;
      light(r, c) =
          static_cast<float>(std::lerp(limb, 1, std::sqrt(1 - x * x - y * y)) * (spot ? 0.3 : 1));
    }
  return photographed(light, camera, random);
}

/// In the middle of totality light grows from the disc's middle to its limb, as on such a Sun.
TEST(Registration, RefusesTheSun) {
  algebra::Random random(8, 5);
  const auto moon = drawn(Moon({{0.1, 0}, 0.1}), {60, 0, 90, 90}, 180, 180);
  EXPECT_THROW(registered(sun(0.4, {.blur_px = 1, .noise = 0.005}, random), moon), algebra::Error);
  for (const double limb : {1.6, 3.}) {
    const auto why =
        refusal_of([&] { registered(sun(limb, {.blur_px = 1, .noise = 0.005}, random), moon); });
    EXPECT_TRUE(why.starts_with("correlation of markings")) << limb << ": " << why;
  }
}

}  // namespace coppermoon::colour::registration_test
