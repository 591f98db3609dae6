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

/// A place on an eclipsed Moon, its light without the shadow, and the bin it belongs to.
struct LitPlace {
  eclipse::ShadowPlace place;
  double sunlit;  ///< light without the shadow, in any unit
  std::size_t bin;
  double colour = 0;  ///< ground's colour c, as in surface::Ground
};

/// Ground of the Moon at one moment, divided into bins, as one observer sees it.
struct LitBins {
  /// Grid (channel, band) of weights, 0 or more, that turn a spectrum into the light of mean ground in each channel.
  algebra::Grid<double> weights;
  std::vector<LitPlace> places;  ///< with bins from 0 to bins − 1
  std::size_t bins = 0;
};

/// Binned light of a Moon on its way through the shadow, for several kinds of air. Light in the shadow is computed once
/// for all moments. The effect of the air above the observer is interpolated between four moments or fewer.
///
/// Given     request    air (apart from the unknowns) and limb darkening; the rest is ignored
///           skies      one or more from one eclipse, in order of time, among them the moments of all parts
///           parts      with equal numbers of channels
///           numbers    values of the unknowns for each air
///           scattered  whether to include light that the air scatters
/// Returned  [air](bin, channel): logarithm of light / sunlit light, in the bins of one part after another
std::vector<algebra::Grid<double>> light_in_bins(const LightRequest& request, Unknowns unknowns,
                                                 std::span<const almanac::SkyState> skies,
                                                 std::span<const LitBins> parts,
                                                 std::span<const AirNumbers> numbers,
                                                 bool scattered,
                                                 const algebra::Progress& progress = {});

/// Interpolates refracted light at any place, by wavelength. It is linear between planes and cubic between sectors.
class RefractedAt {
 public:
  /// Given  light  in all sectors, or in the sectors around the places and one more at either end; must outlive this
  explicit RefractedAt(const shadow::RefractedLight& light);

  /// Writes the ratio of refracted light at a place to sunlight without the shadow, for each wavelength.
  void read(const eclipse::ShadowPlace& place, std::span<double> ratios);

 private:
  const shadow::RefractedLight& light_;
  shadow::BetweenPlaces between_places_;
  std::vector<double> some_;
};

}  // namespace coppermoon::uses
