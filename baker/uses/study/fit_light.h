// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "algebra/grid.h"
#include "almanac/sky.h"
#include "eclipse/shadow_axis.h"
#include "uses/light/moonlight.h"

namespace coppermoon::uses {

/// A place of an eclipsed Moon, its light without the shadow, and the bin that it counts to.
struct LitPlace {
  eclipse::ShadowPlace place;
  double sunlit;  ///< light without the shadow, in any unit
  std::size_t bin;
};

/// Limits within which an unknown is sought.
struct SearchRange {
  double least, most;
};

/// Ranges of the three unknowns that an eclipse is explained by: dust [1/m], cover by a deck of cloud (in
/// place of cloud by chance), ozone [DU] (of belts their mean; they keep their shares).
constexpr std::array<SearchRange, 3> search_range{{{2e-7, 3e-5}, {0, 1}, {100, 500}}};

/// Light on bins of a Moon, under air of any dust, cloud and ozone.
///
/// It is computed for some dust and ozone, without cloud and under cloud all around; between those
/// the logarithm runs along cubics and parabolas, and cloud that covers a part of the limb takes that part
/// of the one for the other.
///
/// Accuracy  of X and Y 0.4 %, of Z 0.8 %, against light_on_the_moon of a tolerance of 0.1 %
class FittedLight {
 public:
  /// Given  request  air but for the unknowns, limb darkening, scattered light; nothing else counts
  ///        weights  (channel, band), of the moonlight seen, none below 0, as those of XYZ
  ///        places   in bins 0 to bins − 1
  FittedLight(const LightRequest& request, const almanac::SkyState& sky,
              const algebra::Grid<double>& weights, std::span<const LitPlace> places,
              std::size_t bins);

  /// Light of each bin over what it would be without the shadow.
  ///
  /// Returned  (bin, channel)
  algebra::Grid<double> at(double dust_per_m, double cloud_cover, double ozone_du) const;

  /// Light of each bin under a limb without cloud, and under one that is all cloud: each as above.
  struct Mixed {
    algebra::Grid<double> clear, cloudy;
  };
  Mixed mixed(double dust_per_m, double ozone_du) const;

 private:
  std::vector<Mixed> nodes_;  // logarithms, [dust × ozones + ozone]
};

}  // namespace coppermoon::uses
