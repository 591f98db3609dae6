// SPDX-License-Identifier: MIT
#include "photons/limb.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace coppermoon::photons {
namespace {

constexpr double circle = 2 * std::numbers::pi;

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
    : atmosphere_(atmosphere) {
  const auto columns = atmosphere.columns();
  const std::size_t ends = atmosphere.earth.sphere() ? 1 : 2;
  parts_.resize(columns.size() * ends);
  tbb::parallel_for(std::size_t{0}, parts_.size(), [&](std::size_t i) {
    const auto limb =
        atmosphere::limb_at(atmosphere.earth, i % ends == 0 ? std::numbers::pi / 2 : 0);
    const LimbTable table(*columns[i / ends], limb.curvature_radius_m, optics, rays);
    parts_[i] = {limb.radius_m, {}, limb.curvature_radius_m, *columns[i / ends]};
    for (const auto& o : optics) parts_[i].fans.push_back(table.fan(o));
  });
  find_stretches();
}

void WholeLimb::find_stretches() {
  std::vector<double> borders{0, circle};
  for (const auto& region : atmosphere_.regions)
    for (const auto angle : {region.from, region.to})
      borders.push_back(algebra::in_radians(angle) -
                        circle * std::floor(algebra::in_radians(angle) / circle));
  std::sort(borders.begin(), borders.end());
  for (std::size_t i = 0; i + 1 < borders.size(); ++i)
    if (borders[i + 1] - borders[i] > 1e-12)
      stretches_.push_back({borders[i], borders[i + 1],
                            atmosphere_.column_index((borders[i] + borders[i + 1]) / 2)});
  for (std::size_t i = 0; i < stretches_.size(); ++i) {
    const auto& before = stretches_[i == 0 ? stretches_.size() - 1 : i - 1];
    if (before.column != stretches_[i].column) borders_rad_.push_back(stretches_[i].from_rad);
  }
}

void WholeLimb::arc(double middle_rad, double half_width_rad, std::span<double> lengths) const {
  std::fill(lengths.begin(), lengths.end(), 0);
  const double turn = circle * std::floor((middle_rad - half_width_rad) / circle);
  const double from = middle_rad - half_width_rad - turn, to = from + 2 * half_width_rad;
  for (const double round : {0., circle})
    for (const auto& stretch : stretches_) {
      const double low = std::max(from, stretch.from_rad + round),
                   high = std::min(to, stretch.to_rad + round);
      if (high <= low) continue;
      if (atmosphere_.earth.sphere()) {
        lengths[stretch.column] += high - low;
        continue;
      }
      const double pole = ((high - low) + (std::sin(2 * high) - std::sin(2 * low)) / 2) / 2;
      lengths[2 * stretch.column] += high - low - pole;
      lengths[2 * stretch.column + 1] += pole;
    }
}

std::array<WholeLimb::Share, 2> WholeLimb::at(double position_angle_rad) const {
  const std::size_t column = atmosphere_.column_index(position_angle_rad);
  if (atmosphere_.earth.sphere()) return {{{column, 1}, {column, 0}}};
  const double pole = std::cos(position_angle_rad) * std::cos(position_angle_rad);
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
