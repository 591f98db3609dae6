// SPDX-License-Identifier: MIT
#pragma once

#include <tbb/scalable_allocator.h>

#include <array>
#include <span>
#include <vector>

#include "photons/earth_limb.h"

namespace coppermoon::shadow {

/// Number of moments of the landing distance that are summed: powers 0, 1 and 2.
inline constexpr std::size_t moments = 3;

/// Number of wavelengths in a block. The sums for these wavelengths are stored side by side.
inline constexpr std::size_t lanes = 8;

/// Shadow plane on which light lands, and the bins of axis distance in which it is gathered.
struct LandingPlane {
  double sun_distance_m, depth_m;
  double bin_m;    ///< width of the bins of axis distance
  double reach_m;  ///< axis distance beyond which light that has not crossed the axis is left out

  /// One more than the index of the last bin needed for light that lands up to `farthest` bins from the axis.
  int end_of(double farthest) const;
};

/// Cumulative moments of landed light, ∫ r^m T b db, with the transmittance T, the impact parameter b, and the signed
/// axis distance r on one plane, in bin widths. There is one integral for each boundary between bins (node). It covers
/// those rays of one part of the limb that land at a smaller r than the node. One object holds a block of wavelengths.
///
/// Between rays, r is interpolated linearly and T exponentially, once with all rays and once with every other ray left
/// out. By Richardson extrapolation, 4/3 of the first result less 1/3 of the second leaves errors of fourth order in
/// the spacing of the rays.
class LandedLight {
 public:
  /// Given  fans      one for each of the block's wavelengths, at most `lanes`
  ///        radius_m  radius of the ground at the limb
  LandedLight(std::span<const photons::Fan> fans, const LandingPlane& plane, double radius_m);

  /// Index of the first and last bin boundary (node). No light lands before the first. Light after the last is omitted.
  int first() const { return first_; }
  int last() const { return last_; }

  /// The cumulative moments, indexed by [node − first()][moment][wavelength in the block].
  const double* sums() const { return sums_.data(); }

 private:
  int first_ = 0, last_ = 0;
  // [node][moment][lane]; the allocator keeps freed memory for the next LandedLight, which needs as much
  std::vector<double, tbb::scalable_allocator<double>> sums_;
};

}  // namespace coppermoon::shadow
