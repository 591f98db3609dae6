// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "algebra/grid.h"
#include "algebra/progress.h"
#include "almanac/sky.h"
#include "eclipse/shadow_axis.h"
#include "uses/light/moonlight.h"

namespace coppermoon::uses {

/// A place of an eclipsed Moon, its light without the shadow, and the bin that it counts to.
struct LitPlace {
  eclipse::ShadowPlace place;
  double sunlit;  ///< light without the shadow, in any unit
  std::size_t bin;
  double colour = 0;  ///< c of the ground, as surface::Ground has it
};

/// Limits within which an unknown is sought.
struct SearchRange {
  double least, most;
};

/// Ranges of the three unknowns that an eclipse is explained by: dust [1/m], cover by a deck of cloud (in
/// place of cloud by chance), ozone [DU] (the same over all of the limb).
constexpr std::array<SearchRange, 3> search_range{{{2e-7, 3e-5}, {0, 1}, {100, 500}}};

/// Light that counts together: what one observer sees of the Moon at one moment.
struct LitBins {
  /// (channel, band), of the moonlight seen, of mean ground, none below 0, as those of XYZ
  algebra::Grid<double> weights;
  std::vector<LitPlace> places;  ///< in bins 0 to bins − 1
  std::size_t bins = 0;
};

/// How closely air is tried: fine as a fit is, coarse (dust in fours, one ozone, no scattered light) to find
/// out when a photograph was taken.
enum class FittedAirs { fine, coarse };

/// Light on bins of a Moon on its way, under air of any dust, cloud and ozone.
///
/// Light in the shadow is computed once for all moments; between different air above the observer the
/// logarithm runs along a polynomial of up to four of them.
///
/// It is computed for some dust and ozone, without cloud and under cloud all around; between those
/// the logarithm runs along cubics and parabolas, and cloud that covers a part of the limb takes that part
/// of the one for the other.
///
/// Accuracy  of X and Y 0.4 %, of Z 0.8 %, against light_on_the_moon of a tolerance of 0.1 %; more where
///           dust is above 8e-6 per metre: 2 % of the darkest places beyond 1.5e-5
class FittedLight {
 public:
  /// Given  request  air but for the unknowns, limb darkening, scattered light; nothing else counts
  ///        skies    of one eclipse, in order of time: all moments that parts are of, one or more
  ///        parts    of as many channels each
  FittedLight(const LightRequest& request, std::span<const almanac::SkyState> skies,
              std::span<const LitBins> parts, FittedAirs airs = FittedAirs::fine,
              const algebra::Progress& progress = {});

  /// Light of each bin over what it would be without the shadow.
  ///
  /// Returned  (bin, channel); bins of all parts, in their order
  algebra::Grid<double> at(double dust_per_m, double cloud_cover, double ozone_du) const;

  /// Light of each bin under a limb without cloud, and under one that is all cloud: each as above.
  struct Mixed {
    algebra::Grid<double> clear, cloudy;
  };
  Mixed mixed(double dust_per_m, double ozone_du) const;

 private:
  /// Light of one ozone, by dust.
  struct InOzone {
    double ozone_du;
    std::vector<double> dusts_per_m;
    std::vector<Mixed> logarithms;  ///< [dust]
  };

  static std::vector<InOzone> nodes_of(FittedAirs airs);

  std::vector<InOzone> nodes_;  // those after the first: light over that of the first
};

}  // namespace coppermoon::uses
