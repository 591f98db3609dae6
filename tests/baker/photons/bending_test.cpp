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

/// A ray worked out another way: no derivative of n, the midpoint rule, nothing known of where the air breaks.
struct Independent {
  Optics optics;
  double impact_height_m;
  double b_m = air.earth_radius_m + impact_height_m;
  double tangent_m = tangent_height();

  /// (n − 1) r
  double optical_excess(double h) const {
    return refractivity(air.column, optics, h) * (air.earth_radius_m + h);
  }
  double tangent_height() const {
    double h = impact_height_m;
    for (int i = 0; i < 200; ++i) h = impact_height_m - optical_excess(h);  // n r = b; slope < 0.2
    return h;
  }
  /// ∫ f(h) / √(n²r² − b²) dh from the tangent height to the top, over u = √(h − h_t).
  double along_half(const std::function<double(double)>& f) const {
    constexpr int points = 100'000;
    const double width = std::sqrt(air.top_m - tangent_m) / points;
    double sum = 0;
    for (int i = 0; i < points; ++i) {
      const double u = (i + 0.5) * width, h = tangent_m + u * u;
      const double excess = u * u + optical_excess(h) - optical_excess(tangent_m);  // n r − b
      sum += f(h) * 2 * u / std::sqrt(excess * (excess + 2 * b_m));
    }
    return sum * width;
  }
  /// The angle the ray sweeps about the Earth's centre inside the air, over what a straight line sweeps.
  double bending() const {
    const double swept = along_half([&](double h) { return b_m / (air.earth_radius_m + h); });
    return 2 * swept - 2 * std::acos(b_m / air.top_radius_m());
  }
  double optical_depth() const {
    return 2 * along_half([&](double h) {
             return extinction_per_m(air.column, optics, h) *
                    (air.earth_radius_m + h + optical_excess(h));
           });
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
      const Independent other{sea_level_optics(nanometres(nm)), impact_height_m};
      const auto ray = limb_ray(impact_height_m, air, {}, other.optics);
      if (!ray) continue;  // at 380 nm the lowest meets the ground
      EXPECT_WITHIN(ray->tangent_height_m, other.tangent_height(), 1e-7, "rounding");
      EXPECT_WITHIN_RELATIVE(ray->bending_rad, other.bending(), 1e-8, "the midpoint rule's, at the breaks of the air");
      EXPECT_WITHIN_RELATIVE(ray->optical_depth, other.optical_depth(), 1e-8,
                             "the midpoint rule's, at the breaks of the air");
    }
}

}  // namespace
}  // namespace coppermoon::photons
