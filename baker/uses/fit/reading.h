// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>

#include "uses/fit/binned_photograph.h"
#include "uses/fit/fit.h"

namespace coppermoon::uses {

/// A photograph as its file has it, whatever the moment.
struct Reading {
  std::string left_out{};  ///< reason in one line why it has no Moon; empty: it has one
  MoonPart moon{};
  std::array<std::size_t, 2> extent{};    ///< width and height of the whole picture [pixels]
  bool curved = false;                    ///< by its camera's own tone curve
  std::optional<ClippedAt> clipped_at{};  ///< number that became 1; without: it was 1
  PhotometricErrors errors{};             ///< but for that of its place
};

/// Reads a photograph.
///
/// Given  request  response, and errors of exposure, colours and weather
Reading reading_of(const FitRequest& request, const EclipsePhotograph& photograph);

}  // namespace coppermoon::uses
