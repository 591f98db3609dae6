// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "algebra/grid.h"
#include "uses/picture/scattered_colour.h"

namespace coppermoon::uses {

/// Colour of a twilight sky by direction.
///
/// Sunlight that molecules and aerosol scatter once on a straight line of sight through round air, with molecules, ozone
/// and aerosol dimming it before and after; and a fifth of the sky's mean, scattered once more by molecules, so that the
/// Earth's shadow has a colour. A Sun so low that nothing is lit has the colour of ScatteredColour overhead.
///
/// Given     sun_altitude  airless
/// Accuracy  of colour alone: luminance is atmosphere::Twilight's
/// Omits     change of colour below 2 degrees; refraction; light scattered by the ground; elevation of the observer
class TwilightColour {
 public:
  TwilightColour(const atmosphere::ObserverAir& air, algebra::Angle sun_altitude);

  /// Colour of luminance 1.
  ///
  /// Given  aside  azimuth from the Sun's, of either sign
  Rgb towards(algebra::Angle altitude, algebra::Angle aside) const;

 private:
  algebra::Grid<Rgb> colours_;  ///< [altitude][azimuth from the Sun's]
};

}  // namespace coppermoon::uses
