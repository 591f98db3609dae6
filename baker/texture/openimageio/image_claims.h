// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

namespace coppermoon::texture {

/// Refuses a value above the most allowed: one line with the path.
void require_within(const std::filesystem::path& path, std::string_view what, double value,
                    double most);

/// Most numbers (texels by channels) that a file of its size may hold: most_numbers_of_any_file,
/// most_numbers_a_byte.
double most_numbers_in(const std::filesystem::path& path);

/// Refuses a picture of more numbers (texels by channels) than most_numbers or most_numbers_in.
void require_numbers(const std::filesystem::path& path, double numbers);

/// Refuses an OpenEXR, PNG, JPEG or GIF file whose claims are harmful before its reader finds them out.
///
/// OpenEXR and PNG: attributes or chunks longer than the file, for which the readers ask for up to 2 GB and clear it.
/// OpenEXR: a window of more than most_texels_a_side, a tile of more than most_numbers_of_any_file, and a channel, in
/// any part, whose pixel type OpenEXR does not have, at which OpenImageIO 2.4.7 aborts. JPEG and GIF: a picture that
/// require_numbers refuses, for which the readers make room when they open the file; of a GIF also one of 2^31 numbers
/// or more, which OpenImageIO 2.4.7 counts in an int.
///
/// Given   format  "openexr", "png", "jpeg", "gif"; of any other nothing is refused
/// Throws  Error   one line with the path, the attribute's or chunk's name, and its bytes, or with the
///                 channel's name and pixel type, or with the picture's numbers and those allowed
/// Omits   all that the readers find out without such harm
/// Source  OpenEXR File Layout (openexr.com): magic number, version, attributes as name, type, size;
///         PNG (ISO/IEC 15948), 5.3: chunks as length, type, data, CRC; JPEG (ITU-T T.81), B.1 and B.2.2: markers,
///         frame header; GIF89a, 18: logical screen descriptor
void require_honest_claims(const std::filesystem::path& path, std::string_view format);

}  // namespace coppermoon::texture
