// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <vector>

#include "almanac/sky.h"
#include "atmosphere/atmosphere.h"

namespace coppermoon::uses {

/// The given air with cloud and aerosol scaled by one number, or with more aerosol in the stratosphere.
///
/// Given     clearness  1: no cloud, no aerosol; 0: the air unchanged; below 0: its magnitude is added to the
///                      optical depth of the stratosphere
/// Returned  air in belts, with all its columns changed
atmosphere::Atmosphere cleared(atmosphere::Atmosphere air, double clearness);

/// Interval in which clearness is searched for. A search that ends within the error of either end has failed.
inline constexpr double darkest_clearness = -2, brightest_clearness = 1,
                        clearness_error = 2. / 1024;

/// Clearness for each step L on Danjon's scale, for the eclipse nearest to a moment. With this clearness, the Moon at
/// greatest eclipse has the visual magnitude that corresponds to L.
///
///     m = 4.2 − 3 L + (L/2)²
///
/// In an eclipse that is not total, the Moon is placed just inside the umbra.
///
/// Accuracy  0.15 mag: the Moon is taken to be uniform, and its light is computed in ten bands at a few places
/// Source    H. C. Vital's correlation of observers' estimates (REA Brazil, 2004 to 2015); the
///           choice of what to clear from the air is ours
class DanjonScale {
 public:
  /// Given  air  divided into belts of latitude, for the night of the eclipse
  DanjonScale(const atmosphere::Atmosphere& air, const almanac::SkyState& sky);

  /// Clearness for a step. Magnitudes found on the way are kept to speed up other steps, without changing results.
  ///
  /// Given     l  0 to 4
  /// Returned  −2 to 1; at either end the magnitude may not be reached
  /// Throws    Error  when l is outside its range
  double clearness(int l);

 private:
  struct Known {
    double clearness, magnitude;
  };

  /// Adds a clearness and its magnitude to the known ones, in order of clearness, so that magnitudes decrease.
  void add(double clearness, std::vector<Known>& known);

  std::function<double(double clearness)> magnitude_;
  std::map<double, double> magnitudes_;  ///< by clearness
};

}  // namespace coppermoon::uses
