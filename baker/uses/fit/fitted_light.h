// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "uses/fit/light_in_bins.h"

namespace coppermoon::uses {

/// For how many values of the air's unknowns light is computed. `coarse` is for a rough fit, for example to find the
/// error of a camera's clock: few values of aerosol and cloud, one value of ozone, and no scattered light.
enum class FittedAirs { fine, coarse };

/// Light of the Moon on its way through the shadow, averaged over bins of its ground, for any values of the air's
/// unknowns. It is interpolated between nodes, the values for which light_in_bins computes it.
///
/// Nodes cover all or part of the range of each unknown. Between nodes, the logarithm of light is interpolated by
/// cubics in aerosol and parabolas in ozone. For Unknowns::amounts, light under partial cloud cover is the weighted
/// mean of clear and cloudy light. For Unknowns::factors, a polynomial in the cloud factor interpolates ln(light).
///
/// Accuracy  compared with light_on_the_moon at a tolerance of 0.1 %:
///           with Unknowns::amounts and dust up to 8e-6 per metre: 0.4 % in X and Y, 0.8 % in Z
///           with Unknowns::amounts and more dust: worse; beyond 1.5e-5 per metre, 2 % in the darkest places
///           with Unknowns::factors: 1 % in X, Y and Z
///           if the range is at most a third of the whole range: 0.3 % in X, Y and Z
class FittedLight {
 public:
  /// Given  request  supplies air (apart from the unknowns), limb darkening and scattered light; the rest is ignored
  ///        skies    one or more from one eclipse, in order of time, including the moments of all `parts`
  ///        parts    bins at each moment, all with the same number of channels
  ///        range    range of the unknowns; if absent, the whole range
  FittedLight(const LightRequest& request, Unknowns unknowns,
              std::span<const almanac::SkyState> skies, std::span<const LitBins> parts,
              FittedAirs airs = FittedAirs::fine, const algebra::Progress& progress = {},
              const std::optional<AirRange>& range = {});

  /// Light at one value of ozone. Each pair of aerosol and cloud has a grid (bin, channel) of the logarithm of light.
  struct InOzone {
    double ozone;
    std::vector<double> aerosols, clouds;
    std::vector<algebra::Grid<double>> logarithms;  ///< index: aerosol × clouds + cloud
  };

  /// Kind of the unknowns on which the light depends.
  Unknowns unknowns() const { return unknowns_; }
  /// Range of the unknowns for which light can be interpolated.
  const AirRange& range() const { return range_; }

  /// Ratio of each bin's light to its light without the shadow, for given values of the unknowns.
  ///
  /// Returned  grid (bin, channel), with the bins of all moments one after another
  algebra::Grid<double> at(const AirNumbers& numbers) const;

  /// Light of each bin at one value of aerosol and ozone, for any cloud. It is interpolated between values of cloud,
  /// each of which has a grid (bin, channel).
  class OverCloud {
   public:
    algebra::Grid<double> under(double cloud) const;

   private:
    friend FittedLight;
    Unknowns unknowns;
    std::vector<double> clouds{};                // cloud of each grid, scaled for interpolation
    std::vector<algebra::Grid<double>> light{};  // light, or its logarithm if cloud is a factor
  };
  /// Light at one value of aerosol and ozone, as a function of cloud.
  OverCloud over_cloud(double aerosol, double ozone) const;

 private:
  Unknowns unknowns_;
  AirRange range_;
  double aerosol_scale_ = 1;
  std::vector<InOzone> nodes_;  // first ozone: light; other ozone: ratios to it
};

}  // namespace coppermoon::uses
