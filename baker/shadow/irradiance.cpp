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

RefractedLight darkness(const Arrangement& arrangement, std::span<const double> wavelengths_nm,
                        std::span<const double> axis_distances_m, std::size_t sectors) {
  RefractedLight light{arrangement,
                       {wavelengths_nm.begin(), wavelengths_nm.end()},
                       {axis_distances_m.begin(), axis_distances_m.end()},
                       sectors,
                       {},
                       {}};
  for (std::size_t g = 0; g < arrangement.depths_m.size() * sectors; ++g)
    light.ratio.emplace_back(axis_distances_m.size(), wavelengths_nm.size());
  return light;
}

algebra::Grid<double> mean_ratio(const RefractedLight& light, std::size_t plane) {
  algebra::Grid<double> mean(light.axis_distances_m.size(), light.wavelengths_nm.size());
  for (std::size_t s = 0; s < light.sectors; ++s) {
    const auto sector = light.ratio[plane * light.sectors + s].values();
    for (std::size_t i = 0; i < sector.size(); ++i)
      mean.values()[i] += sector[i] / static_cast<double>(light.sectors);
  }
  return mean;
}

double combined_error(const RefractedLight& light, std::span<const double> errors,
                      std::span<const double> weights) {
  double sum = 0, variance = 0;
  for (std::size_t w = 0; w < weights.size(); ++w) {
    const double error = std::abs(weights[w]) * errors[w];
    sum += error;
    variance += error * error;
  }
  return light.errors_correlated ? sum : std::sqrt(variance);
}

std::vector<atmosphere::Optics> optics_of(const atmosphere::Atmosphere& atmosphere,
                                          std::span<const double> wavelengths_nm) {
  std::vector<atmosphere::Optics> optics;
  for (const double nm : wavelengths_nm)
    optics.push_back(atmosphere::sea_level_optics(algebra::nanometres(nm), atmosphere.molecules));
  return optics;
}

double lens_area(double apart, double r, double s) {
  const double smaller = std::min(r, s), larger = std::max(r, s);
  if (apart >= r + s) return 0;
  if (apart <= larger - smaller) return std::numbers::pi * smaller * smaller;
  const auto cosine = [](double x) { return std::clamp(x, -1., 1.); };  // allows for rounding
  // cosine of half the angle that the common chord subtends at each centre
  const double cos_r = cosine((apart * apart + r * r - s * s) / (2 * apart * r));
  const double cos_s = cosine((apart * apart + s * s - r * r) / (2 * apart * s));
  const auto segment = [](double c) { return std::acos(c) - c * std::sqrt(1 - c * c); };
  // FAULT angles of a lens exchanged: r * r * segment(cos_r) + s * s => s * s * segment(cos_r) + r * r
  return r * r * segment(cos_r) + s * s * segment(cos_s);
}

double projected_solar_radius_m(const Arrangement& arrangement, double depth_m) {
  return photons::solar_radius_m * depth_m / arrangement.sun_distance_m;
}

double landing_m(double impact_parameter_m, double bending_rad, double sun_distance_m,
                 double depth_m) {
  const double slope = std::tan(std::asin(impact_parameter_m / sun_distance_m) - bending_rad);
  // FAULT b cos ε for b / cos ε: 1 + slope * slope => 1 - slope * slope
  return impact_parameter_m * std::sqrt(1 + slope * slope) + depth_m * slope;
}

double refracted_reach_m(const Arrangement& arrangement, const atmosphere::Atmosphere& atmosphere,
                         double depth_m) {
  return landing_m(atmosphere.top_radius_m(), 0, arrangement.sun_distance_m, depth_m) +
         projected_solar_radius_m(arrangement, depth_m);
}

double covered_part(double axis_distance_m, double depth_m, double sun_distance_m,
                    double opaque_radius_m) {
  const double sun = photons::solar_radius_m * depth_m / sun_distance_m;
  const double earth = landing_m(opaque_radius_m, 0, sun_distance_m, depth_m);
  return lens_area(axis_distance_m, sun, earth) / (std::numbers::pi * sun * sun);
}

DirectLight::DirectLight(const atmosphere::Atmosphere& atmosphere, const Arrangement& arrangement,
                         std::span<const double> wavelengths_nm)
    : atmosphere_(atmosphere),
      arrangement_(arrangement),
      sun_(photons::disc_layers(wavelengths_nm, arrangement.limb_darkening)) {}

void DirectLight::clear_parts(double axis_distance_m, double position_angle_rad, double depth_m,
                              std::span<double> parts) const {
  const double opaque =
      atmosphere::limb_at(atmosphere_.earth, position_angle_rad).radius_m + atmosphere_.top_m();
  const double sun = projected_solar_radius_m(arrangement_, depth_m),
               earth = landing_m(opaque, 0, arrangement_.sun_distance_m, depth_m);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const double radius = sun_.radius[k], area = radius * radius;
    const double covered =
        lens_area(axis_distance_m, sun * radius, earth) / (std::numbers::pi * sun * sun);
    parts[k] = area - covered < 1e-12 ? 0 : area - covered;  // rounding errors count as 0
    if (parts[0] > 0) continue;
    std::ranges::fill(parts, 0);  // the whole disc is covered
    return;
  }
}

algebra::Grid<double> DirectLight::in_layers(const algebra::Grid<double>& weights) const {
  algebra::Grid<double> layers(weights.rows(), sun_.radius.size());
  for (std::size_t c = 0; c < weights.rows(); ++c)
    for (std::size_t k = 0; k < sun_.radius.size(); ++k)
      for (std::size_t w = 0; w < weights.columns(); ++w)
        layers(c, k) += weights(c, w) * sun_.brightness(k, w);
  return layers;
}

void DirectLight::ratios(double axis_distance_m, double position_angle_rad, double depth_m,
                         std::span<double> values) const {
  std::vector<double> parts(sun_.radius.size());
  clear_parts(axis_distance_m, position_angle_rad, depth_m, parts);
  for (std::size_t w = 0; w < values.size(); ++w) {
    double sum = 0;
    for (std::size_t k = 0; k < parts.size(); ++k) sum += sun_.brightness(k, w) * parts[k];
    values[w] = std::min(sum, 1.);  // rounding may make the sum exceed 1
  }
}

double DirectLight::penumbra_m(double depth_m) const {
  return refracted_reach_m(arrangement_, atmosphere_, depth_m);
}

}  // namespace coppermoon::shadow
