// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "photons/limb.h"

namespace coppermoon::shadow {

/// Number of moments of the landing distance that are summed: its powers 0, 1 and 2.
inline constexpr std::size_t moments = 3;

/// Wavelengths whose sums stand side by side.
inline constexpr std::size_t lanes = 8;

/// A node between two bins, by its place in a list of nodes, and the factor of each moment's sum up to it.
struct NodeTerm {
  std::int32_t node;
  std::array<double, moments> factors;
};

/// ∫ r^m T b db over the rays of one part of the limb that land nearer than each of evenly spaced
/// signed distances r from the axis, on one plane, by wavelength; r in bins.
///
/// Between two rays r is taken to run straight and T exponentially, once from each to the next and
/// once to the next but one; 4/3 of the first less 1/3 of the second leaves errors of the fourth
/// order in the rays' spacing (Richardson).
class LandedLight {
 public:
  LandedLight(const photons::WholeLimb::Part& limb, double sun_distance_m, double depth_m,
              double bin_m);

  /// Adds a part of one block's sums up to some nodes.
  ///
  /// Given  nodes  those below first() count as there, above last() as there
  ///        sums   [place in `nodes`][moment][lane]
  void add(std::span<const int> nodes, std::size_t block, double part, std::span<double> sums) const;

  /// Up to the first node no light lands, up to the last all does.
  int first() const { return first_; }
  int last() const { return last_; }

 private:
  int first_ = 0, last_ = 0;
  std::vector<double> sums_;  // [block][node][moment][lane]
};

}  // namespace coppermoon::shadow
