// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/quantity.h"

namespace coppermoon::atmosphere {

/// Mean height of the tropopause, where weather ends.
///
/// Given     latitude  −90° to 90°, held beyond 85°
///           year      with its fraction, which is the season: 2018.5 is July
/// Returned  [m]       16 400 in the tropics, 8000 to 15 400 elsewhere
/// Accuracy  0.7 km of single balloons
/// Throws    Error     when the latitude is outside its range
/// Source    Mateus, Mendes & Pires (2022), Remote Sens. 14, 4303: 3.5 units of potential vorticity
double tropopause_m(algebra::Angle latitude, double year);

/// Places of a table that runs once around the year, and what each counts.
struct SeasonShare {
  int before, after;  ///< 0 to `steps` − 1
  double share_after;
};

/// Given  year   with its fraction
///        steps  of the table
///        first  of the year: where its first entry stands, as 0.04 for mid January
SeasonShare season_share(double year, int steps, double first);

}  // namespace coppermoon::atmosphere
