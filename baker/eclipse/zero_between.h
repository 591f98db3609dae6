// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace coppermoon::eclipse {

/// Finds, to 1 ms, a zero of f between the moments a and b [s], at which f has opposite signs. It uses the Illinois
/// variant of the method of false position.
template <class Function>
double zero_between(Function f, double a, double b) {
  double fa = f(a), fb = f(b);
  for (int round = 0; round < 60; ++round) {
    const double c = b - fb * (b - a) / (fb - fa), fc = f(c);
    if (std::abs(c - b) < 1e-3) return c;
    if ((fc < 0) != (fb < 0)) {
      a = b;
      fa = fb;
    } else {
      fa /= 2;
    }
    b = c;
    fb = fc;
  }
  return b;
}

}  // namespace coppermoon::eclipse
