// SPDX-License-Identifier: MIT
// The formula, worked out step by step, of a Moon that stands still in a shadow
// of known light.
#include "uses/shader/formula.h"

#include "support/testing.h"

namespace coppermoon::uses::formula_test {

using Numbers = std::array<double, 3>;

/// A texel of red alone, linearly interpolated, as a renderer reads it.
double texel(const texture::Image& image, double u, double v) {
  const double x = u * static_cast<double>(image.width) - 0.5,
               y = v * static_cast<double>(image.height) - 0.5;
  const auto before = [](double at, std::size_t size) {
    return static_cast<std::size_t>(std::clamp(at, 0., static_cast<double>(size - 2)));
  };
  const auto c = before(x, image.width), r = before(y, image.height);
  const double right = std::clamp(x - static_cast<double>(c), 0., 1.),
               down = std::clamp(y - static_cast<double>(r), 0., 1.);
  return std::lerp(std::lerp(image(r, c, 0), image(r, c + 1, 0), right),
                   std::lerp(image(r + 1, c, 0), image(r + 1, c + 1, 0), right), down);
}

/// Values of a formula's steps, by what its operations are said to do.
struct Machine {
  const Formula& formula;
  const texture::Image& strip;

  double light(const Numbers& place, double time_s) const {
    std::vector<Numbers> values;
    for (const auto& step : formula) values.push_back(value(step, values, place, time_s));
    return values.back()[0];
  }

