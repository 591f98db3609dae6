// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "algebra/grid.h"
#include "algebra/progress.h"
#include "almanac/sky.h"
#include "eclipse/shadow_axis.h"
#include "uses/fit/unknowns.h"
#include "uses/light/moonlight.h"

namespace coppermoon::uses {

/// A place of an eclipsed Moon, its sunlit light, and its bin.
struct LitPlace {
  eclipse::ShadowPlace place;
  double sunlit;  ///< light without the shadow, in any unit
  std::size_t bin;
  double colour = 0;  ///< c of the ground, as surface::Ground has it
};

/// Bins of the Moon's ground at one moment, as one observer sees them.
struct LitBins {
  /// (channel, band): of the moonlight of mean ground as seen, 0 or more, as those of XYZ
  algebra::Grid<double> weights;
  std::vector<LitPlace> places;  ///< in bins 0 to bins − 1
  std::size_t bins = 0;
};

/// Nodes of air at which light is computed: fine for fits; coarse (few of aerosol and cloud, one of ozone, no scattered
/// light) for finding a clock's error.
enum class FittedAirs { fine, coarse };

/// Light in bins of a Moon on its way through the shadow, in air whose unknowns have any numbers.
///
/// Light in the shadow is computed once for all moments. Between different air above the observer its logarithm is
/// interpolated by a polynomial through up to four of them.
///
/// Nodes are some numbers of each unknown, over all its range or a part of it. Between nodes the logarithm of light is
/// interpolated by cubics in aerosol and parabolas in ozone. Under a part of a deck of cloud, light is the mean of clear
/// and cloudy light; between factors on the chance of cloud, its logarithm is interpolated by a polynomial.
///
/// Accuracy  of X and Y 0.4 %, of Z 0.8 %, against light_on_the_moon of a tolerance of 0.1 %; between factors 1 % of
///           each; more where dust is above 8e-6 per metre: 2 % of the darkest places beyond 1.5e-5. In a range of
///           a third of the numbers or less 0.3 % of X, Y and Z
class FittedLight {
 public:
  /// Given  request  air but for the unknowns, limb darkening, scattered light; the rest is ignored
  ///        skies    of one eclipse, in order of time: those of all parts, one or more
  ///        parts    of equal numbers of channels
  ///        range    of the unknowns; without: all
  FittedLight(const LightRequest& request, Unknowns unknowns,
              std::span<const almanac::SkyState> skies, std::span<const LitBins> parts,
              FittedAirs airs = FittedAirs::fine, const algebra::Progress& progress = {},
              const std::optional<AirRange>& range = {});

  /// Which unknowns its air has.
  Unknowns unknowns() const { return unknowns_; }
  /// Range of the unknowns in which its light is known.
  const AirRange& range() const { return range_; }

  /// Light of each bin over its sunlit light.
  ///
  /// Returned  (bin, channel); bins of all parts, in their order
  algebra::Grid<double> at(const AirNumbers& numbers) const;

  /// Light of each bin at some aerosol and ozone, to be interpolated by cloud: (bin, channel) at each node of cloud.
  class OverCloud {
   public:
    algebra::Grid<double> under(double cloud) const;

   private:
    friend FittedLight;
    Unknowns unknowns;
    std::vector<double> clouds{};                // as their scale has them
    std::vector<algebra::Grid<double>> light{};  // of factors: its logarithm
  };
  /// Light at some aerosol and ozone.
  OverCloud over_cloud(double aerosol, double ozone) const;

 private:
  /// Nodes of one ozone: [aerosol × clouds + cloud].
  struct InOzone {
    double ozone;
    std::vector<double> aerosols, clouds;
    std::vector<algebra::Grid<double>> logarithms;
  };

  static InOzone node(double ozone, std::vector<double> aerosols, std::vector<double> clouds);
  static std::vector<InOzone> nodes_of(Unknowns unknowns, FittedAirs airs, double aerosol_scale);
  static std::vector<InOzone> nodes_within(const AirRange& range, Unknowns unknowns,
                                           double aerosol_scale);

  Unknowns unknowns_;
  AirRange range_;
  double aerosol_scale_ = 1;
  std::vector<InOzone> nodes_;  // after the first: light over that of the first
};

}  // namespace coppermoon::uses
