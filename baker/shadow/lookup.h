// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "algebra/grid.h"
#include "eclipse/shadow_axis.h"
#include "shadow/irradiance.h"
#include "shadow/lookup_table.h"

namespace coppermoon::shadow {

/// Weighted sums over wavelength, a row of weights for each channel.
using ChannelWeights = algebra::Grid<double>;  // (channel, wavelength)

/// The part of the light in the shadow that a look-up holds.
enum class LightPart {
  all,
  refracted,  ///< what the Earth's air bends and scatters into the shadow; no sunlight beyond it
  direct,     ///< sunlight that passes clear of the Earth and its air
};

/// The axis distances that a look-up is read at, and how exactly.
struct LookupRange {
  double from_m = 0;
  double to_m = std::numeric_limits<double>::infinity();  ///< at most to the penumbra's end
  double tolerance = 1e-4;                                ///< see Lookup's Accuracy; 1e-6 to 0.1
  /// sectors that are read, two on either side of each place: the others may stay dark. All are, of light
  /// in another number of sectors around
  Sectors sectors{};
};

/// Refracted light between the places where it is known, each wavelength by itself: a cubic through
/// four of them, none below 0. Of rings of photons, which cannot be put closer where light falls
/// steeply, the cubic is of the light's logarithm where all four are known to a third or better and
/// within a factor of a thousand of each other, and goes on beyond the axis in the opposite sector.
/// Elsewhere the end values hold, the last one half a spacing far, for rings end there, and no light
/// beyond.
///
/// Accuracy  of light that falls by e in two spacings 2e-3, of the logarithm 1e-5
class BetweenPlaces {
 public:
  /// Given  light  that outlives this
  explicit BetweenPlaces(const RefractedLight& light);

  /// Writes one ratio a wavelength.
  void read(std::size_t plane, std::size_t sector, double at_m, std::span<double> ratios) const;

  /// Whether light is known here, or between places.
  bool knows(double at_m) const { return at_m >= from_m_ && at_m <= to_m_; }

 private:
  const RefractedLight& light_;
  std::vector<algebra::Grid<double>>
      logs_;                     ///< [as ratio]; NaN: not known well; empty: no photons'
  std::size_t beyond_axis_ = 0;  ///< places of the opposite sector that are read
  double from_m_, to_m_;
};

/// Light in the shadow, refracted and direct, in a few channels: a table over place that is
/// read once a texel. Linear in depth and axis distance, cubic in position angle; sunlight beyond the
/// penumbra. Planes are compared along lines from the limb (`sheared`), on which light hardly
/// changes with depth.
///
/// The table's nodes stand closer than the places where refracted light is known (BetweenPlaces).
/// Direct light is computed at the nodes.
class Lookup {
 public:
  /// Given     light    refracted light; direct: the sunlight that goes with it
  ///           weights  of each channel for the ratio at each wavelength
  ///           range    outside of it the outermost values hold, but for sunlight
  /// Accuracy  straight lines between nodes err by less than the tolerance of the brightest channel
  ///           (each counted in its own sunlight), unless nodes were to stand closer than 1 km, or
  ///           the table to take more than half a gigabyte
  /// Throws    Error    when the tolerance is outside its range
  Lookup(const RefractedLight& light, const DirectLight& direct, const ChannelWeights& weights,
         const LookupRange& range = {}, LightPart part = LightPart::all);

  /// Full sunlight everywhere, as without a shadow; with `LightPart::refracted`, zero everywhere.
  explicit Lookup(const ChannelWeights& weights, LightPart part = LightPart::all);

  std::size_t channels() const { return table_.channels; }

  /// Writes one value a channel.
  void read(const eclipse::ShadowPlace& place, std::span<double> values) const;

  /// Writes the values at many places: see LookupTable.
  void read(const Places& places, std::span<double> values) const {
    shadow::read(table_, places, values);
  }

  /// Changes every entry in place: what a working space does to colours outside its gamut.
  void transform(const std::function<void(std::span<double>)>& change);

  /// Largest standard error of the first channel over its value between two axis distances, of photons
  /// with what rings cannot resolve; 1 where nothing arrived. Only before `transform`, and of the
  /// light and the weights it was made from.
  double worst_relative_error(const RefractedLight& light, const ChannelWeights& weights,
                              double from_m, double to_m) const;

 private:
  LookupTable table_;
};

}  // namespace coppermoon::shadow
