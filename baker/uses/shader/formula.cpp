// SPDX-License-Identifier: MIT
#include "uses/shader/formula.h"

#include <algorithm>
#include <numbers>
#include <optional>
#include <type_traits>
#include <utility>

#include "almanac/ephemeris.h"
#include "shadow/lookup_table.h"

namespace coppermoon::uses {
namespace {

/// A step of a formula under construction, with the operators of arithmetic.
struct Value {
  Formula* formula;
  std::size_t step;

  ValueKind kind() const { return formula->steps[step].kind; }

  /// Gives the step a name, under which expressions refer to it.
  Value named(std::string name, std::string meaning = {}) const {
    formula->steps[step].name = std::move(name);
    formula->steps[step].meaning = std::move(meaning);
    return *this;
  }
};

Value made(Formula& formula, Operation operation, ValueKind kind,
           std::vector<std::size_t> operands) {
  formula.steps.push_back({operation, kind, std::move(operands)});
  return {&formula, formula.steps.size() - 1};
}

Value number(Formula& formula, double value) {
  const auto constant = made(formula, Operation::constant, ValueKind::number, {});
  formula.steps.back().constant = {value};
  return constant;
}

Value vector(Formula& formula, const glm::dvec3& value) {
  const auto constant = made(formula, Operation::constant, ValueKind::vector, {});
  formula.steps.back().constant = {value.x, value.y, value.z};
  return constant;
}

Value of_two(Operation operation, Value a, Value b) {
  return made(*a.formula, operation, a.kind(), {a.step, b.step});
}
Value of_one(Operation operation, Value a) {
  return made(*a.formula, operation, a.kind(), {a.step});
}

Value operator+(Value a, Value b) { return of_two(Operation::add, a, b); }
Value operator-(Value a, Value b) { return of_two(Operation::subtract, a, b); }
Value operator*(Value a, Value b) { return of_two(Operation::multiply, a, b); }
Value operator/(Value a, Value b) { return of_two(Operation::divide, a, b); }
Value operator+(Value a, double b) { return a + number(*a.formula, b); }
Value operator-(Value a, double b) { return a - number(*a.formula, b); }
Value operator*(Value a, double b) { return a * number(*a.formula, b); }
Value operator/(Value a, double b) { return a / number(*a.formula, b); }

Value clamped(Value a) { return of_one(Operation::clamp, a); }
Value dot(Value a, Value b) {
  return made(*a.formula, Operation::dot, ValueKind::number, {a.step, b.step});
}
Value mix(Value a, Value b, Value share) {
  return made(*a.formula, Operation::mix, a.kind(), {a.step, b.step, share.step});
}

/// Horner's scheme: c0 + t (c1 + t (c2 + …)).
template <class Constant>
Value polynomial(Value t, const std::vector<Constant>& coefficients) {
  auto& formula = *t.formula;
  const auto constant = [&](const Constant& value) {
    if constexpr (std::is_same_v<Constant, double>)
      return number(formula, value);
    else
      return vector(formula, value);
  };
  auto sum = constant(coefficients.back());
  for (std::size_t i = coefficients.size() - 1; i-- > 0;) sum = sum * t + constant(coefficients[i]);
  return sum;
}

/// Steps in the order in which the result needs them, so that each compiler makes the same text.
Formula in_order(const Formula& formula) {
  Formula sorted;
  std::vector<std::optional<std::size_t>> place(formula.steps.size());
  const auto add = [&](const auto& self, std::size_t step) -> std::size_t {
    if (place[step]) return *place[step];
    auto copy = formula.steps[step];
    for (auto& operand : copy.operands) operand = self(self, operand);
    sorted.steps.push_back(std::move(copy));
    place[step] = sorted.steps.size() - 1;
    return *place[step];
  };
  add(add, formula.result());
  return sorted;
}

}  // namespace

bool Formula::varies(std::size_t step) const {
  const auto& all = steps[step];
  return all.operation == Operation::place ||
         std::ranges::any_of(all.operands, [&](std::size_t of) { return varies(of); });
}

Formula shadow_formula(const ShadowMotion& motion, const LightStrip& strip) {
  Formula formula;
  const double radius_km = algebra::in_kilometres(almanac::lunar_radius);
  const auto radii = [&](double km) { return km / radius_km; };
  const auto time = made(formula, Operation::time, ValueKind::number, {}).named("time");
  const auto place = made(formula, Operation::place, ValueKind::vector, {}).named("place");

  const auto moment = (clamped(time / (2 * motion.half_s) + 0.5) * 2. - 1.)
                          .named("moment", "-1 to 1; outside, its ends hold");
  const auto axis = [&](std::size_t k, const char* name, const char* meaning) {
    return polynomial(moment, motion.axes[k]).named(name, meaning);
  };
  const auto centre = [&](std::size_t k, const char* name) {
    return polynomial(moment, motion.centre[k]).named(name, "the Moon's centre [lunar radii]");
  };
  const auto ground = of_one(Operation::normalize, place).named("ground");
  const auto to_east = (dot(axis(0, "east", "celestial east, on Moon-fixed axes"), ground) +
                        centre(0, "centre_east"))
                           .named("to_east", "the place in the shadow [lunar radii]"),
             to_north =
                 (dot(axis(1, "north", "celestial north"), ground) + centre(1, "centre_north"))
                     .named("to_north"),
             depth = (dot(axis(2, "away", "away from the Sun"), ground) + centre(2, "centre_depth"))
                         .named("depth");
  const auto distance = of_one(Operation::square_root, to_east * to_east + to_north * to_north)
                            .named("from_axis", "distance from the shadow's axis");
  const auto one_limb =
      of_two(Operation::minimum, distance / radii(shadow::one_limb_m / 1e3), number(formula, 1));
  const auto deeper_by = number(formula, radii(strip.middle_km())) / depth - 1.;
  const auto in_middle =
      (distance + (distance - radii(shadow::limb_m / 1e3)) * deeper_by * one_limb)
          .named("in_middle", "the same in the middle plane, along a line from the limb");
  const auto stretch = [&](std::size_t s) {
    const double from = s == 0 ? 0 : strip.ends_km[s - 1], to = strip.ends_km[s];
    return clamped((in_middle - radii(from)) / radii(to - from)) *
           static_cast<double>(strip.stretches[s]);
  };
  const auto columns = static_cast<double>(strip.roots.width),
             rows = static_cast<double>(strip.roots.height);
  const auto along = ((stretch(0) + stretch(1) + stretch(2) + stretch(3) + 0.5) / columns)
                         .named("along", "place in the strip");
  // 1e-9: on the axis itself an arc tangent has no angle
  const auto angle = made(formula, Operation::arc_tangent, ValueKind::number,
                          {(to_east + 1e-9).step, to_north.step});
  const auto turns = (angle / (2 * std::numbers::pi)).named("turns", "position angle");
  const auto around =
      (turns - of_one(Operation::floor, turns)) * static_cast<double>(strip.sectors);
  const auto across = ((around + 0.5) / rows).named("across", "in the rows of the nearest plane");
  const auto deeper =
      clamped((depth - radii(strip.nearest_km)) / radii(strip.farthest_km - strip.nearest_km))
          .named("deeper", "from the nearest plane to the farthest");
  const auto texel = [&](Value row) {
    return made(formula, Operation::texel, ValueKind::colour, {along.step, row.step});
  };
  auto root = texel(across);
  const auto intervals = static_cast<double>(strip.planes - 1);
  for (std::size_t p = 1; p < strip.planes; ++p) {
    const auto plane = static_cast<double>(p);
    root = mix(root, texel(across + plane / (intervals + 1)),
               clamped(deeper * intervals - (plane - 1)));
  }
  root = root.named("root", "square root of light over sunlight");
  (root * root).named("light");
  formula = in_order(formula);
  return formula;
}

}  // namespace coppermoon::uses
