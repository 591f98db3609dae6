// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <vector>

#include "almanac/sky.h"
#include "atmosphere/atmosphere.h"

namespace coppermoon::uses {

/// Reduces the air's cloud and aerosol by a common factor, or adds aerosol to the stratosphere.
///
/// Given     clearness  1 removes all cloud and aerosol, 0 leaves the air unchanged; if negative, its absolute value is
///                      added to the optical depth of the stratosphere
/// Returned  the air with the columns of all its belts changed
atmosphere::Atmosphere cleared(atmosphere::Atmosphere air, double clearness);

/// Lowest and highest clearness that DanjonScale finds, and its error. A result near a limit means failure.
inline constexpr double darkest_clearness = -2, brightest_clearness = 1,
                        clearness_error = 2. / 1024;

/// Clearness for each step L on Danjon's scale, for the eclipse nearest to a moment. In air that `cleared` has changed
/// by this clearness, the Moon at greatest eclipse has the visual magnitude that corresponds to L.
///
///     m = 4.2 − 3 L + (L/2)²
///
/// If the eclipse is not total, the Moon is placed just inside the umbra.
///
/// Accuracy  0.15 mag, because the Moon is treated as uniform, and its light is computed in ten bands at a few places
/// Source    H. C. Vital's correlation of observers' estimates (REA Brazil, 2004 to 2015); `cleared` defines clearness
class DanjonScale {
 public:
  /// Given  air  the air on the night of the eclipse, divided into belts of latitude
  DanjonScale(const atmosphere::Atmosphere& air, const almanac::SkyState& sky);

  /// Clearness (see `cleared`) for a step on Danjon's scale. Caching speeds up later calls without changing results.
  ///
  /// Given     l  step on Danjon's scale, 0 to 4
  /// Returned  clearness, −2 (darkest) to 1 (clearest); at either limit, the Moon may not reach the step's magnitude
  /// Throws    Error  when l is outside its range
  double clearness(int l);

 private:
  struct Known {
    double clearness, magnitude;
  };

  /// Adds a clearness, and the Moon's magnitude in air of this clearness, to `known`, which is sorted by clearness.
  void add(double clearness, std::vector<Known>& known);

  std::function<double(double clearness)> magnitude_;
  std::map<double, double> magnitudes_;  ///< keyed by clearness
};

}  // namespace coppermoon::uses
