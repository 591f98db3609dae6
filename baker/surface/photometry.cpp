// SPDX-License-Identifier: MIT
#include "surface/photometry.h"

#include <cmath>

namespace coppermoon::surface {
namespace {

constexpr double a = 0.1, b = 0.9;

}  // namespace

double radiance_factor_yapo_cutler(double cos_incidence) {
  return cos_incidence > 0 ? cos_incidence / (a + b * cos_incidence) : 0;
}

double radiance_factor_yapo_cutler_disc_mean() {
  return 2 * (1 / (2 * b) - a / (b * b) + a * a / (b * b * b) * std::log((a + b) / a));
}

}  // namespace coppermoon::surface
