// SPDX-License-Identifier: MIT
// How far each way through the air may be pushed: relative errors of bending, optical depth and of
// the light on the axis by the length of the step; and those of rays that graze all but a singular
// place, by their distance from it. As a table: panel, line, x, error.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "photons/bending.h"
#include "photons/trace.h"
#include "shadow/by_quadrature.h"

using namespace coppermoon;

namespace {

const atmosphere::Atmosphere air;  // the paper's, without dust
const double radius_m = air.earth.equatorial_radius_m;
const auto green = atmosphere::sea_level_optics(algebra::nanometres(550));
const shadow::Arrangement february_2008{1.479e11, {3.83e8}};

struct Ray {
  double bending_rad, depth;
};
using Rays = std::vector<Ray>;
using Heights = std::vector<double>;

void print(std::string_view panel, std::string_view line, double x, double error) {
  constexpr double rounding = 1e-16;
  fmt::print("{},{},{:.4g},{:.4g}\n", panel, line, x, std::max(error, rounding));
}

Ray ray_of(const photons::LimbPath& path) {
  return {path.bending_rad,
          atmosphere::product(path.amounts, atmosphere::spectra(air.column, green))};
}

photons::LimbPath exact_path(double h) {
  return photons::limb_path(h, radius_m, air.column, green.refractivity);
}

Rays exact(const Heights& heights) {
  Rays rays;
  for (const double h : heights) rays.push_back(ray_of(exact_path(h)));
  return rays;
}

/// Stepped to the letter; a ray that the ground took brings nothing.
Rays stepped(const Heights& heights, const photons::Stepping& stepping) {
  Rays rays;
  for (const double h : heights) {
    const photons::Ray far{{radius_m + exact_path(h).impact_height_m, 0, -1e8}, {0, 0, 1}};
    const auto out = trace(*photons::entered(far, air.top_radius_m()), air, green, stepping);
    rays.push_back(out ? Ray{std::atan2(-out->leaving.direction.x, out->leaving.direction.z),
                             -std::log(out->transmittance)}
                       : Ray{0, 1e3});
  }
  return rays;
}

double worst(const Rays& rays, const Rays& reference, double Ray::*what) {
  double error = 0;
  for (std::size_t i = 0; i < rays.size(); ++i)
    error = std::max(error, std::abs(rays[i].*what / reference[i].*what - 1));
  return error;
}

/// ∫ T b db over the rays that land on the Sun's disc about the axis: light there, but for a factor.
double on_the_axis(const Heights& heights, const Rays& rays) {
  const double z = february_2008.depths_m[0], sun_m = february_2008.sun_distance_m,
               a = shadow::projected_solar_radius_m(february_2008, z);
  const auto b = [&](std::size_t i) { return radius_m + exact_path(heights[i]).impact_height_m; };
  const auto r = [&](std::size_t i) {
    return std::abs(shadow::landing_m(b(i), rays[i].bending_rad, sun_m, z));
  };
  double sum = 0;
  for (std::size_t i = 0; i + 1 < rays.size(); ++i) {
    const auto [near, far] = std::minmax({r(i), r(i + 1)});
    const double inside = far > near ? std::clamp((a - near) / (far - near), 0., 1.) : near < a;
    sum += inside * (b(i + 1) - b(i)) * b(i) *
           (std::exp(-rays[i].depth) + std::exp(-rays[i + 1].depth)) / 2;
  }
  return sum;
}

Heights even(double from_m, double to_m, int count) {
  Heights heights;
  for (int i = 0; i < count; ++i) heights.push_back(from_m + (to_m - from_m) * i / (count - 1));
  return heights;
}

struct Way {
  std::string_view name;
  Rays (*rays)(const Heights&, double step_m);
};

constexpr std::array<Way, 2> ways{
    {{"literal", [](const Heights& h, double step_m) { return stepped(h, {step_m}); }},
     {"literal with gradients over 0.1 m", [](const Heights& h, double step_m) {
        return stepped(h, {step_m, 0.1});
      }}}};

void print_steps(const std::vector<double>& steps_m) {
  const auto few = even(1e3, 36e3, 8), many = even(0, 42e3, 400);
  const auto few_exact = exact(few), many_exact = exact(many);
  for (const auto& way : ways)
    for (const double step_m : steps_m) {
      const auto rays = way.rays(few, step_m);
      print("bending", way.name, step_m, worst(rays, few_exact, &Ray::bending_rad));
      print("optical depth", way.name, step_m, worst(rays, few_exact, &Ray::depth));
      constexpr double shortest_m = 30;  // for many rays
      if (step_m < shortest_m) continue;
      const double light = on_the_axis(many, way.rays(many, step_m));
      print("light on the axis", way.name, step_m,
            std::abs(light / on_the_axis(many, many_exact) - 1));
    }
}

/// Bending by midpoints over √(h − h_t), layer by layer, crowded at the lower end of each.
double by_midpoints(double tangent_m) {
  constexpr int points = 20'000;
  const auto excess = [&](double h) {
    return green.refractivity * atmosphere::density_ratio(air.column, h).value * (radius_m + h);
  };
  const double at_tangent = excess(tangent_m), b = radius_m + tangent_m + at_tangent;
  double bending = 0, from_m = tangent_m, over_from = 0;
  for (const double to_m : atmosphere::breaks_m(air.column)) {
    if (to_m <= from_m) continue;
    const double u0 = std::sqrt(from_m - tangent_m), width = std::sqrt(to_m - tangent_m) - u0;
    double slope = 0;  // of n r
    for (int i = 0; i < points; ++i) {
      const double t = (i + 0.5) / points, u = u0 + width * t * t, h = tangent_m + u * u;
      const auto density = atmosphere::density_ratio(air.column, h);
      slope = 1 + green.refractivity * (density.value + density.slope_per_m * (radius_m + h));
      const double over_b =
          u * u > 1e-3 ? u * u + (excess(h) - at_tangent) : over_from + (u * u - u0 * u0) * slope;
      bending -= 8 * b * u * width * t / points * green.refractivity * density.slope_per_m /
                 ((1 + green.refractivity * density.value) * std::sqrt(over_b * (2 * b + over_b)));
    }
    over_from += (to_m - from_m) * slope;
    from_m = to_m;
  }
  return bending;
}

struct Place {
  std::string_view name;
  double height_m, side;  ///< which way rays stand off it
};

/// Rays by limb_path's integral.
void print_places(double away_m) {
  const auto breaks = atmosphere::density_breaks_m();
  for (const auto& [name, at_m, side] :
       {Place{"over the ground", 0, 1}, Place{"under the tropopause", breaks[0], -1},
        Place{"under a cloud deck", 10e3, -1}, Place{"under the taper corner", breaks[3], -1},
        Place{"under the top", breaks[4], -1}}) {
    const double h = at_m + side * away_m, reference = by_midpoints(h);
    print("exact", name, away_m, std::abs(exact({h})[0].bending_rad / reference - 1));
  }
}

/// Light beside the axis against that on it.
void print_axis(const std::vector<double>& away_m) {
  std::vector<double> gammas{0};
  gammas.insert(gammas.end(), away_m.begin(), away_m.end());
  const auto light = by_quadrature(air, february_2008, std::vector{550.}, gammas, {.rays = 1000});
  for (std::size_t i = 1; i < gammas.size(); ++i)
    print("exact", "light beside the axis", gammas[i],
          std::abs(light.ratio[0](i, 0) / light.ratio[0](0, 0) - 1));
}

std::vector<double> decades(double from, double to, double factor) {
  std::vector<double> all;
  for (double x = from; x < to * 1.01; x *= factor) all.push_back(x);
  return all;
}

}  // namespace

int main() {
  fmt::print("panel,line,metres,relative_error\n");
  print_steps(decades(1, 1e5, std::pow(10, 0.25)));
  const auto away_m = decades(1e-6, 1e3, std::sqrt(10));
  for (const double away : away_m) print_places(away);
  print_axis(away_m);
}
