// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "uses/fit/clock_scan.h"
#include "uses/fit/compared_night.h"
#include "uses/fit/placing.h"

namespace coppermoon::uses {

/// Photographs from one camera and eclipse, with the result of each step of processing.
struct Night {
  FitRequest request;             ///< for this night's photographs only, with the camera's response
  std::vector<Reading> readings;  ///< [photograph]
  Clock clock;
  std::vector<Placed> placed;  ///< [photograph]
  std::vector<Binned> binned;  ///< the photographs that could be placed
  FittedLight light;
  ComparedNight compared;
};

/// Processes a night for the first time: reads its photographs, finds their clock correction, places and bins them, and
/// computes light over the whole range of air.
///
/// Photographs that leave_out_far rejects are left out. Then, one by one, those are left out whose light no air
/// explains together with that of the others, because one such photograph misleads a whole night. Their light is wrong
/// by three stops or more in all channels; one stop is enough if the Moon is poorly recognised or turned unlike most
/// others.
///
/// Given   request  photographs from one camera and eclipse
/// Throws  Error    "<file>: …" when no photograph can be read or used, for the first of them
Night first_look(FitRequest request, const algebra::Progress& progress = {});

/// Reason to process a night again with the air that was found; Again::no if there is none.
///
/// Light is computed again over a range near that air until the fit is well within the range. This is not done for
/// photographs with a camera's tone curve, because the curve's error exceeds that of interpolating a wide range.
///
/// Given  turn  number of times that the night was processed again before; 0 after the first look
Again why_again(const Night& night, const AirFit& fit, int turn);

/// Processes a night again with the air, tone curve and colours that were found.
///
/// Given  why    if in_its_air, photographs are also registered again, with the Moon computed for the best air
///        alive  called now and then; may throw to cancel
Night looked_at_again(Night night, Again why, const AirFit& fit, const algebra::Progress& alive);

/// The measurements of a night, as a data set for fitted_air.
///
/// Given  night  must outlive the data set
DataSet data_of(const Night& night);

/// How each photograph was read, in the night's order.
std::vector<ReadPhotograph> photographs_of(const Night& night);

/// What was found about a night, for the air with the least χ². Photographs are given by their indices in the night.
///
/// Given  clock  correction found by the fit, in addition to the one with which the night was processed
FittedNight found_of(const Night& night, const AirFit& fit, const ClockError& clock);

}  // namespace coppermoon::uses
