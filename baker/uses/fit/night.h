// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "uses/fit/clock_scan.h"
#include "uses/fit/compared_night.h"
#include "uses/fit/placing.h"

namespace coppermoon::uses {

/// Photographs from one camera and eclipse, and what each step made of them.
struct Night {
  FitRequest request;             ///< this night's photographs alone, with its camera's response
  std::vector<Reading> readings;  ///< [photograph]
  Clock clock;
  std::vector<Placed> placed;  ///< [photograph]
  std::vector<Binned> binned;  ///< the placed photographs, in their order
  FittedLight light;
  ComparedNight compared;
};

/// First look: reads the photographs, finds their clock, places and bins them, and computes light for all air.
///
/// It leaves out the photographs that leave_out_far rejects; then, one by one, those whose light no air explains along
/// with that of the others. They are three stops off in all channels, or one stop if the Moon is poorly recognised or
/// turned unlike most others. A single such photograph misleads a whole night.
///
/// Given   request  photographs from one camera and eclipse
/// Throws  Error    "<file>: …" when no photograph can be read or used, for the first of them
Night first_look(FitRequest request, const algebra::Progress& progress = {});

/// Why to process a night again with the air that was found, if at all.
///
/// Light is computed nearby until the fit is well within its range. This does not apply to photographs with a tone
/// curve: the curve's error exceeds that of interpolating light between nodes of the whole range.
///
/// Given  turn  how often the night was processed again before: 0 after the first look
Again why_again(const Night& night, const AirFit& fit, int turn);

/// Processes a night again with the air, tone curve and colours that were found.
///
/// Given  why    if in_its_air, photographs are registered once more, in the best air
///        alive  called now and then; may throw to cancel
Night looked_at_again(Night night, Again why, const AirFit& fit, const algebra::Progress& alive);

/// The measurements of a night.
///
/// Given  night  must outlive the data set
DataSet data_of(const Night& night);

/// How each photograph was read, in the night's order.
std::vector<ReadPhotograph> photographs_of(const Night& night);

/// What was found about a night in the air with the least χ²; photographs are indices in the night.
///
/// Given  clock  correction that the fit found in addition to the night's own
FittedNight found_of(const Night& night, const AirFit& fit, const ClockError& clock);

}  // namespace coppermoon::uses
