// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "uses/fit/compared_night.h"

namespace coppermoon::uses {

/// Writes measured light, and the light computed for the best-fitting air, by distance from the shadow's axis. Both are
/// relative to full sunlight.
///
/// Given   file    if it ends in .csv, a table with columns night, distance_km, channel, light, error (relative) and
///                 model; if it ends in .png, .svg or .pdf, a plot
///         nights  light for each camera and eclipse
/// Throws  Error   with the file's name, for any other ending; otherwise as write_plot
void write_measured_light(const std::filesystem::path& file,
                          std::span<const std::vector<MeasuredLight>> nights);

/// Throws if write_measured_light could not write this file, because of the file's ending or its folder.
void require_light_file(const std::filesystem::path& file);

}  // namespace coppermoon::uses
