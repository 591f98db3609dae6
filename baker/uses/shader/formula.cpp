// SPDX-License-Identifier: MIT
#include "uses/shader/formula.h"

#include <map>
#include <memory>
#include <numbers>
#include <utility>

#include "almanac/ephemeris.h"
#include "shadow/lookup_table.h"

namespace coppermoon::uses {
namespace {

/// A node in an expression tree: a step of the formula together with its operands.
class Value {
 public:
  // NOLINTBEGIN(google-explicit-constructor): numbers and vectors are operands as they are
  Value(double x) : Value("constant", number_type, {}) { node_->step.constant = {x}; }
  Value(const glm::dvec3& v) : Value("constant", vector_type, {}) {
    node_->step.constant = {v.x, v.y, v.z};
  }
  // NOLINTEND(google-explicit-constructor)
  Value(const char* operation, const std::string& type, std::vector<Value> operands)
      : node_(std::make_shared<Node>(Step{operation, type}, std::move(operands))) {}

  const std::string& type() const { return node_->step.type; }

  /// Gives the step a name, by which expressions in the shader refer to it.
  Value named(std::string name, std::string meaning = {}) const {
    node_->step.name = std::move(name);
    node_->step.meaning = std::move(meaning);
    return *this;
  }

  /// All steps needed to compute this value, in order of evaluation.
  Formula formula() const {
    Formula steps;
    std::map<const Node*, std::size_t> places;
    add_to(steps, places);
    return steps;
  }

 private:
  struct Node {
    Step step;
    std::vector<Value> operands;

    Node(Step what, std::vector<Value> of) : step(std::move(what)), operands(std::move(of)) {}
  };

  std::size_t add_to(Formula& steps, std::map<const Node*, std::size_t>& places) const {
    if (const auto known = places.find(node_.get()); known != places.end()) return known->second;
    auto step = node_->step;
    for (const auto& operand : node_->operands)
      step.operands.push_back(operand.add_to(steps, places));
    steps.push_back(std::move(step));
    return places[node_.get()] = steps.size() - 1;
  }

  std::shared_ptr<Node> node_;
};

Value operator+(const Value& a, const Value& b) { return {"add", a.type(), {a, b}}; }
Value operator-(const Value& a, const Value& b) { return {"subtract", a.type(), {a, b}}; }
Value operator*(const Value& a, const Value& b) { return {"multiply", a.type(), {a, b}}; }
Value operator/(const Value& a, const Value& b) { return {"divide", a.type(), {a, b}}; }
Value of_numbers(const char* operation, std::vector<Value> numbers) {
  return {operation, number_type, std::move(numbers)};
}
Value clamped(const Value& a) { return of_numbers("clamp", {a}); }

/// Expression for a power series in t by Horner's scheme: c0 + t (c1 + t (c2 + …)).
template <class Constant>
Value polynomial(const Value& t, const std::vector<Constant>& coefficients) {
  Value sum = coefficients.back();
  for (std::size_t i = coefficients.size() - 1; i-- > 0;) sum = sum * t + coefficients[i];
  return sum;
}

}  // namespace

Formula shadow_formula(const ShadowMotion& motion, const LightStrip& strip) {
  const auto radii = [](double km) { return km / algebra::in_kilometres(almanac::lunar_radius); };
  const auto time = of_numbers("time", {}).named("time");
  const auto place = Value("place", vector_type, {}).named("place");

  const auto moment = (clamped(time / (2 * motion.half_s) + 0.5) * 2. - 1.)
                          .named("moment", "-1 to 1; outside, its ends hold");
  const auto ground = Value("normalize", vector_type, {place}).named("ground");
  const auto along_axis = [&](std::size_t k, const char* name, const char* meaning,
                              const char* centre) {
    return of_numbers("dotproduct",
                      {polynomial(moment, motion.axes[k]).named(name, meaning), ground}) +
           polynomial(moment, motion.centre[k]).named(centre, "the Moon's centre [lunar radii]");
  };
  const auto to_east = along_axis(0, "east", "celestial east, on Moon-fixed axes", "centre_east")
                           .named("to_east", "the place in the shadow [lunar radii]"),
             to_north = along_axis(1, "north", "celestial north", "centre_north").named("to_north"),
             depth = along_axis(2, "away", "away from the Sun", "centre_depth").named("depth");
  const auto distance = of_numbers("sqrt", {to_east * to_east + to_north * to_north})
                            .named("from_axis", "distance from the shadow's axis");
  const auto one_limb = of_numbers("min", {distance / radii(shadow::one_limb_m / 1e3), 1.});
  const auto deeper_by = radii(strip.middle_km()) / depth - 1.;
  const auto in_middle =
      (distance + (distance - radii(shadow::limb_m / 1e3)) * deeper_by * one_limb)
          .named("in_middle", "the same in the middle plane, along a line from the limb");
  const auto stretch = [&](std::size_t s) {
    const double from = strip.from_km(s);
    return clamped((in_middle - radii(from)) / radii(strip.ends_km[s] - from)) *
           static_cast<double>(strip.stretches[s]);
  };
  const auto columns = static_cast<double>(strip.roots.width),
             rows = static_cast<double>(strip.roots.height);
  const auto along = ((stretch(0) + stretch(1) + stretch(2) + stretch(3) + 0.5) / columns)
                         .named("along", "place in the strip");
  // adding 1e-9 avoids atan2(0, 0), which is undefined
  const auto turns = (of_numbers("atan2", {to_east + 1e-9, to_north}) / (2 * std::numbers::pi))
                         .named("turns", "position angle");
  const auto around = (turns - of_numbers("floor", {turns})) * static_cast<double>(strip.sectors);
  const auto across = ((around + 0.5) / rows).named("across", "in the rows of the nearest plane");
  const auto deeper =
      clamped((depth - radii(strip.nearest_km)) / radii(strip.farthest_km - strip.nearest_km))
          .named("deeper", "from the nearest plane to the farthest");
  const auto texel = [&](const Value& row) { return Value("image", colour_type, {along, row}); };
  auto root = texel(across);
  const auto intervals = static_cast<double>(strip.planes - 1);
  for (std::size_t p = 1; p < strip.planes; ++p) {
    const auto plane = static_cast<double>(p);
    const auto share = clamped(deeper * intervals - (plane - 1));
    root = {"mix", colour_type, {root, texel(across + plane / (intervals + 1)), share}};
  }
  root = root.named("root", "square root of light over sunlight");
  return (root * root).named("light").formula();
}

}  // namespace coppermoon::uses
