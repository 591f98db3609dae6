// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "algebra/grid.h"
#include "atmosphere/atmosphere.h"
#include "photons/bending.h"

namespace coppermoon::shadow {

/// Amounts of absorbers along straight lines through a column of air, from a point on the line outwards, tabulated
/// by the line's lowest altitude and the point's distance from the lowest point.
class Slants {
 public:
  /// Given  radius_m  radius of the ground
  Slants(const atmosphere::Column& column, const photons::ProfileTable& profiles, double radius_m);

  /// Amounts of absorbers along a line, from a point on it outwards.
  ///
  /// Given  lowest_m  lowest altitude of the line; below 0, the table's values at 0 are used
  ///        along_m   distance of the point from the lowest point, 0 or more
  atmosphere::Amounts beyond(double lowest_m, double along_m) const;

  /// Amounts of absorbers along a whole line up to a point on it.
  ///
  /// Given  along_m  distance of the point from the lowest point; negative before the lowest point
  atmosphere::Amounts up_to(double lowest_m, double along_m) const;

 private:
  atmosphere::Amounts between(const photons::ProfileTable& profiles, double radius_m, std::size_t i,
                              std::size_t j) const;

  double top_m_;
  algebra::Grid<atmosphere::Amounts> outwards_;  // (line, place on the line)
};

/// Quadrature point on a line of sight past the limb, with quantities that are the same for all position angles and all
/// places in the shadow.
struct SightPoint {
  double impact_m, along_m;  ///< along_m is measured from the lowest point towards the shadow
  double altitude_m;
  double lowest_m;              ///< lowest altitude between the point and the shadow
  atmosphere::Amounts profile;  ///< profiles of absorbers at the point, times weight b db ds
  atmosphere::Amounts onward;   ///< amounts of absorbers from the point to the shadow
};

/// Quadrature points on lines of sight at all heights, denser where the column's profiles change.
std::vector<SightPoint> points_on_sights(const atmosphere::Column& column, const Slants& slants,
                                         double radius_m);

}  // namespace coppermoon::shadow
