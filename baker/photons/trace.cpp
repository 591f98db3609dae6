// SPDX-License-Identifier: MIT
#include "photons/trace.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "algebra/error.h"

namespace coppermoon::photons {
namespace {

using atmosphere::Atmosphere;
using atmosphere::Column;
using atmosphere::Optics;

/// Finds the column of air above a point. Between two belts of air, a photon is assigned to one of them at random.
class Overhead {
 public:
  Overhead(const Atmosphere& atmosphere, double chance)
      : atmosphere_(atmosphere), columns_(atmosphere.columns()), chance_(chance) {}

  const Column& operator()(const glm::dvec3& at_m) const {
    if (columns_.size() == 1) return *columns_.front();
    const auto [one, other] = atmosphere_.shares_at(std::atan2(at_m.x, at_m.y));
    return *columns_[chance_ < one.share ? one.column : other.column];
  }

 private:
  const Atmosphere& atmosphere_;
  std::vector<const Column*> columns_;
  double chance_;
};

/// The column of air at a ray's current point, and its spectra.
struct Standing {
  const Column* column;
  atmosphere::Amounts spectra;

  Standing(const Column& over, const Optics& optics)
      : column(&over), spectra(atmosphere::spectra(over, optics)) {}
};

/// The medium that refracts a ray: one column of air around the whole Earth, at one wavelength.
struct Medium {
  const Column& column;
  const Optics& optics;
  const atmosphere::Figure& earth;

  double refractivity_at(const glm::dvec3& at_m) const {
    return refractivity(column, optics, altitude_m(earth, at_m));
  }

  /// Gradient of refractivity by forward differences [1/m].
  ///
  /// Given  here  refractivity at the point itself
  glm::dvec3 gradient(const glm::dvec3& at_m, double here, double step_m) const {
    glm::dvec3 gradient;
    for (int j = 0; j < 3; ++j) {
      glm::dvec3 beside = at_m;
      beside[j] += step_m;
      gradient[j] = (refractivity_at(beside) - here) / step_m;
    }
    return gradient;
  }
};

void require_valid(const Stepping& stepping, const Atmosphere& atmosphere, const Optics& optics) {
  algebra::require_within("step [m]", stepping.step_m, 1, 1e5);
  algebra::require_within("step of the gradient [m]", stepping.gradient_step_m, 1e-3, 1e4);
  const auto& earth = atmosphere.earth;
  const double radius_m = std::max(earth.equatorial_radius_m, earth.polar_radius_m);
  for (const auto* column : atmosphere.columns())
    atmosphere::require_no_trap(*column, radius_m, optics.refractivity);
}

}  // namespace

std::optional<Ray> entered(const Ray& ray, double radius_m) {
  const double along = -glm::dot(ray.position_m, ray.direction);
  const glm::dvec3 nearest = ray.position_m + along * ray.direction;
  const double half_chord_squared = radius_m * radius_m - glm::dot(nearest, nearest);
  if (along < 0 || half_chord_squared <= 0) return std::nullopt;
  return Ray{nearest - std::sqrt(half_chord_squared) * ray.direction, ray.direction};
}

std::optional<Traced> trace(const Ray& entering, const Atmosphere& atmosphere, const Optics& optics,
                            const Stepping& stepping, double chance) {
  require_valid(stepping, atmosphere, optics);
  const double length = stepping.step_m, top = atmosphere.top_m();
  const auto& earth = atmosphere.earth;
  glm::dvec3 at = entering.position_m, direction = entering.direction;
  const Overhead column_over(atmosphere, chance);
  Standing standing(column_over(at), optics);
  const Column* at_lowest = standing.column;
  double optical_depth = 0, altitude = altitude_m(earth, at), lowest = altitude;
  int steps = 0;
  for (; altitude <= top || glm::dot(at, direction) < 0; altitude = altitude_m(earth, at)) {
    if (altitude < 0) return std::nullopt;
    if (const Column& over = column_over(at); &over != standing.column)
      standing = Standing(over, optics);
    const Column& column = *standing.column;
    if (altitude < lowest) lowest = altitude, at_lowest = &column;
    const Medium medium{column, optics, earth};
    const double here = refractivity(column, optics, altitude);
    optical_depth += atmosphere::product(profiles(column, altitude), standing.spectra) * length;
    const glm::dvec3 momentum =
        (1 + here) * direction + length * medium.gradient(at, here, stepping.gradient_step_m);
    at += length * direction;
    const double there = medium.refractivity_at(at);
    direction = momentum / (1 + there);
    ++steps;
  }
  if (lowest > top) return std::nullopt;
  return Traced{{at, glm::normalize(direction)},
                std::exp(-optical_depth) * limb_filter(*at_lowest, optics, lowest),
                steps};
}

}  // namespace coppermoon::photons
