// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "algebra/grid.h"
#include "eclipse/shadow_axis.h"
#include "shadow/irradiance.h"
#include "shadow/lookup_table.h"

namespace coppermoon::shadow {

/// Weights of wavelengths in each channel.
using ChannelWeights = algebra::Grid<double>;  // (channel, wavelength)

/// Which part of the light in the shadow a look-up holds.
enum class LightPart {
  all,
  refracted,  ///< light that the Earth's air bends and scatters into the shadow; 0 outside the shadow
  direct,     ///< sunlight that passes clear of the Earth and its air
};

/// Axis distances and sectors in which a look-up will be read, and its tolerance.
struct LookupRange {
  double from_m = 0;
  double to_m = std::numeric_limits<double>::infinity();  ///< clamped to the penumbra's end
  double tolerance = 1e-4;                                ///< 1e-6 to 0.1; see Lookup
  /// sectors to hold, including two on either side of each place that is read; the look-up may be dark in all others.
  /// If the light has another number of sectors around the axis than `sectors.around`, all its sectors are held
  Sectors sectors{};
};

/// Interpolates refracted light in axis distance, wavelength by wavelength, with a cubic through four places where it
/// is known. Negative results become 0. If the light was simulated with photons, which are gathered in rings of equal
/// width, the cubic continues across the axis into the opposite sector. It then interpolates the light's logarithm if
/// all four rings have relative errors of at most 1/3 and lie within a factor of a thousand. Before the first known
/// place, and up to half a spacing beyond the last, light is that of the nearest place. Farther out it is 0.
///
/// Accuracy  2e-3 for light that falls by a factor e in two spacings; 1e-5 if the logarithm is interpolated
class BetweenPlaces {
 public:
  /// Given  light  must outlive this object
  explicit BetweenPlaces(const RefractedLight& light);

  /// Writes refracted light as a ratio to unshaded sunlight at each wavelength.
  void read(std::size_t plane, std::size_t sector, double at_m, std::span<double> ratios) const;

  /// Whether an axis distance lies between the first and the last known place.
  bool knows(double at_m) const { return at_m >= from_m_ && at_m <= to_m_; }

 private:
  const RefractedLight& light_;
  std::vector<algebra::Grid<double>>
      logs_;  ///< logarithms of `ratio`, NaN if it is too noisy; empty for light without noise
  std::size_t beyond_axis_ = 0;  ///< number of places across the axis that the cubic may use
  double from_m_, to_m_;
};

/// Look-up table of refracted and direct light in a few channels, by place in the shadow. It is read once per texel.
/// Interpolation is linear in depth and axis distance and cubic in position angle; beyond the penumbra there is full
/// sunlight. Interpolation in depth follows lines from the limb (`sheared`), along which light hardly changes.
///
/// The table's nodes are denser than the places where refracted light is known (BetweenPlaces). Direct light is
/// computed at the nodes.
class Lookup {
 public:
  /// Given     light    refracted light
  ///           direct   direct light for the same arrangement
  ///           weights  (channel, wavelength): how much each wavelength counts in each channel
  ///           range    part of the shadow to tabulate; outside it, the outermost values apply up to the penumbra's end
  /// Accuracy  with each channel relative to its unshaded sunlight, the error of linear interpolation between nodes is
  ///           less than the tolerance times the brightest channel, unless that requires nodes closer than 1 km (250 m
  ///           if the Sun is not limb-darkened) or a table larger than half a gigabyte
  /// Throws    Error    if the tolerance is outside its range
  Lookup(const RefractedLight& light, const DirectLight& direct, const ChannelWeights& weights,
         const LookupRange& range = {}, LightPart part = LightPart::all);

  /// Look-up without a shadow: full sunlight everywhere, or 0 for `LightPart::refracted`.
  explicit Lookup(const ChannelWeights& weights, LightPart part = LightPart::all);

  /// Look-up with a table taken from another look-up.
  explicit Lookup(LookupTable table) : table_(std::move(table)) {}

  const LookupTable& table() const { return table_; }

  std::size_t channels() const { return table_.channels; }

  /// Writes the value of each channel at one place in the shadow.
  void read(const eclipse::ShadowPlace& place, std::span<double> values) const;

  /// Writes the values at many places, in the order described at `read` for a LookupTable.
  void read(const Places& places, std::span<double> values) const {
    shadow::read(table_, places, values);
  }

  /// Applies a function, such as gamut mapping, to the channels of every entry of the table, in place.
  void transform(const std::function<void(std::span<double>)>& change);

  /// Largest relative standard error of the first channel between two axis distances; 1 where no light arrived. It
  /// includes the error due to structure that the rings of photons do not resolve.
  ///
  /// Given  light, weights  those from which the look-up was made, which must not have been transformed since
  double worst_relative_error(const RefractedLight& light, const ChannelWeights& weights,
                              double from_m, double to_m) const;

 private:
  LookupTable table_;
};

}  // namespace coppermoon::shadow
