// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "uses/fit/compared_night.h"

namespace coppermoon::uses {

/// Writes light by distance from the shadow's axis, relative to full sunlight: as measured, and for the best air.
///
/// Given   file    a table if it ends in .csv: night, distance_km, channel, light, error (relative), model; a plot
///                 if it ends in .png, .svg or .pdf
///         nights  light for each camera and eclipse
/// Throws  Error   with the file's name, for any other ending; as write_plot
void write_measured_light(const std::filesystem::path& file,
                          std::span<const std::vector<MeasuredLight>> nights);

/// Refuses a file with any other ending, or in a place where no file can be written.
///
/// Throws  Error   as write_measured_light
void require_light_file(const std::filesystem::path& file);

}  // namespace coppermoon::uses
