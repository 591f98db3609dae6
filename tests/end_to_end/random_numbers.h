// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "algebra/random.h"

namespace coppermoon::end_to_end {

using algebra::Random;

/// Number between two others, evenly.
inline double between(Random& random, double least, double most) {
  return least + (most - least) * random.uniform();
}

/// Number between two others, evenly in its logarithm.
inline double log_between(Random& random, double least, double most) {
  return least * std::pow(most / least, random.uniform());
}

/// Number of the standard normal distribution.
inline double normal(Random& random) {
  return std::sqrt(-2 * std::log(1 - random.uniform())) *
         std::cos(2 * std::numbers::pi * random.uniform());
}

/// One of some values, each as likely.
template <typename Value, std::size_t count>
Value one_of(Random& random, const std::array<Value, count>& values) {
  return values[static_cast<std::size_t>(random.uniform() * count)];
}

}  // namespace coppermoon::end_to_end
