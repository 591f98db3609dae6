// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>

#include "uses/fit/binned_photograph.h"
#include "uses/fit/fit.h"

namespace coppermoon::uses {

/// What was read from a photograph's file, before anything is computed for the moment of the photograph.
struct Reading {
  std::string left_out{};  ///< one-line reason why the photograph cannot be used, or empty
  MoonPart moon{};
  std::array<std::size_t, 2> extent{};     ///< width and height of the whole picture [pixels]
  bool curved = false, edited = false;     ///< see is_curved and is_edited
  std::optional<ClippedAt> clipped_at{};   ///< value in the file that counts as clipped, if not 1
  std::optional<CameraColours> colours{};  ///< camera's colours, if it has its own tone curve
  PhotometricErrors errors{};              ///< all errors except place_error_km
};

/// Whether the request states no coding, and another program may have changed the camera's pixel values (editor_of).
bool is_edited(const EclipsePhotograph& photograph);

/// Whether a photograph's tone curve is fitted, because it is the camera's own or a program has changed it.
bool is_curved(const EclipsePhotograph& photograph);

/// Reads a photograph and finds the Moon in it.
///
/// Given  request  supplies the camera's response and the errors of exposure, colours and weather
Reading reading_of(const FitRequest& request, const EclipsePhotograph& photograph);

}  // namespace coppermoon::uses
