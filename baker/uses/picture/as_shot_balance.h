// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>

namespace coppermoon::uses {

/// Gains of red, green and blue that a camera applied to its channels to make a photograph white, green's being 1.
///
/// The gains come from the maker's notes that Canon and Nikon write.
///
/// Returned  nothing for other cameras, for files without these notes, and for gains outside 0.1 to 10
/// Source    ExifTool, lib/Image/ExifTool/Canon.pm: ColorData1 to 12; Exiv2: Exif.Nikon3.WB_RBLevels
std::optional<std::array<double, 3>> as_shot_balance(const std::string& photo);

}  // namespace coppermoon::uses
