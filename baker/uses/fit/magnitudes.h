// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "almanac/instant.h"
#include "uses/fit/air_fit.h"
#include "uses/picture/moon.h"

namespace coppermoon::uses {

/// Measured magnitude of the whole Moon, reduced to the Earth's centre and to above the air.
struct MeasuredMagnitude {
  almanac::Instant instant;
  std::string band;    ///< B, V or R
  double magnitude;    ///< −30 to 30
  double error = 0.1;  ///< standard error, 0.001 to 0.99
};

/// Reads a comma-separated list of magnitudes with decimal points. The first line names the columns: instant, band,
/// magnitude and optionally error, 0.001 to 0.99. An error that is absent or empty is taken as 0.1. Lines that begin
/// with # and a byte-order mark are ignored. Any kind of line ending will do.
///
/// Throws  Error  with the line's number, for a repeated or unknown column, or for a line with more or fewer columns
///                than the first, which decimal commas cause
std::vector<MeasuredMagnitude> read_magnitudes(const std::string& file);

/// Magnitudes from one moment as a data set. The computation's error, 0.02 mag, is added to each error in quadrature.
///
/// Given   moon             light as in FittedLight, map and photometry
///         sky              at that moment
///         of_one_instant   magnitudes, whose own instants are ignored
/// Throws  Error            when no eclipse is under way
DataSet data_of(const MoonRequest& moon, Unknowns unknowns, const almanac::SkyState& sky,
                const std::vector<MeasuredMagnitude>& of_one_instant,
                const algebra::Progress& progress = {});

}  // namespace coppermoon::uses
