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

/// Refuses a file, which may be anybody's, whose header does harm before its reader finds it out.
///
/// What a downloaded file of 400 bytes does without (OpenImageIO 2.4.7 on Debian 12):
///   OpenEXR  a text or a vector of numbers longer than the file: 2 GB are asked for and cleared, 13 s; a channel, in a
///            part of unknown type, whose pixel type OpenEXR does not have: the program aborts
///   PNG      a chunk longer than the file: 2.2 GB, 7 s
///   JPEG     a progressive picture of 60 000 x 60 000: room for all of it, 21 GB, when the file is opened
///   GIF      a screen of 23 000 x 23 000: 2.1 GB when the file is opened; a larger one: an exception that is no error
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
