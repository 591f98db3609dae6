// SPDX-License-Identifier: MIT
#include "photons/bending.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "algebra/error.h"
#include "support/within.h"

namespace coppermoon::photons {
namespace {

using algebra::nanometres;
using algebra::radians;
using atmosphere::Atmosphere;
using atmosphere::Column;
using atmosphere::Optics;
using atmosphere::sea_level_optics;

constexpr double arcminute = std::numbers::pi / 180 / 60;
const Atmosphere air;
const Optics green = sea_level_optics(nanometres(550));

/// Milne's open rule on three points.
double milne(const std::function<double(double)>& f, double a, double b) {
  const double quarter = (b - a) / 4;
  return (b - a) / 3 * (2 * f(a + quarter) - f(a + 2 * quarter) + 2 * f(b - quarter));
}

/// Halved wherever two halves do not agree with the whole: finds the breaks of f by itself.
double adaptive(const std::function<double(double)>& f, double a, double b, double tolerance,
                int depth = 40) {
  const double middle = (a + b) / 2, whole = milne(f, a, b);
  const double halves = milne(f, a, middle) + milne(f, middle, b);
  if (depth == 0 || std::abs(halves - whole) < tolerance) return halves + (halves - whole) / 15;
  return adaptive(f, a, middle, tolerance / 2, depth - 1) +
         adaptive(f, middle, b, tolerance / 2, depth - 1);
}

/// A ray worked out another way: no derivative of n, other quadrature, nothing known of the breaks.
struct Independent {
  Column column;
  Optics optics;
  double impact_height_m;

  double excess(double h) const {  // n r − b
    return h - impact_height_m +
           refractivity(column, optics, h) * (air.earth_radius_m + h);
  }
  double tangent_height() const {
    double low = -1e4, high = air.top_m;
    for (int i = 0; i < 200; ++i) {
      const double at = (low + high) / 2;
      (excess(at) < 0 ? low : high) = at;
    }
    return high;
  }
  /// 2 ∫ f(h) / √(n²r² − b²) dh from the tangent height to the top, over √(h − h_t).
  double along_ray(const std::function<double(double)>& f, double tolerance) const {
    const double tangent_m = tangent_height(), r0 = air.earth_radius_m;
    const auto integrand = [&](double u) {
      const double h = tangent_m + u * u;
      const double sum = excess(h) + 2 * (r0 + impact_height_m);  // n r + b
      return 4 * u * f(h) / std::sqrt(excess(h) * sum);
    };
    return adaptive(integrand, 0, std::sqrt(air.top_m - tangent_m), tolerance);
  }
  /// The angle swept about the Earth's centre, 2 ∫ b / (r √(n²r² − b²)) dr in the air and asin(b/r₁) at
  /// either side of it, over the half circle that a straight line sweeps.
  double bending() const {
    const double r0 = air.earth_radius_m, b = r0 + impact_height_m;
    const double swept = along_ray([&](double h) { return b / (r0 + h); }, 1e-12);
    return swept - 2 * std::acos(b / air.top_radius_m());
  }
  double optical_depth() const {
    const double r0 = air.earth_radius_m;
    return along_ray(
        [&](double h) {
          return extinction_per_m(column, optics, h) * (1 + refractivity(column, optics, h)) *
                 (r0 + h);
        },
        1e-10);
  }
};

LimbRay ray_at(double impact_height_m, const Column& column = {}, const Optics& optics = green) {
  const auto ray = limb_ray(impact_height_m, air, column, optics);
  if (!ray) throw algebra::Error("the ray meets the ground");
  return *ray;
}

struct Printed {
  double impact_height_m, tangent_height_m, bending_arcmin, optical_depth, bending_tolerance;
};

// A table computed elsewhere for 550 nm. Its quadrature did not split where the density's slope breaks: its
// low rays' bending is off by up to 3.6e-4 against the independent computation above, which the next
// test holds to 1e-9; its optical depths, whose integrand has no slope in it, are not.
constexpr Printed printed[] = {{2500, 876.4, 60.807, 6.6729, 1.5e-4},
                               {5000, 3790.9, 46.189, 4.7152, 4e-4},
                               {10000, 9353.3, 26.334, 2.26635, 3e-5},
                               {20000, 19868.7, 5.6940, 0.42626, 3e-5},
                               {30000, 29973.2, 1.1517, 0.08196, 4e-4}};

TEST(LimbRay, IsThatOfATableComputedElsewhere) {
  for (const auto& row : printed) {
    const auto ray = ray_at(row.impact_height_m);
    EXPECT_WITHIN(ray.tangent_height_m, row.tangent_height_m, 0.06, "printed to 0.1 m");
    EXPECT_WITHIN_RELATIVE(ray.bending_rad / arcminute, row.bending_arcmin, row.bending_tolerance,
                           "that table's quadrature, see above; else 5 digits");
    EXPECT_WITHIN_RELATIVE(ray.optical_depth, row.optical_depth, 1e-4, "printed to 4 or 5 digits");
  }
}

TEST(LimbRay, IsThatOfTheSweptAngle) {
  for (const double impact_height_m : {1768.0, 2500.0, 5000.0, 10e3, 12.5e3, 20e3, 30e3, 38e3, 41e3})
    for (const double nm : {380.0, 550.0, 780.0}) {
      const Independent other{{}, sea_level_optics(nanometres(nm)), impact_height_m};
      const auto ray = limb_ray(impact_height_m, air, {}, other.optics);
      if (!ray) continue;  // at 380 nm the lowest meets the ground
      EXPECT_WITHIN(ray->tangent_height_m, other.tangent_height(), 1e-7, "rounding");
      EXPECT_WITHIN_RELATIVE(ray->bending_rad, other.bending(), 1e-8, "the adaptive rule's");
      EXPECT_WITHIN_RELATIVE(ray->optical_depth, other.optical_depth(), 1e-8,
                             "the adaptive rule's");
    }
}

}  // namespace
}  // namespace coppermoon::photons
