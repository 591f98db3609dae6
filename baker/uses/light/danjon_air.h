// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <vector>

#include "almanac/sky.h"
#include "atmosphere/atmosphere.h"

namespace coppermoon::uses {

/// Air whose cloud and aerosol are scaled by one number, or increased in the stratosphere.
///
/// Given     clearness  1: no cloud, no aerosol; 0: the air unchanged; below 0: its amount is added to the optical
///                      depth of the stratosphere
/// Returned  air of belts, with all its columns changed
atmosphere::Atmosphere cleared(atmosphere::Atmosphere air, double clearness);

/// Interval in which clearness is searched for, and distance from its ends within which the search has failed.
inline constexpr double darkest_clearness = -2, brightest_clearness = 1,
                        clearness_error = 2. / 1024;

/// Clearness for each step L of Danjon's scale, of the eclipse nearest to a moment: at its greatest phase the Moon has
/// the visual magnitude that goes with L.
///
///     m = 4.2 − 3 L + (L/2)²
///
/// In an eclipse that is not total, the Moon is placed just inside the umbra.
///
/// Accuracy  0.15 mag: the Moon is taken as even, its light by ten bands at a few places
/// Source    H. C. Vital's correlation of observers' estimates (REA Brazil, 2004 to 2015); what the
///           air is cleared of is ours
class DanjonScale {
 public:
  /// Given  air  of belts, of that night
  DanjonScale(const atmosphere::Atmosphere& air, const almanac::SkyState& sky);

  /// Clearness for a step. Magnitudes that are found on the way are kept for other steps, which do not change the
  /// result.
  ///
  /// Given     l  0 to 4
  /// Returned  −2 to 1; at these ends the magnitude may be another
  /// Throws    Error  when l is outside its range
  double clearness(int l);

 private:
  struct Known {
    double clearness, magnitude;
  };

  /// Adds a clearness and its magnitude to those known, in order of clearness; magnitudes fall.
  void add(double clearness, std::vector<Known>& known);

  std::function<double(double clearness)> magnitude_;
  std::map<double, double> magnitudes_;  ///< by clearness
};

}  // namespace coppermoon::uses
