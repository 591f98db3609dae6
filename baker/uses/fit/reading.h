// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>

#include "uses/fit/binned_photograph.h"
#include "uses/fit/fit.h"

namespace coppermoon::uses {

/// What a photograph's file contains, whatever its moment.
struct Reading {
  std::string left_out{};  ///< why no Moon was read, in one line; empty if one was
  MoonPart moon{};
  std::array<std::size_t, 2> extent{};    ///< width and height of the whole picture [pixels]
  bool curved = false;                    ///< whether it has its camera's own tone curve
  std::optional<ClippedAt> clipped_at{};  ///< number in the file that became 1, if not 1 itself
  PhotometricErrors errors{};             ///< all but the error of its place
};

/// Reads a photograph.
///
/// Given  request  for its response and its errors of exposure, colours and weather
Reading reading_of(const FitRequest& request, const EclipsePhotograph& photograph);

}  // namespace coppermoon::uses
