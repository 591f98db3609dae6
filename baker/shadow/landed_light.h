// SPDX-License-Identifier: MIT
#pragma once

#include <tbb/scalable_allocator.h>

#include <array>
#include <span>
#include <vector>

#include "photons/limb.h"

namespace coppermoon::shadow {

/// Number of moments of the landing distance that are summed: its powers 0, 1 and 2.
inline constexpr std::size_t moments = 3;

/// Wavelengths whose sums stand side by side: a block of them.
inline constexpr std::size_t lanes = 8;

/// A plane that light lands on.
struct LandingPlane {
  double sun_distance_m, depth_m;
  double bin_m;    ///< width of the bins that light is gathered in, of distance from the axis
  double reach_m;  ///< distance from the axis beyond which light, on its own side, is left out

  /// First bin that nothing is gathered in, of light that lands up to so many bins from the axis.
  int end_of(double farthest) const;
};

/// ∫ r^m T b db over the rays of one part of the limb that land nearer than each of evenly spaced
/// signed distances r from the axis, on one plane, of a block of wavelengths; r in bins.
///
/// Between two rays r is taken to run straight and T exponentially, once from each to the next and
/// once to the next but one; 4/3 of the first less 1/3 of the second leaves errors of the fourth
/// order in the rays' spacing (Richardson).
class LandedLight {
 public:
  /// Given  fans      of the block's wavelengths, as many as `lanes` at most
  ///        radius_m  of the limb's ground
  LandedLight(std::span<const photons::Fan> fans, const LandingPlane& plane, double radius_m);

  /// First and last node: no light lands before the first, none that counts after the last.
  int first() const { return first_; }
  int last() const { return last_; }

  /// The sums up to the first node, [moment][lane]; behind them those up to the next.
  const double* sums() const { return sums_.data(); }

 private:
  int first_ = 0, last_ = 0;
  // [node][moment][lane]; the allocator keeps memory, for the next light asks for as much
  std::vector<double, tbb::scalable_allocator<double>> sums_;
};

}  // namespace coppermoon::shadow
