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

/// Reads a list of magnitudes: comma-separated, with decimal points. The first line names the columns instant, band,
/// magnitude and, optionally, error, 0.001 to 0.99; default, and of an empty cell: 0.1. Lines that begin with #
/// and a byte-order mark are ignored; lines may end in any way.
///
/// Throws  Error  with the line's number: a column twice or of another name, a line of more or fewer columns than
///                the first, as decimal commas make it
std::vector<MeasuredMagnitude> read_magnitudes(const std::string& file);

/// Magnitudes of one moment as a data set. Each error gets 0.02 mag of the computation added in quadrature.
///
/// Given   moon             light as FittedLight takes it, map and photometry
///         sky              of that moment
///         of_one_instant   whose own instants are ignored
/// Throws  Error            when no eclipse is under way
DataSet data_of(const MoonRequest& moon, Unknowns unknowns, const almanac::SkyState& sky,
                const std::vector<MeasuredMagnitude>& of_one_instant,
                const algebra::Progress& progress = {});

}  // namespace coppermoon::uses
