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
  double colour = 0;  ///< colour of the ground (surface::Ground)
};

/// Ground of the Moon at one moment, as one observer sees it, divided into bins.
struct LitBins {
  /// Non-negative weights (channel, band), which turn a spectrum into the light of average ground in each channel.
  algebra::Grid<double> weights;
  std::vector<LitPlace> places;  ///< places on the ground, each in one of the bins 0 to bins − 1
  std::size_t bins = 0;
};

/// Light of the Moon on its way through the shadow, averaged over bins, for several kinds of air. Light in the shadow
/// is computed once for all moments, and the effect of the air above the observer at four moments or fewer.
///
/// Given     request    supplies the air (apart from the unknowns) and limb darkening; the rest is ignored
///           skies      one or more from one eclipse, in order of time, including the moments of all `parts`
///           parts      bins at each moment, all with the same number of channels
///           numbers    values of the unknowns for each air
///           scattered  whether to include light that the air scatters
/// Returned  for each air, a grid (bin, channel) of ln(light / full sunlight), with the bins in the order of `parts`
std::vector<algebra::Grid<double>> light_in_bins(const LightRequest& request, Unknowns unknowns,
                                                 std::span<const almanac::SkyState> skies,
                                                 std::span<const LitBins> parts,
                                                 std::span<const AirNumbers> numbers,
                                                 bool scattered,
                                                 const algebra::Progress& progress = {});

/// Refracted light at any place, for each wavelength, interpolated linearly in depth and by cubics in position angle.
class RefractedAt {
 public:
  /// Given  light  in all sectors around the axis, or those to be read and one on each side; must outlive this object
  explicit RefractedAt(const shadow::RefractedLight& light);

  /// Writes the ratio of refracted light at a place to sunlight without the shadow, for each wavelength.
  void read(const eclipse::ShadowPlace& place, std::span<double> ratios);

 private:
  const shadow::RefractedLight& light_;
  shadow::BetweenPlaces between_places_;
  std::vector<double> some_;
};

}  // namespace coppermoon::uses
