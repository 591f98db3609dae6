// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>

#include "uses/fit/binned_photograph.h"
#include "uses/fit/fit.h"

namespace coppermoon::uses {

/// What was read from a photograph's file, before anything is computed for its moment.
struct Reading {
  std::string left_out{};  ///< why no Moon was read, in one line; empty if one was found
  MoonPart moon{};
  std::array<std::size_t, 2> extent{};     ///< width and height of the whole picture [pixels]
  bool curved = false;                     ///< whether its tone curve is its camera's own
  std::optional<ClippedAt> clipped_at{};   ///< value in the file that counts as 1, if not 1
  std::optional<CameraColours> colours{};  ///< of the camera, if it has its own tone curve
  PhotometricErrors errors{};              ///< without place_error_km
};

/// Reads a photograph and finds the Moon in it.
///
/// Given  request  supplies the camera's response and the errors of exposure, colours and weather
Reading reading_of(const FitRequest& request, const EclipsePhotograph& photograph);

}  // namespace coppermoon::uses
