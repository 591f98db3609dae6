// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/quantity.h"

namespace coppermoon::atmosphere {

/// Mean altitude of the tropopause.
///
/// Given     latitude  −90° to 90°; constant beyond 85°
///           year      its fractional part gives the season: 2018.5 is July
/// Returned  [m]       16 400 in the tropics, 8000 to 15 400 elsewhere
/// Accuracy  0.7 km compared with individual balloon soundings
/// Throws    Error     when the latitude is outside its range
/// Source    Mateus, Mendes & Pires (2022), Remote Sens. 14, 4303, for a tropopause at 3.5 potential vorticity units
double tropopause_m(algebra::Angle latitude, double year);

/// Two neighbouring entries of a cyclic table over the year, and the weight of the second for linear interpolation.
struct SeasonShare {
  int before, after;  ///< indices of the two entries
  double share_after;
};

/// Interpolation in a cyclic table over the year, for a given moment.
///
/// Given  year   its fractional part gives the season
///        steps  number of entries in the table
///        first  moment of the first entry, as a fraction of the year: 0.04 for mid January
SeasonShare season_share(double year, int steps, double first);

}  // namespace coppermoon::atmosphere
