// SPDX-License-Identifier: MIT
#include "photons/limb.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace coppermoon::photons {
namespace {

struct Deflection {
  double bending_rad, optical_depth, filter;
};

/// Straight lines between a fan's rays; nothing below its first and above its last.
std::optional<Deflection> between_rays(const Fan& fan, double impact_height_m) {
  const auto& heights = fan.impact_height_m;
  const auto above = std::upper_bound(heights.begin(), heights.end(), impact_height_m);
  if (above == heights.begin() || above == heights.end()) return std::nullopt;
  const auto i = static_cast<std::size_t>(above - heights.begin()) - 1;
  const double part = (impact_height_m - heights[i]) / (heights[i + 1] - heights[i]);
  return Deflection{std::lerp(fan.bending_rad[i], fan.bending_rad[i + 1], part),
                    std::lerp(fan.optical_depth[i], fan.optical_depth[i + 1], part), fan.filter[i]};
}

}  // namespace

WholeLimb::WholeLimb(const atmosphere::Atmosphere& atmosphere,
                     std::span<const atmosphere::Optics> optics, int rays)
    : atmosphere_(atmosphere),
      equator_m_(atmosphere::limb_at(atmosphere.earth, std::numbers::pi / 2).radius_m),
      pole_m_(atmosphere::limb_at(atmosphere.earth, 0).radius_m) {
  std::vector<const atmosphere::Column*> columns{&atmosphere.column};
  for (const auto& region : atmosphere.regions) columns.push_back(&region.column);
  const std::size_t ends = atmosphere.earth.sphere() ? 1 : 2;
  parts_.resize(columns.size() * ends);
  tbb::parallel_for(std::size_t{0}, parts_.size(), [&](std::size_t i) {
    const auto limb =
        atmosphere::limb_at(atmosphere.earth, i % ends == 0 ? std::numbers::pi / 2 : 0);
    const LimbTable table(*columns[i / ends], limb.curvature_radius_m, optics, rays);
    parts_[i].radius_m = limb.radius_m;
    for (const auto& o : optics) parts_[i].fans.push_back(table.fan(o));
  });
  constexpr double beside = 1e-9;
  for (const auto& region : atmosphere.regions)
    for (const auto angle : {region.from, region.to}) {
      const double at = algebra::in_radians(angle);
      if (column_index(at - beside) != column_index(at + beside)) borders_rad_.push_back(at);
    }
}

/// 0: the column outside all regions.
std::size_t WholeLimb::column_index(double position_angle_rad) const {
  const auto* column = &atmosphere_.column_at(position_angle_rad);
  for (std::size_t r = 0; r < atmosphere_.regions.size(); ++r)
    if (column == &atmosphere_.regions[r].column) return r + 1;
  return 0;
}

std::array<WholeLimb::Share, 2> WholeLimb::at(double position_angle_rad) const {
  const std::size_t column = column_index(position_angle_rad);
  if (atmosphere_.earth.sphere()) return {{{column, 1}, {column, 0}}};
  const double radius = atmosphere::limb_at(atmosphere_.earth, position_angle_rad).radius_m;
  const double pole = (radius - equator_m_) / (pole_m_ - equator_m_);
  return {{{2 * column, 1 - pole}, {2 * column + 1, pole}}};
}

std::optional<Traced> WholeLimb::passed(const Ray& ray, std::size_t wavelength) const {
  const glm::dvec3 nearest =
      ray.position_m - glm::dot(ray.position_m, ray.direction) * ray.direction;
  const double b = glm::length(nearest), angle = std::atan2(nearest.x, nearest.y);
  const double height = b - atmosphere::limb_at(atmosphere_.earth, angle).radius_m;
  Deflection sum{0, 0, 0};
  for (const auto& [part, share] : at(angle)) {
    if (share == 0) continue;
    const auto one = between_rays(parts_[part].fans[wavelength], height);
    if (!one) return std::nullopt;
    sum.bending_rad += share * one->bending_rad;
    sum.optical_depth += share * one->optical_depth;
    sum.filter += share * one->filter;
  }
  const double sine = std::sin(sum.bending_rad), cosine = std::cos(sum.bending_rad);
  const glm::dvec3 up = nearest / b;
  return Traced{{b * (cosine * up + sine * ray.direction), cosine * ray.direction - sine * up},
                std::exp(-sum.optical_depth) * sum.filter,
                0};
}

}  // namespace coppermoon::photons
