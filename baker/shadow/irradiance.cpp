// SPDX-License-Identifier: MIT
#include "shadow/irradiance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "algebra/error.h"
#include "photons/solar_disc.h"

namespace coppermoon::shadow {
void require_valid(const Arrangement& arrangement) {
  algebra::require_within("Sun's distance [km]", arrangement.sun_distance_m / 1e3, 4.5e7, 4.5e8);
  for (const double depth : arrangement.depths_m)
    algebra::require_within("distance behind the Earth [km]", depth / 1e3, 1e5, 1e6);
}

double lens_area(double apart, double r, double s) {
  const double smaller = std::min(r, s), larger = std::max(r, s);
  if (apart >= r + s) return 0;
  if (apart <= larger - smaller) return std::numbers::pi * smaller * smaller;
  const auto cosine = [](double x) { return std::clamp(x, -1., 1.); };  // rounding at first contact
  // of half the angles at which each centre sees the common chord
  const double cos_r = cosine((apart * apart + r * r - s * s) / (2 * apart * r));
  const double cos_s = cosine((apart * apart + s * s - r * r) / (2 * apart * s));
  const auto segment = [](double c) { return std::acos(c) - c * std::sqrt(1 - c * c); };
  return r * r * segment(cos_r) + s * s * segment(cos_s);
}

double projected_solar_radius_m(const Arrangement& arrangement, double depth_m) {
  return photons::solar_radius_m * depth_m / arrangement.sun_distance_m;
}

double landing_m(double impact_parameter_m, double bending_rad, double sun_distance_m,
                 double depth_m) {
  const double slope = std::asin(impact_parameter_m / sun_distance_m) - bending_rad;
  return impact_parameter_m / std::cos(slope) + depth_m * std::tan(slope);
}

double refracted_reach_m(const Arrangement& arrangement, const atmosphere::Atmosphere& atmosphere,
                         double depth_m) {
  return landing_m(atmosphere.top_radius_m(), 0, arrangement.sun_distance_m, depth_m) +
         projected_solar_radius_m(arrangement, depth_m);
}

double direct_ratio(double axis_distance_m, double depth_m, double sun_distance_m,
                    double opaque_radius_m) {
  const double sun = photons::solar_radius_m * depth_m / sun_distance_m;
  const double earth = landing_m(opaque_radius_m, 0, sun_distance_m, depth_m);
  const double covered = lens_area(axis_distance_m, sun, earth);
  return std::max(0., 1 - covered / (std::numbers::pi * sun * sun));
}

}  // namespace coppermoon::shadow
