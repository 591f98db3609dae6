// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/quantity.h"

namespace coppermoon::atmosphere {

/// Mean altitude of the tropopause.
///
/// Given     latitude  −90° to 90°; constant beyond 85°
///           year      its fractional part gives the season: 2018.5 is July
/// Returned  [m]       16 400 in the tropics, 8000 to 15 400 elsewhere
/// Accuracy  0.7 km compared with single balloon soundings
/// Throws    Error     when the latitude is outside its range
/// Source    Mateus, Mendes & Pires (2022), Remote Sens. 14, 4303: surface of 3.5 potential vorticity units
double tropopause_m(algebra::Angle latitude, double year);

/// Linear interpolation in a table that covers the year and wraps around: two entries and the weight of the second.
struct SeasonShare {
  int before, after;  ///< indices of the entries, 0 to `steps` − 1
  double share_after;
};

/// The two entries, in a table over the year, on either side of a point in time.
///
/// Given  year   its fractional part gives the season
///        steps  number of entries
///        first  fraction of the year at the first entry, such as 0.04 for mid January
SeasonShare season_share(double year, int steps, double first);

}  // namespace coppermoon::atmosphere