 private:
  Numbers value(const Step& step, const std::vector<Numbers>& of, const Numbers& place,
                double time_s) const {
    const auto operand = [&](std::size_t i) { return of[step.operands[i]]; };
    const auto type = [&](std::size_t i) { return formula[step.operands[i]].type; };
    const auto each = [&](const auto& function) {
      Numbers all;
      for (std::size_t k = 0; k < 3; ++k) all[k] = function(k);
      return all;
    };
    const auto of_two = [&](const auto& function) {
      const auto a = operand(0), b = operand(1);
      const bool scaled = type(1) == number_type;
      return each([&](std::size_t k) { return function(a[k], scaled ? b[0] : b[k]); });
    };
    const auto dot = [](const Numbers& a, const Numbers& b) {
      return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    };
    const auto& operation = step.operation;
    if (operation == "place") return place;
    if (operation == "time") return {time_s};
    if (operation == "constant") return step.constant;
    if (operation == "add") return of_two(std::plus{});
    if (operation == "subtract") return of_two(std::minus{});
    if (operation == "multiply") return of_two(std::multiplies{});
    if (operation == "divide") return of_two(std::divides{});
    if (operation == "min") return of_two([](double a, double b) { return std::min(a, b); });
    if (operation == "clamp")
      return each([&](std::size_t k) { return std::clamp(operand(0)[k], 0., 1.); });
    if (operation == "dotproduct") return {dot(operand(0), operand(1))};
    if (operation == "normalize") {
      const double length = std::sqrt(dot(operand(0), operand(0)));
      return each([&](std::size_t k) { return operand(0)[k] / length; });
    }
    if (operation == "sqrt") return {std::sqrt(operand(0)[0])};
    if (operation == "atan2") return {std::atan2(operand(0)[0], operand(1)[0])};
    if (operation == "floor") return {std::floor(operand(0)[0])};
    if (operation == "mix")
      return each(
          [&](std::size_t k) { return std::lerp(operand(0)[k], operand(1)[k], operand(2)[0]); });
    EXPECT_EQ(operation, "image");
    return {texel(strip, operand(0)[0], operand(1)[0])};
  }
};

/// The Moon's centre, east of the axis [lunar radii], with its axes along the
/// shadow's; it moves by `speed` to half_s.
ShadowMotion moon_at(double east, double speed = 0) {
  return {.half_s = 3600,
          .centre = {{{east, speed}, {0}, {220}}},
          .axes = {{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}},
          .nearest = 220,
          .farthest = 220};
}

constexpr double radius_km = 1737.4, depth_km = 220 * radius_km;

/// Strip whose roots are `root` of the column, from 0 to 1, and the share of a
/// turn; its planes stand on either side of the Moon's centre.
LightStrip strip_of(double (*root)(double along, double turn)) {
  LightStrip strip{.roots = texture::Image(9, 10, {"R", "G", "B"}),
                   .ends_km = {2000, 4000, 6000, 8000},
                   .stretches = {2, 2, 2, 2},
                   .sectors = 4,
                   .nearest_km = depth_km - 1000,
                   .farthest_km = depth_km + 1000};
  for (std::size_t r = 0; r < 10; ++r)
    for (std::size_t c = 0; c < 9; ++c)
      for (std::size_t k = 0; k < 3; ++k)
        strip.roots(r, c, k) =
            static_cast<float>(root(static_cast<double>(c) / 8, static_cast<double>(r % 5) / 4));
  return strip;
}

double light_at(const ShadowMotion& motion, const LightStrip& strip, double seconds = 0,
                const Numbers& place = {1, 0, 0}) {
  const auto formula = shadow_formula(motion, strip);
  return Machine{formula, strip.roots}.light(place, seconds);
}

constexpr const char* rounding = "float in the strip";

TEST(ShadowFormula, ReadsTheStripAtTheDistanceFromTheAxis) {
  const auto strip = strip_of([](double along, double) { return along; });
  for (const double east : {-1., 0., 0.7, 1.6, 2.4}) {
    const double distance_km = std::abs(east + 1) * radius_km;
    EXPECT_WITHIN(light_at(moon_at(east), strip), std::pow(distance_km / 8000, 2), 1e-6, rounding);
  }
  EXPECT_EQ(light_at(moon_at(5), strip), 1) << "beside the shadow";
}

TEST(ShadowFormula, ReadsTheStripAtThePositionAngle) {
  const auto strip = strip_of([](double, double turn) { return turn; });
  EXPECT_WITHIN(light_at(moon_at(1), strip), std::pow(0.25, 2), 1e-6,
                "east is a quarter of a turn");
  EXPECT_WITHIN(light_at(moon_at(-3), strip), std::pow(0.75, 2), 1e-6, "west three");
  const double turn = std::atan2(1.6, 0.8) / (2 * std::numbers::pi);
  EXPECT_WITHIN(light_at(moon_at(1), strip, 0, {0.6, 0.8, 0}), turn * turn, 1e-6, rounding);
}

TEST(ShadowFormula, FollowsTheMoonAndHoldsItsEnds) {
  const auto strip = strip_of([](double along, double) { return along; });
  const auto motion = moon_at(1, 0.5);
  const auto after = [&](double seconds) {
    return std::sqrt(light_at(motion, strip, seconds)) * 8000 / radius_km;
  };
  EXPECT_WITHIN(after(1800), 2.25, 1e-5, rounding);
  EXPECT_WITHIN(after(-3600), 1.5, 1e-5, rounding);
  EXPECT_EQ(after(5000), after(3600));
}

TEST(ShadowFormula, MixesItsPlanesByDepth) {
  auto strip = strip_of([](double, double) { return 0.5; });
  for (std::size_t r = 5; r < 10; ++r)
    for (std::size_t c = 0; c < 9; ++c) strip.roots(r, c, 0) = 1;
  for (const double deeper_km : {-2000., -500., 0., 800., 3000.}) {
    auto motion = moon_at(1);
    motion.centre[2] = {(depth_km + deeper_km) / radius_km};
    const double share = std::clamp((deeper_km + 1000) / 2000, 0., 1.);
    EXPECT_WITHIN(light_at(motion, strip), std::pow(std::lerp(0.5, 1., share), 2), 1e-6, rounding);
  }
}

TEST(ShadowFormula, HasOperandsBeforeWhatIsComputedFromThem) {
  const auto formula =
      shadow_formula(moon_at(1), strip_of([](double along, double) { return along; }));
  for (std::size_t i = 0; i < formula.size(); ++i)
    for (const auto operand : formula[i].operands) EXPECT_LT(operand, i);
}

}  // namespace coppermoon::uses::formula_test
