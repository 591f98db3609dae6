// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "uses/fit/light_in_bins.h"

namespace coppermoon::uses {

/// Nodes of air at which light is computed: fine for fits; coarse (few of aerosol and cloud, one of ozone, no scattered
/// light) for finding a clock's error.
enum class FittedAirs { fine, coarse };

/// Light in bins of a Moon on its way through the shadow, in air whose unknowns have any numbers: light_in_bins,
/// interpolated.
///
/// Nodes are some numbers of each unknown, over all its range or a part of it. Between nodes the logarithm of light is
/// interpolated by cubics in aerosol and parabolas in ozone. Under a part of a deck of cloud, light is the mean of
/// clear and cloudy light; between factors on the chance of cloud, its logarithm is interpolated by a polynomial.
///
/// Accuracy  against light_on_the_moon of a tolerance of 0.1 %:
///           of amounts of dust up to 8e-6 per metre: 0.4 % of X and Y, 0.8 % of Z
///           of more dust: more; beyond 1.5e-5 per metre 2 % of the darkest places
///           of factors: 1 % of X, Y and Z
///           in a range of a third of the numbers or less: 0.3 % of X, Y and Z
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

  /// Nodes of one ozone: the logarithm of light at each aerosol and cloud.
  struct InOzone {
    double ozone;
    std::vector<double> aerosols, clouds;
    std::vector<algebra::Grid<double>> logarithms;  ///< [aerosol × clouds + cloud](bin, channel)
  };

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
    std::vector<double> clouds{};                // nodes on the axis of interpolation
    std::vector<algebra::Grid<double>> light{};  // of factors: its logarithm
  };
  /// Light at some aerosol and ozone.
  OverCloud over_cloud(double aerosol, double ozone) const;

 private:
  Unknowns unknowns_;
  AirRange range_;
  double aerosol_scale_ = 1;
  std::vector<InOzone> nodes_;  // after the first: light over that of the first
};

}  // namespace coppermoon::uses
