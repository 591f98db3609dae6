// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "algebra/grid.h"
#include "eclipse/shadow_axis.h"
#include "shadow/irradiance.h"

namespace coppermoon::shadow {

/// Weighted sums over wavelength, a row of weights for each channel.
using ChannelWeights = algebra::Grid<double>;  // (channel, wavelength)

/// All light in the shadow, refracted and direct, in a few channels: a table over place that is
/// read once a texel. Linear in depth, axis distance and position angle; sunlight beyond the
/// penumbra.
class Lookup {
 public:
  /// Given   light            refracted light; direct: the sunlight that goes with it
  ///         weights          what each channel makes of the ratio at each wavelength
  ///         axis_spacing_m   of the table
  Lookup(const RefractedLight& light, const DirectLight& direct, const ChannelWeights& weights,
         double axis_spacing_m = 10e3);

  /// Full sunlight everywhere: no shadow.
  explicit Lookup(const ChannelWeights& weights);

  std::size_t channels() const { return sunlight_.size(); }

  /// Writes one value a channel.
  void read(const eclipse::ShadowPlace& place, std::span<double> values) const;

  /// Changes every entry in place: what a working space does to colours outside its gamut.
  void transform(const std::function<void(std::span<double>)>& change);

  /// Largest standard error of a channel over that channel's value between two axis distances; 1
  /// where nothing arrived. Only before `transform`.
  double worst_relative_error(std::size_t channel, double from_m, double to_m) const;

 private:
  void fill(const RefractedLight& light, std::size_t grid, std::size_t node,
            std::span<double> ratios, const ChannelWeights& weights);
  std::span<const double> entry(std::size_t plane, std::size_t sector, std::size_t node) const;

  std::vector<double> depths_m_, sunlight_;
  std::size_t sectors_ = 1, nodes_ = 0;
  double spacing_m_ = 1;
  algebra::Grid<double> values_, errors_;  // ((plane × sectors + sector) × nodes + node, channel)
};

}  // namespace coppermoon::shadow
