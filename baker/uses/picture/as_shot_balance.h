// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>

namespace coppermoon::uses {

/// White-balance gains that a camera applied to its red, green and blue channels, relative to the gain for green.
///
/// The gains are read from the maker notes of Canon and Nikon cameras.
///
/// Returned  nothing for other cameras, for files without maker notes, and for gains outside 0.1 to 10
/// Source    ExifTool, lib/Image/ExifTool/Canon.pm: ColorData1 to 12; Exiv2: Exif.Nikon3.WB_RBLevels
std::optional<std::array<double, 3>> as_shot_balance(const std::string& photo);

}  // namespace coppermoon::uses
