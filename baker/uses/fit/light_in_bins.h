// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "algebra/grid.h"
#include "algebra/progress.h"
#include "almanac/sky.h"
#include "eclipse/shadow_axis.h"
#include "shadow/irradiance.h"
#include "shadow/lookup.h"
#include "uses/fit/unknowns.h"
#include "uses/light/moonlight.h"

namespace coppermoon::uses {

/// A place of an eclipsed Moon, its sunlit light, and its bin.
struct LitPlace {
  eclipse::ShadowPlace place;
  double sunlit;  ///< light without the shadow, in any unit
  std::size_t bin;
  double colour = 0;  ///< colour c of the ground, as in surface::Ground
};

/// The Moon's ground at one moment, in bins, as one observer sees it.
struct LitBins {
  /// (channel, band), 0 or more: weights that give the moonlight of mean ground as seen, like those for XYZ.
  algebra::Grid<double> weights;
  std::vector<LitPlace> places;  ///< in bins 0 to bins − 1
  std::size_t bins = 0;
};

/// Binned light of a Moon on its way through the shadow, computed for each of several airs. Light in the shadow is
/// computed once for all moments. For the air above the observer, its logarithm is interpolated by a polynomial through
/// at most four nodes.
///
/// Given     request    air apart from the unknowns, limb darkening; the rest is ignored
///           skies      one or more from one eclipse, in order of time, including those of all parts
///           parts      with equal numbers of channels
///           numbers    values of the unknowns for each air
///           scattered  whether to include light that the air scatters
/// Returned  [air](bin, channel): logarithm of light / sunlit light, for the bins of all parts in their order
std::vector<algebra::Grid<double>> light_in_bins(const LightRequest& request, Unknowns unknowns,
                                                 std::span<const almanac::SkyState> skies,
                                                 std::span<const LitBins> parts,
                                                 std::span<const AirNumbers> numbers,
                                                 bool scattered,
                                                 const algebra::Progress& progress = {});

/// Refracted light at any place, by wavelength: linear between planes, cubic between sectors.
class RefractedAt {
 public:
  /// Given  light  in all sectors, or in those that hold the places and one more at either end; must outlive this
  explicit RefractedAt(const shadow::RefractedLight& light);

  /// Writes the ratio to unshadowed sunlight at each wavelength.
  void read(const eclipse::ShadowPlace& place, std::span<double> ratios);

 private:
  const shadow::RefractedLight& light_;
  shadow::BetweenPlaces between_places_;
  std::vector<double> some_;
};

}  // namespace coppermoon::uses
