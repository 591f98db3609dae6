// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "uses/fit/compared_night.h"

namespace coppermoon::uses {

/// Writes light by distance from the shadow's axis, over full sunlight: measured, and of the best air.
///
/// Given   file    ends in .csv: lines of night, distance_km, channel, light, error (relative), model; or in
///                 .png, .svg or .pdf: a plot
///         nights  by camera and eclipse
/// Throws  Error   with the file's name: another ending; as write_plot
void write_measured_light(const std::filesystem::path& file,
                          std::span<const std::vector<MeasuredLight>> nights);

/// Refuses a file of another ending, or in a place where none can be written.
///
/// Throws  Error   as write_measured_light
void require_light_file(const std::filesystem::path& file);

}  // namespace coppermoon::uses
