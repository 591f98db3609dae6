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
  bool curved = false, edited = false;     ///< as is_curved and is_edited say
  std::optional<ClippedAt> clipped_at{};   ///< value in the file that counts as 1, if not 1
  std::optional<CameraColours> colours{};  ///< of the camera, if it has its own tone curve
  PhotometricErrors errors{};              ///< without place_error_km
};

/// Whether a program may have changed the numbers that its camera wrote (editor_of), and nothing is told about them.
bool is_edited(const EclipsePhotograph& photograph);

/// Whether a photograph's tone curve is fitted: its camera's own, or one that a program changed.
bool is_curved(const EclipsePhotograph& photograph);

/// Reads a photograph and finds the Moon in it.
///
/// Given  request  supplies the camera's response and the errors of exposure, colours and weather
Reading reading_of(const FitRequest& request, const EclipsePhotograph& photograph);

}  // namespace coppermoon::uses
