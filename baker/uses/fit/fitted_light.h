// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "uses/fit/light_in_bins.h"

namespace coppermoon::uses {

/// Nodes of air at which light is computed: fine for fits; coarse (few for aerosol and cloud, one for ozone, no
/// scattered light) for finding a clock's error.
enum class FittedAirs { fine, coarse };

/// Binned light of a Moon on its way through the shadow, for any values of the air's unknowns: light_in_bins,
/// interpolated.
///
/// Nodes are values of each unknown, over all or part of its range. Between nodes the logarithm of light is
/// interpolated by cubics in aerosol and parabolas in ozone. Under a partial deck of cloud, light is the weighted mean
/// of clear and cloudy light. Between factors on the chance of cloud, its logarithm is interpolated by a polynomial.
///
/// Accuracy  compared with light_on_the_moon at a tolerance of 0.1 %:
///           for amounts of dust up to 8e-6 per metre: 0.4 % of X and Y, 0.8 % of Z
///           for more dust: worse; beyond 1.5e-5 per metre 2 % in the darkest places
///           for factors: 1 % of X, Y and Z
///           in a third of the whole range or less: 0.3 % of X, Y and Z
class FittedLight {
 public:
  /// Given  request  air apart from the unknowns, limb darkening, scattered light; the rest is ignored
  ///        skies    one or more from one eclipse, in order of time, including those of all parts
  ///        parts    with equal numbers of channels
  ///        range    of the unknowns; if absent, the whole range
  FittedLight(const LightRequest& request, Unknowns unknowns,
              std::span<const almanac::SkyState> skies, std::span<const LitBins> parts,
              FittedAirs airs = FittedAirs::fine, const algebra::Progress& progress = {},
              const std::optional<AirRange>& range = {});

  /// Nodes at one value of ozone: the logarithm of light at each aerosol and cloud.
  struct InOzone {
    double ozone;
    std::vector<double> aerosols, clouds;
    std::vector<algebra::Grid<double>> logarithms;  ///< [aerosol × clouds + cloud](bin, channel)
  };

  /// Which properties of the air are fitted.
  Unknowns unknowns() const { return unknowns_; }
  /// Range of the unknowns in which the light is known.
  const AirRange& range() const { return range_; }

  /// Ratio of each bin's light to its sunlit light.
  ///
  /// Returned  (bin, channel); the bins of all parts, in the order of the parts
  algebra::Grid<double> at(const AirNumbers& numbers) const;

  /// Light of each bin at one aerosol and ozone, to be interpolated in cloud: (bin, channel) at each node of cloud.
  class OverCloud {
   public:
    algebra::Grid<double> under(double cloud) const;

   private:
    friend FittedLight;
    Unknowns unknowns;
    std::vector<double> clouds{};                // nodes on the axis of interpolation
    std::vector<algebra::Grid<double>> light{};  // logarithms if cloud is a factor
  };
  /// Light at one aerosol and ozone, as a function of cloud.
  OverCloud over_cloud(double aerosol, double ozone) const;

 private:
  Unknowns unknowns_;
  AirRange range_;
  double aerosol_scale_ = 1;
  std::vector<InOzone> nodes_;  // after the first: ratios to the light of the first
};

}  // namespace coppermoon::uses
