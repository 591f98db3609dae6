// SPDX-License-Identifier: MIT
#include "shadow/by_quadrature.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>

#include "algebra/error.h"
#include "atmosphere/density.h"
#include "photons/bending.h"
#include "photons/solar_disc.h"

namespace coppermoon::shadow {
namespace {

using atmosphere::Atmosphere;

/// Rays from the ground to the air's top.
struct Fan {
  std::vector<double> impact_parameter_m, bending_rad, transmittance;
};

/// Tangent heights where the air's slope breaks, with its ends. Below each, bending and optical
/// depth of the rays that dip under it leave it like a square root.
std::vector<double> breaks_of(const Atmosphere& atmosphere) {
  std::vector<double> breaks{0, atmosphere.column.dust_bottom_m, atmosphere.column.dust_top_m,
                             atmosphere.top_m};
  const auto density = atmosphere::density_breaks_m();
  breaks.insert(breaks.end(), density.begin(), density.end());
  std::sort(breaks.begin(), breaks.end());
  std::erase_if(breaks, [&](double h) { return h > atmosphere.top_m; });
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  return breaks;
}

/// b − R, ever closer towards the upper end of each smooth piece, where the square roots are.
std::vector<double> impact_heights(const Atmosphere& atmosphere, const atmosphere::Optics& optics,
                                   int rays) {
  const auto impact_height = [&](double h) {
    return h + refractivity(atmosphere.column, optics, h) * (atmosphere.earth_radius_m + h);
  };
  const auto breaks = breaks_of(atmosphere);
  std::vector<double> heights;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const double low = impact_height(breaks[i]), high = impact_height(breaks[i + 1]);
    const int here =
        std::max(4, static_cast<int>(rays * (breaks[i + 1] - breaks[i]) / atmosphere.top_m));
    for (int k = 0; k < here; ++k) {
      const double left = 1 - static_cast<double>(k) / here;
      heights.push_back(high - (high - low) * left * left);
    }
  }
  heights.front() += 1e-6;  // a micrometre above the ground, which rounding must not lose
  heights.push_back(atmosphere.top_m);
  return heights;
}

Fan fan_at(const Atmosphere& atmosphere, double wavelength_nm, int rays) {
  const auto optics = atmosphere::sea_level_optics(algebra::nanometres(wavelength_nm));
  Fan fan;
  for (const double height : impact_heights(atmosphere, optics, rays)) {
    const auto ray = photons::limb_ray(height, atmosphere, atmosphere.column, optics);
    if (!ray) continue;
    fan.impact_parameter_m.push_back(atmosphere.earth_radius_m + height);
    fan.bending_rad.push_back(ray->bending_rad);
    fan.transmittance.push_back(ray->transmittance);
  }
  return fan;
}

/// The mean between two positive ends of what falls exponentially from one to the other.
double logarithmic_mean(double x, double y) {
  const double ratio = y / x - 1;
  if (!(std::abs(ratio) > 1e-4)) return (x + y) / 2;  // alike, or both 0
  return y > 0 ? (y - x) / std::log1p(ratio) : 0;
}

/// A fan where it lands on one plane.
struct LandedFan {
  std::vector<double> radius_m;  ///< signed distance from the axis, where each ray lands
  std::vector<double> weight;    ///< T b Δb between each ray and the next
};

/// Near the axis Φ turns within a cell: there cells are cut finer, to a quarter of the axis
/// distance.
int cuts(double r0, double r1) {
  constexpr double most = 16;
  const double nearest = r0 * r1 <= 0 ? 0 : std::min(std::abs(r0), std::abs(r1));
  return static_cast<int>(std::ceil(std::min(most, 1 + 4 * std::abs(r1 - r0) / (nearest + 1))));
}

LandedFan landed(const Fan& fan, double sun_distance_m, double depth_m) {
  const auto& b = fan.impact_parameter_m;
  const auto radius = [&](std::size_t i) {
    return landing_m(b[i], fan.bending_rad[i], sun_distance_m, depth_m);
  };
  LandedFan on_plane{{radius(0)}, {}};
  for (std::size_t i = 0; i + 1 < b.size(); ++i) {
    const double r0 = on_plane.radius_m.back(), r1 = radius(i + 1);
    const double weight = (b[i + 1] - b[i]) * logarithmic_mean(fan.transmittance[i] * b[i],
                                                               fan.transmittance[i + 1] * b[i + 1]);
    const int n = cuts(r0, r1);
    for (int k = 1; k <= n; ++k) {
      on_plane.radius_m.push_back(std::lerp(r0, r1, static_cast<double>(k) / n));
      on_plane.weight.push_back(weight / n);
    }
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
    if (whole != 0) sum += fan.weight[i] * std::max(0., (above - below) / whole);  // rounding
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
