// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "texture/image.h"
#include "uses/fit/fit.h"

namespace coppermoon::verbs::of_fit {

/// What a command line of `fit` says.
struct Options {
  std::vector<std::string> photos, outputs;
  std::string instants, times, isos, magnitudes;
  std::string zone;  ///< time zone of the cameras' clocks; if empty, taken from the headers
  std::optional<double> clock_error_min;
  texture::Coding coding = texture::Coding::as_file_says;
  std::optional<double> f_number;
  uses::FitRequest request;  ///< request for the fit, still without photographs and magnitudes
  bool despite_misfit = false, misfits = false, json = false;
};

/// Request for the fit, and further information about the photographs for the report.
struct Input {
  uses::FitRequest request;
  std::vector<std::string> instants;
  std::vector<std::string> zones{};             ///< time zones of the photographs; "" if unknown
  std::vector<uses::ReadPhotograph> undated{};  ///< photographs without a date in their headers
};

/// Reads the times of the photographs, as given or from their headers.
///
/// Throws  Error  when a time, a number or the file of magnitudes is not valid, or no photograph's header has a date
Input input_of(const Options& options);

}  // namespace coppermoon::verbs::of_fit
