// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "almanac/instant.h"
#include "uses/fit/air_fit.h"
#include "uses/picture/moon.h"

namespace coppermoon::uses {

/// Brightness of the whole Moon in a band, as someone measured it, reduced to the Earth's centre and
/// to above the air.
struct MeasuredMagnitude {
  almanac::Instant instant;
  std::string band;    ///< B, V or R
  double magnitude;    ///< −30 to 30
  double error = 0.1;  ///< standard, 0.001 to 0.99
};

/// Reads a list of magnitudes: comma-separated, lines that begin with # left out, first the names of the columns
/// instant, band, magnitude and, if the measurer tells, error, 0.001 to 0.99 (without, or empty: 0.1).
/// Decimal points; a byte-order mark and any line ends.
///
/// Throws  Error  with the line, of what is no such list: a column twice or of another name, a line of
///                more or fewer columns than the first, as one with decimal commas has
std::vector<MeasuredMagnitude> read_magnitudes(const std::string& file);

/// Magnitudes of one moment as a witness, and the light that it refers to.
struct MagnitudeWitness {
  std::unique_ptr<const FittedLight> light;
  Witness witness;
};

/// Magnitudes of one moment as a witness of the air. An error of 0.02 mag of the computation is added
/// to each of theirs.
///
/// Given   moon             its light as FittedLight takes it, its map and photometry
///         sky              of that moment
///         of_one_instant   their own instants are not looked at
/// Throws  Error            when no eclipse is under way
MagnitudeWitness witness_of(const MoonRequest& moon, const almanac::SkyState& sky,
                            const std::vector<MeasuredMagnitude>& of_one_instant,
                            const algebra::Progress& progress = {});

}  // namespace coppermoon::uses
