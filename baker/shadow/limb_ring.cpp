// SPDX-License-Identifier: MIT
#include "shadow/limb_ring.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "algebra/error.h"
#include "algebra/interpolation.h"
#include "photons/solar_disc.h"

namespace coppermoon::shadow {
namespace {

/// Refraction and extinction of a ray that passes the limb, at one wavelength.
struct Passage {
  double bending_rad = 0, optical_depth = 0, filter = 1;
};

/// Passage of a ray through one part of the limb. Returns nothing if the ray meets the ground.
std::optional<Passage> passage(const photons::Fan& fan, double impact_height_m) {
  const auto& heights = fan.impact_height_m;
  if (impact_height_m < heights.front()) return std::nullopt;
  if (impact_height_m >= heights.back()) return Passage{};
  const auto [below, above, along] = algebra::on_line(heights, impact_height_m);
  return Passage{std::lerp(fan.bending_rad[below], fan.bending_rad[above], along),
                 std::lerp(fan.optical_depth[below], fan.optical_depth[above], along),
                 fan.filter[below]};
}

/// Passage of a ray at a position angle: the weighted mean over the parts of the limb there.
std::optional<Passage> passage(const photons::WholeLimb& limb, double position_angle_rad,
                               std::size_t wave, double impact_height_m) {
  Passage mean{0, 0, 0};
  for (const auto& [part, share] : limb.at(position_angle_rad)) {
    if (share == 0) continue;
    const auto one = passage(limb.parts()[part].fans[wave], impact_height_m);
    if (!one) return std::nullopt;
    mean.bending_rad += share * one->bending_rad;
    mean.optical_depth += share * one->optical_depth;
    mean.filter += share * one->filter;
  }
  return mean;
}

glm::dvec3 position_of(const eclipse::ShadowPlace& place) {
  const double gamma = algebra::in_metres(place.axis_distance),
               theta = algebra::in_radians(place.position_angle);
  return {gamma * std::sin(theta), gamma * std::cos(theta), algebra::in_metres(place.depth)};
}

/// Unit vector in the direction of a position angle, perpendicular to the line from a place to the Earth's centre.
glm::dvec3 outward_at(const glm::dvec3& position_m, double position_angle_rad) {
  const auto ahead = -glm::normalize(position_m);
  const glm::dvec3 y(0, 1, 0);
  const auto north = glm::normalize(y - glm::dot(y, ahead) * ahead);
  return std::cos(position_angle_rad) * north +
         std::sin(position_angle_rad) * glm::cross(ahead, north);
}

const atmosphere::Atmosphere& checked(const atmosphere::Atmosphere& atmosphere,
                                      const Arrangement& arrangement,
                                      const eclipse::ShadowPlace& place, int rays) {
  require_valid(atmosphere);
  require_valid(Arrangement{arrangement.sun_distance_m, {algebra::in_metres(place.depth)}});
  algebra::require_within("rays", rays, 2, 1e7);
  if (atmosphere.top_m() <= 0) throw algebra::Error("air = none, allowed any: it makes the ring");
  return atmosphere;
}

}  // namespace

LimbRing::LimbRing(const atmosphere::Atmosphere& atmosphere, const Arrangement& arrangement,
                   const eclipse::ShadowPlace& place, std::span<const double> wavelengths_nm,
                   int rays)
    : earth_(checked(atmosphere, arrangement, place, rays).earth),
      arrangement_(arrangement),
      place_(place),
      wavelengths_nm_(wavelengths_nm.begin(), wavelengths_nm.end()),
      limb_(atmosphere, optics_of(atmosphere, wavelengths_nm), rays),
      position_m_(position_of(place)) {}

double LimbRing::distance_m() const { return glm::length(position_m_); }

double LimbRing::cosine_on_sun(const glm::dvec3& outward, double b, double bending_rad) const {
  // FAULT rays of the ring bent outwards: - bending_rad; => + bending_rad;
  const double slope = std::asin(b / distance_m()) - bending_rad;
  const auto ahead = -glm::normalize(position_m_);
  const auto direction = std::cos(slope) * ahead + std::sin(slope) * outward;
  const auto nearest_to_earth = b * (std::cos(slope) * outward - std::sin(slope) * ahead);
  const glm::dvec3 sun(0, 0, -arrangement_.sun_distance_m);
  const double beside =
      glm::length(glm::cross(sun - nearest_to_earth, direction)) / photons::solar_radius_m;
  return beside < 1 ? std::sqrt(1 - beside * beside) : -1;
}

void LimbRing::radiance(double position_angle_rad, double b, std::span<double> values) const {
  const auto outward = outward_at(position_m_, position_angle_rad);
  const double height = b - atmosphere::limb_at(earth_, position_angle_rad).radius_m;
  for (std::size_t w = 0; w < values.size(); ++w) {
    values[w] = 0;
    const auto passed = passage(limb_, position_angle_rad, w, height);
    if (!passed) continue;
    const double cosine = cosine_on_sun(outward, b, passed->bending_rad);
    if (cosine < 0) continue;
    values[w] = passed->filter * std::exp(-passed->optical_depth);
    if (arrangement_.limb_darkening)
      values[w] *= photons::limb_darkening(algebra::nanometres(wavelengths_nm_[w]), cosine);
  }
}

LimbRing::Extent LimbRing::extent() const {
  const double depth = algebra::in_metres(place_.depth);
  const double reach =
      algebra::in_metres(place_.axis_distance) + projected_solar_radius_m(arrangement_, depth);
  double lowest = std::numeric_limits<double>::infinity(), highest = 0;
  for (const auto& part : limb_.parts())
    for (const auto& fan : part.fans) {
      lowest = std::min(lowest, part.radius_m + fan.impact_height_m.front());
      for (std::size_t i = 0; i + 1 < fan.bending_rad.size(); ++i) {
        const double b = part.radius_m + fan.impact_height_m[i];
        if (std::abs(landing_m(b, fan.bending_rad[i], arrangement_.sun_distance_m, depth)) < reach)
          highest = std::max(highest, part.radius_m + fan.impact_height_m[i + 1]);
      }
    }
  return {lowest, std::max(lowest, highest)};
}

}  // namespace coppermoon::shadow
