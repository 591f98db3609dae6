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

/// A place of an eclipsed Moon, its sunlit light, and its bin.
struct LitPlace {
  eclipse::ShadowPlace place;
  double sunlit;  ///< light without the shadow, in any unit
  std::size_t bin;
  double colour = 0;  ///< c of the ground, as surface::Ground has it
};

/// Range of an unknown.
struct SearchRange {
  double least, most;
};

/// Ranges of the three unknowns: dust [1/m], cover by a deck of cloud (in place of cloud by chance), ozone [DU]
/// (uniform over the limb).
constexpr std::array<SearchRange, 3> search_range{{{2e-7, 3e-5}, {0, 1}, {100, 500}}};

/// Bins of the Moon's ground at one moment, as one observer sees them.
struct LitBins {
  /// (channel, band): of the moonlight of mean ground as seen, 0 or more, as those of XYZ
  algebra::Grid<double> weights;
  std::vector<LitPlace> places;  ///< in bins 0 to bins − 1
  std::size_t bins = 0;
};

/// Nodes of air at which light is computed: fine for fits; coarse (four of dust, one of ozone, no scattered light) for
/// finding a clock's error.
enum class FittedAirs { fine, coarse };

/// Light in bins of a Moon on its way through the shadow, in air of any dust, cloud and ozone.
///
/// Light in the shadow is computed once for all moments. Between different air above the observer its logarithm is
/// interpolated by a polynomial through up to four of them.
///
/// Nodes are some dust and ozone, with a clear and with a cloudy limb. Between nodes the logarithm of light is
/// interpolated by cubics in dust and parabolas in ozone. Partial cloud cover mixes clear and cloudy light linearly.
///
/// Accuracy  of X and Y 0.4 %, of Z 0.8 %, against light_on_the_moon of a tolerance of 0.1 %; more where
///           dust is above 8e-6 per metre: 2 % of the darkest places beyond 1.5e-5
class FittedLight {
 public:
  /// Given  request  air but for the unknowns, limb darkening, scattered light; the rest is ignored
  ///        skies    of one eclipse, in order of time: those of all parts, one or more
  ///        parts    of equal numbers of channels
  FittedLight(const LightRequest& request, std::span<const almanac::SkyState> skies,
              std::span<const LitBins> parts, FittedAirs airs = FittedAirs::fine,
              const algebra::Progress& progress = {});

  /// Light of each bin over its sunlit light.
  ///
  /// Returned  (bin, channel); bins of all parts, in their order
  algebra::Grid<double> at(double dust_per_m, double cloud_cover, double ozone_du) const;

  /// Light of each bin with a clear and with a cloudy limb: (bin, channel).
  struct Mixed {
    algebra::Grid<double> clear, cloudy;

    /// Light where cloud covers a part of the limb.
    algebra::Grid<double> under(double cloud_cover) const;
  };
  /// Light at some dust and ozone, to be mixed by cloud cover.
  Mixed mixed(double dust_per_m, double ozone_du) const;

 private:
  /// Nodes of one ozone.
  struct InOzone {
    double ozone_du;
    std::vector<double> dusts_per_m;
    std::vector<Mixed> logarithms;  ///< [dust]
  };

  static std::vector<InOzone> nodes_of(FittedAirs airs);

  std::vector<InOzone> nodes_;  // after the first: light over that of the first
};

}  // namespace coppermoon::uses
