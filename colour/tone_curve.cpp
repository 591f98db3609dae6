// SPDX-License-Identifier: MIT
#include "colour/tone_curve.h"

#include <algorithm>
#include <cmath>

#include "algebra/interpolation.h"
#include "algebra/table.h"
#include "colour/srgb.h"
#include "colour/tables.h"

namespace coppermoon::colour {
namespace {

/// Standard deviation that the three components leave unexplained at each level; see the accuracy of ToneCurve.
constexpr std::array<double, tone_levels> left_over = [] {
  std::array<double, tone_levels> all{0.4, 0.1, 0.04};  // near black, few cameras were measured
  std::fill(all.begin() + 3, all.end(), 0.025);
  return all;
}();

constexpr double first_level = 0.04, last_level = 0.96;

const algebra::Table& table() {
  static const auto read =
      algebra::parse_table(tables::camera_tone_curves(), "camera_tone_curves.csv");
  return read;
}

double component(const char* name, double level) {
  return algebra::interpolated(table()["level"], table()[name], level);
}

}  // namespace

std::array<double, tone_numbers> tone_derivatives(double displayed) {
  const double level = srgb_code(std::clamp(displayed, 0., 1.));
  std::array<double, tone_numbers> derivatives{
      component("first", level), component("second", level), component("third", level)};
  const double place = std::clamp((level - first_level) / (last_level - first_level), 0., 1.) *
                       static_cast<double>(tone_levels - 1);
  const auto tent = std::min(static_cast<std::size_t>(place), tone_levels - 2);
  const double beyond = place - static_cast<double>(tent);
  derivatives[tone_components + tent] = left_over[tent] * (1 - beyond);
  derivatives[tone_components + tent + 1] = left_over[tent + 1] * beyond;
  return derivatives;
}

double tone_logarithm(const ToneCurve& curve, double displayed) {
  double logarithm = component("mean", srgb_code(std::clamp(displayed, 0., 1.)));
  const auto derivatives = tone_derivatives(displayed);
  for (std::size_t k = 0; k < tone_numbers; ++k) logarithm += curve.numbers[k] * derivatives[k];
  return logarithm;
}

ToneTable::ToneTable(const ToneCurve& curve) {
  constexpr std::size_t intervals = 4096;
  for (std::size_t i = 0; i <= intervals; ++i) {
    const double root = static_cast<double>(i) / intervals;
    factors_.push_back(static_cast<float>(std::exp(tone_logarithm(curve, root * root))));
  }
}

float ToneTable::operator()(float displayed) const {
  if (!(displayed > 0)) return displayed;
  const float light = std::min(displayed, 1.F);
  const float place = std::sqrt(light) * static_cast<float>(factors_.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(place), factors_.size() - 2);
  const float beyond = place - static_cast<float>(i);
  return light * (factors_[i] + beyond * (factors_[i + 1] - factors_[i]));
}

}  // namespace coppermoon::colour
