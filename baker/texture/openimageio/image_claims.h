// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

namespace coppermoon::texture {

/// Refuses an OpenEXR or PNG file that claims attributes or chunks longer than itself: their readers
/// ask for that memory, up to 2 GB, and clear it before they find out. A window of more than
/// most_texels_a_side, and a tile of more than most_numbers_of_any_file, are refused with them. So is a
/// channel whose pixel type OpenEXR does not have, in any part: at it OpenImageIO 2.4.7 aborts.
///
/// Given   format  "openexr", "png"; of any other nothing is refused
/// Omits   all that the readers find out without such harm
/// Throws  Error   one line with the path, the attribute's or chunk's name, and its bytes,
///                 or with the channel's name and pixel type
/// Source  OpenEXR File Layout (openexr.com): magic number, version, attributes as name, type, size;
///         PNG (ISO/IEC 15948), 5.3: chunks as length, type, data, CRC
void require_honest_claims(const std::filesystem::path& path, std::string_view format);

}  // namespace coppermoon::texture
