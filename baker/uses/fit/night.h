// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "uses/fit/clock_scan.h"
#include "uses/fit/compared_night.h"
#include "uses/fit/placing.h"

namespace coppermoon::uses {

/// Photographs from one camera and eclipse, with the result of each step of processing.
struct Night {
  FitRequest request;             ///< the request, with only this night's photographs and camera
  std::vector<Reading> readings;  ///< readings, one for each photograph
  Clock clock;
  std::vector<Placed> placed;  ///< registrations, one for each photograph
  std::vector<Binned> binned;  ///< light of the photographs that could be registered
  FittedLight light;
  ComparedNight compared;
};

/// Processes a night for the first time: reads its photographs, finds their clock correction, registers and bins them,
/// and computes light over the whole range of the air's unknowns.
///
/// Photographs whose limb and markings disagree are left out. Then photographs whose light does not fit that of the
/// others in any air are left out one by one, because one such photograph misleads a whole night's fit. Their light
/// is wrong by three stops or more in all channels. One stop is enough if the registration's correlation is below 0.8,
/// or if the Moon is rotated or mirrored differently from the Moon in most other photographs.
///
/// Given   request  photographs from one camera and eclipse
/// Throws  Error    "<file>: …" when no photograph can be read or used; <file> is the first of them
Night first_look(FitRequest request, const algebra::Progress& progress = {});

/// Reason to process a night again with the fitted air; Again::no if there is none.
///
/// Light is computed again over a range near the fitted air until the fit is well within the range. This is not done
/// for photographs with a camera's tone curve, because the curve's error exceeds that of interpolating a wide range.
///
/// Given  turn  number of times that the night has been processed again; 0 after first_look
Again why_again(const Night& night, const AirFit& fit, int turn);

/// Processes a night again with the fitted air, tone curve and colours.
///
/// Given  why    if Again::in_its_air, photographs are also registered again, with the Moon computed for the best air
///        alive  called regularly; may throw to cancel
Night looked_at_again(Night night, Again why, const AirFit& fit, const algebra::Progress& alive);

/// The measurements of a night, as a data set for fitted_air.
///
/// Given  night  must outlive the data set
DataSet data_of(const Night& night);

/// How each photograph was read, in the order of the night's photographs.
std::vector<ReadPhotograph> photographs_of(const Night& night);

/// What was found about a night, for the air with the least χ². Photographs are given by their indices in the night.
///
/// Given  clock  correction found by the fit, in addition to the correction with which the night was processed
FittedNight found_of(const Night& night, const AirFit& fit, const ClockError& clock);

}  // namespace coppermoon::uses
