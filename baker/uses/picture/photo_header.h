// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

namespace coppermoon::uses {

/// Strings from a photograph's EXIF and XMP, by the name of the tag, such as {"ExposureTime", "1/30"}. If both have a
/// tag, EXIF's string is used. Lists have blanks or commas between their values. From the maker notes, only Nikon's
/// WB_RBLevels and Canon's ColorData are included. FileWidth and FileHeight are the size of the file's picture [pixels].
///
/// Returned  empty for a file in a format that has neither EXIF nor XMP (OpenEXR, FITS)
using PhotoHeader = std::map<std::string, std::string, std::less<>>;
PhotoHeader photo_header(const std::string& photo);

/// The first number in a header's string, such as "5.6", "1/30" or "800, 0"; nothing if it does not begin with one.
std::optional<double> first_number(const std::string& text);

}  // namespace coppermoon::uses
