// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "uses/film/film.h"

namespace coppermoon::uses {

/// Brightness of the whole disc in a frame, above the air, from the Earth's centre.
struct CurvePoint {
  std::size_t frame;
  almanac::Instant when;
  double V_magnitude;  ///< apparent; infinite when nothing is lit
  double mean_luminance_cd_m2;
};

/// Light curve of some frames, from the film's own light.
///
/// Given     frames  increasing
/// Accuracy  5e-4 mag, and as much of luminance, from brightness_of, which simulates each moment on
///           twice as many rows
/// Throws    Error   as normal_albedo
std::vector<CurvePoint> light_curve(const Film& film, const std::vector<std::size_t>& frames);

/// Writes a curve as a table in .csv, or as a plot with the eclipse's contacts in .png, .svg or .pdf.
///
/// Throws  Error  for another ending; as write_plot
void write_curve(const std::filesystem::path& path, const eclipse::Eclipse& eclipse,
                 const std::vector<CurvePoint>& curve);

/// Refuses the name of a file that no curve is written to.
///
/// Throws  Error  for another ending than write_curve knows
void require_curve_ending(const std::filesystem::path& path);

}  // namespace coppermoon::uses
