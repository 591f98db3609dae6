// SPDX-License-Identifier: MIT
#include "shadow/by_quadrature.h"

#include <tbb/parallel_for.h>

#include <atomic>
#include <cmath>
#include <numbers>

#include "algebra/error.h"
#include "photons/bending.h"
#include "photons/solar_disc.h"

namespace coppermoon::shadow {
namespace {

using atmosphere::Atmosphere;

/// Rays from the ground to the air's top, evenly spaced in impact parameter.
struct Fan {
  std::vector<double> impact_parameter_m, bending_rad, transmittance;
};

Fan fan_at(const Atmosphere& atmosphere, double wavelength_nm, int rays) {
  const auto optics = atmosphere::sea_level_optics(algebra::nanometres(wavelength_nm));
  const auto& column = atmosphere.column;
  const double ground = atmosphere.earth_radius_m * refractivity(column, optics, 0);  // b − R = (n₀ − 1) R
  Fan fan;
  for (int i = 0; i < rays; ++i) {
    // a micrometre above the ground, which rounding must not lose
    const double height = std::lerp(ground + 1e-6, atmosphere.top_m, i / (rays - 1.));
    const auto ray = photons::limb_ray(height, atmosphere, column, optics);
    if (!ray) continue;
    fan.impact_parameter_m.push_back(atmosphere.earth_radius_m + height);
    fan.bending_rad.push_back(ray->bending_rad);
    fan.transmittance.push_back(ray->transmittance);
  }
  return fan;
}

/// A fan where it lands on one plane.
struct LandedFan {
  std::vector<double> radius_m;  ///< signed distance from the axis, where each ray lands
  std::vector<double> weight;    ///< T b Δb between each ray and the next
};

LandedFan landed(const Fan& fan, double sun_distance_m, double depth_m) {
  LandedFan on_plane;
  for (std::size_t i = 0; i < fan.impact_parameter_m.size(); ++i)
    on_plane.radius_m.push_back(
        landing_m(fan.impact_parameter_m[i], fan.bending_rad[i], sun_distance_m, depth_m));
  for (std::size_t i = 0; i + 1 < fan.impact_parameter_m.size(); ++i) {
    const double b0 = fan.impact_parameter_m[i], b1 = fan.impact_parameter_m[i + 1];
    on_plane.weight.push_back((fan.transmittance[i] * b0 + fan.transmittance[i + 1] * b1) / 2 * (b1 - b0));
  }
  return on_plane;
}

/// Σ T b Δb Φ: each pair of rays with the mean angle of the arcs between them.
double arcs_inside(const LandedFan& fan, double gamma, double a) {
  // ∫ |r| Φ dr from the axis to r: odd in r, so that a pair on either side of the axis is whole.
  const auto area = [&](double r) {
    const double shared = lens_area(gamma, std::abs(r), a);
    return r < 0 ? -shared : shared;
  };
  double sum = 0, below = area(fan.radius_m.front());
  for (std::size_t i = 0; i < fan.weight.size(); ++i) {
    const double r0 = fan.radius_m[i], r1 = fan.radius_m[i + 1], above = area(r1);
    const double whole = (r1 * std::abs(r1) - r0 * std::abs(r0)) / 2;
    if (whole != 0) sum += fan.weight[i] * (above - below) / whole;
    below = above;
  }
  return sum;
}

}  // namespace

RefractedLight by_quadrature(const Atmosphere& atmosphere, const Arrangement& arrangement,
                             std::span<const double> wavelengths_nm,
                             std::span<const double> axis_distances_m, int rays,
                             const algebra::Progress& progress) {
  require_valid(atmosphere);
  require_valid(arrangement);
  algebra::require_within("rays", rays, 2, 1e7);
  if (!atmosphere.symmetric())
    throw algebra::Error("solver quadrature needs air that is alike all around; use photons");
  const std::size_t planes = arrangement.depths_m.size(), distances = axis_distances_m.size(),
                    waves = wavelengths_nm.size();
  RefractedLight light{arrangement,
                       {wavelengths_nm.begin(), wavelengths_nm.end()},
                       {axis_distances_m.begin(), axis_distances_m.end()},
                       1,
                       {planes, algebra::Grid<double>(distances, waves)},
                       {planes, algebra::Grid<double>(distances, waves)}};
  if (atmosphere.top_m <= 0) return light;
  std::atomic<std::size_t> done = 0;
  tbb::parallel_for(std::size_t{0}, waves, [&](std::size_t w) {
    const auto fan = fan_at(atmosphere, wavelengths_nm[w], rays);
    for (std::size_t k = 0; k < planes; ++k) {
      const double depth = arrangement.depths_m[k], sun = arrangement.sun_distance_m;
      const double a = projected_solar_radius_m(arrangement, depth), spread = 1 + depth / sun;
      const auto on_plane = landed(fan, sun, depth);
      for (std::size_t d = 0; d < distances; ++d)
        light.ratio[k](d, w) = spread * spread / (std::numbers::pi * a * a) *
                               arcs_inside(on_plane, axis_distances_m[d], a);
    }
    if (progress) progress(static_cast<double>(++done) / static_cast<double>(waves));
  });
  return light;
}

}  // namespace coppermoon::shadow
