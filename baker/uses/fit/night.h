// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "uses/fit/clock_scan.h"
#include "uses/fit/compared_night.h"
#include "uses/fit/placing.h"

namespace coppermoon::uses {

/// Photographs of one camera and eclipse, and what each step made of them.
struct Night {
  FitRequest request;             ///< its photographs alone, through its camera's response
  std::vector<Reading> readings;  ///< [photograph]
  Clock clock;
  std::vector<Placed> placed;  ///< [photograph]
  std::vector<Binned> binned;  ///< of those placed, in their order
  FittedLight light;
  ComparedNight compared;
};

/// First look: reads the photographs, finds their clock, places them, bins them, and computes light in all air.
///
/// Left out are photographs that leave_out_far leaves out; then, one by one, those whose light no air explains beside
/// the others': three stops off in all channels, or one where the Moon is poorly recognised or turned unlike most
/// others. One of them misleads a whole night.
///
/// Given   request  photographs of one camera and eclipse
/// Throws  Error    "<file>: …" for one alone that cannot be read or used, the first of several when none can
Night first_look(FitRequest request, const algebra::Progress& progress = {});

/// Why a night is looked at again with the air that was found; or not.
///
/// Light is computed nearby until the fit is well within its range; not for photographs by a tone curve, which errs by
/// more than light between nodes of the whole range.
///
/// Given  turn  how often it was before: 0 after the first look
Again why_again(const Night& night, const AirFit& fit, int turn);

/// Looks at a night again by what was found of air, tone curve and colours.
///
/// Given  why    in_its_air: photographs are registered once more, in the best air
///        alive  called now and then; may throw to cancel
Night looked_at_again(Night night, Again why, const AirFit& fit, const algebra::Progress& alive);

/// Measurements of a night. Given  night  outlives them
DataSet data_of(const Night& night);

/// Photographs as read, in the order of the night's.
std::vector<ReadPhotograph> photographs_of(const Night& night);

/// What is found of a night in the air of the least χ²; photographs are the night's.
///
/// Given  clock  that the fit found beside the night's own
FittedNight found_of(const Night& night, const AirFit& fit, const ClockError& clock);

}  // namespace coppermoon::uses
