// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "almanac/instant.h"
#include "uses/fit/air_fit.h"
#include "uses/picture/moon.h"

namespace coppermoon::uses {

/// Measured magnitude of the whole Moon, as it would be seen from the Earth's centre without air.
struct MeasuredMagnitude {
  almanac::Instant instant;
  std::string band;    ///< B, V or R
  double magnitude;    ///< −30 to 30
  double error = 0.1;  ///< standard error [mag], 0.001 to 0.99
};

/// Reads magnitudes from a comma-separated file. Numbers have decimal points. The first line names the columns:
/// instant, band, magnitude and optionally error (0.001 to 0.99). If the error is absent or empty, it is 0.1. A
/// byte-order mark and lines that begin with # are ignored. Any kind of line ending is accepted.
///
/// Throws  Error  with the line's number, when a column is repeated or unknown, or when a line has more or fewer
///                columns than the first, as decimal commas would cause
std::vector<MeasuredMagnitude> read_magnitudes(const std::string& file);

/// Makes a data set of the magnitudes measured at one moment. The error of computed magnitudes, 0.02 mag, is added to
/// each measurement's error in quadrature.
///
/// Given   moon             supplies the request for light (as for FittedLight), the map and the photometry
///         sky              at the moment of the magnitudes
///         of_one_instant   magnitudes; their own instants are ignored
/// Throws  Error            when no eclipse is under way
DataSet data_of(const MoonRequest& moon, Unknowns unknowns, const almanac::SkyState& sky,
                const std::vector<MeasuredMagnitude>& of_one_instant,
                const algebra::Progress& progress = {});

}  // namespace coppermoon::uses
