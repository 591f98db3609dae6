// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "algebra/grid.h"
#include "atmosphere/atmosphere.h"
#include "photons/bending.h"

namespace coppermoon::shadow {

/// Amounts of what stands on straight lines through a column of air, from a place on the line
/// outwards: a table over the line's lowest altitude and the distance of the place from there.
class Slants {
 public:
  /// Given  radius_m  of the ground
  Slants(const atmosphere::Column& column, const photons::ProfileTable& profiles, double radius_m);

  /// Given  along_m  0 or more; a line below the ground is taken as one along it
  atmosphere::Amounts beyond(double lowest_m, double along_m) const;

  /// Amounts on the whole line up to a place.
  ///
  /// Given  along_m  below 0 where the line still sinks
  atmosphere::Amounts up_to(double lowest_m, double along_m) const;

 private:
  atmosphere::Amounts between(const photons::ProfileTable& profiles, double radius_m, std::size_t i,
                              std::size_t j) const;

  double top_m_;
  algebra::Grid<atmosphere::Amounts> outwards_;  // (line, place)
};

/// A point on a sight, a straight line past the limb, and all that does not depend on where it leads.
struct SightPoint {
  double impact_m, along_m;  ///< from the sight's lowest point, positive towards the shadow
  double altitude_m;
  double lowest_m;                      ///< from here on
  atmosphere::Amounts profile, onward;  ///< profile: times b db ds
};

/// Points on sights at all heights, closer where what air, cloud and dust there is changes.
std::vector<SightPoint> points_on_sights(const atmosphere::Column& column, const Slants& slants,
                                         double radius_m);

}  // namespace coppermoon::shadow
