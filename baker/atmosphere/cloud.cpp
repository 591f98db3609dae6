// SPDX-License-Identifier: MIT
#include "atmosphere/cloud.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "algebra/error.h"
#include "algebra/interpolation.h"

namespace coppermoon::atmosphere {

double smooth_step(double t) {
  t = std::clamp(t, 0., 1.);
  return t * t * (3 - 2 * t);
}

double cloud_chance_per_m(algebra::Angle latitude) {
  constexpr std::array<double, 10> degrees{0, 10, 20, 30, 40, 50, 60, 70, 80, 90};
  constexpr std::array<double, 10> high_cloud{.241, .205, .168, .159, .192,
                                              .227, .250, .254, .231, .198};
  constexpr std::array<double, 2> known_degrees{10, 65}, known_high_cloud{0.223, 0.252},
      known_per_m{1.74e-6, 1.46e-6};
  algebra::require_within("latitude [degrees]", algebra::in_degrees(latitude), -90, 90);
  const double away = std::abs(algebra::in_degrees(latitude));
  return algebra::interpolated(known_degrees, known_per_m, away) *
         algebra::interpolated(degrees, high_cloud, away) /
         algebra::interpolated(known_degrees, known_high_cloud, away);
}

double cloud_profile(double tropopause_m, double altitude_m) {
  const double under_m = tropopause_m - altitude_m;
  // FAULT a tropopause that wanders half as far: under_m + tropopause_wander_m => under_m
  return smooth_step((under_m + tropopause_wander_m) / (2 * tropopause_wander_m));
}

double cirrus_extinction_per_m(double tropopause_m, double altitude_m) {
  constexpr double under_m = 3e3, share_of_time = 0.5, thick_m = 1e3, extinction_per_m = 2e-6;
  constexpr double mean = share_of_time * thick_m / under_m * extinction_per_m;
  const double above_m = altitude_m - tropopause_m;
  return mean * smooth_step(1 - above_m / tropopause_wander_m) *
         smooth_step(1 + (above_m + under_m) / tropopause_wander_m);
}

}  // namespace coppermoon::atmosphere
