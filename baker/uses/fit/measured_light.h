// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "uses/fit/compared_night.h"

namespace coppermoon::uses {

/// Writes light by distance from the shadow's axis, over full sunlight: what photographs measured, and what
/// the air that explains them best has.
///
/// Given   file    ends in .csv: lines of night, distance_km, channel, light, error (relative), model; or in
///                 .png, .svg or .pdf: a plot
///         nights  each camera's and eclipse's
/// Throws  Error   with the file's name for another ending; as write_plot
void write_measured_light(const std::filesystem::path& file,
                          std::span<const std::vector<MeasuredLight>> nights);

/// Refuses a file of another ending, or where none can be put.
///
/// Throws  Error
void require_light_file(const std::filesystem::path& file);

}  // namespace coppermoon::uses
