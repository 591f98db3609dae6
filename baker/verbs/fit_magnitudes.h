// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "verbs/fit_air.h"
#include "verbs/moon_options.h"

namespace coppermoon::verbs {

/// The whole Moon's brightness in a band, as someone measured it: from the Earth's centre, above the
/// air.
struct MeasuredMagnitude {
  std::string instant, band;  ///< band: B, V or R
  double magnitude, error = 0.1;
};

/// Reads a list: comma-separated, lines that begin with # left out, first the names of the columns
/// instant, band, magnitude and, if the measurer tells, error, 0.001 to 0.99 (without, or empty: 0.1).
/// Decimal points; a byte-order mark and any line ends.
///
/// Throws  Error  with the line, of what is no such list: a column twice or of another name, a line of
///                more or fewer columns than the first, as one with decimal commas has
std::vector<MeasuredMagnitude> read_magnitudes(const std::string& file);

/// Magnitudes of one moment, and the light they are of.
struct MagnitudeWitness {
  std::unique_ptr<const FittedLight> light;
  Witness witness;
};

/// Those of one instant; that the computation errs by 0.02 mag is added to each error.
MagnitudeWitness witness_of(const MoonOptions& moon,
                            const std::vector<MeasuredMagnitude>& of_one_instant);

}  // namespace coppermoon::verbs
