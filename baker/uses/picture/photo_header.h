// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

namespace coppermoon::uses {

/// Strings in a photograph's EXIF and XMP, by the name of the tag, such as {"ExposureTime", "1/30"}. If both have a
/// tag, the string is EXIF's. A list has blanks or commas between its values. Of the maker's notes it has Nikon's
/// WB_RBLevels and Canon's ColorData.
///
/// Returned  empty for a file that has neither, or is of a kind that has none (OpenEXR, FITS)
using PhotoHeader = std::map<std::string, std::string, std::less<>>;
PhotoHeader photo_header(const std::string& photo);

/// The first number in a header's string, such as "5.6", "1/30" or "800, 0"; nothing if it does not begin with one.
std::optional<double> first_number(const std::string& text);

}  // namespace coppermoon::uses
