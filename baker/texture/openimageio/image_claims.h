// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

namespace coppermoon::texture {

/// Refuses a value above the maximum, with a one-line error that names the file.
void require_within(const std::filesystem::path& path, std::string_view what, double value,
                    double most);

/// The largest count of numbers (texels times channels) that a file of this size may hold, according to
/// most_numbers_of_any_file and most_numbers_a_byte.
double most_numbers_in(const std::filesystem::path& path);

/// Refuses a picture with more numbers (texels times channels) than most_numbers or most_numbers_in allow.
void require_numbers(const std::filesystem::path& path, double numbers);

/// Refuses an untrusted file whose header would do harm before its reader notices.
///
/// Without this check, a downloaded file of 400 bytes can do this (OpenImageIO 2.4.7 on Debian 12):
///   OpenEXR  a string or a vector of numbers longer than the file: 2 GB are allocated and cleared, 13 s; a channel in
///            a part of unknown type, with a pixel type that OpenEXR does not have: the program aborts
///   PNG      a chunk longer than the file: 2.2 GB, 7 s
///   JPEG     a progressive picture of 60 000 x 60 000: 21 GB for the whole picture, when the file is opened
///   GIF      a screen of 23 000 x 23 000: 2.1 GB when the file is opened; a larger one: an unexpected exception
///
/// Given   format  "openexr", "png", "jpeg" or "gif"; files in any other format pass
/// Throws  Error   one line with the path and either the attribute's or chunk's name and size in bytes, the channel's
///                 name and pixel type, or the picture's count of numbers and the limit
/// Omits   whatever the readers detect without such harm
/// Source  OpenEXR File Layout (openexr.com): magic number, version, attributes as name, type, size; PNG (ISO/IEC
///         15948), 5.3: chunks as length, type, data, CRC; JPEG (ITU-T T.81), B.1 and B.2.2: markers, frame header;
///         GIF89a, 18: logical screen descriptor
void require_honest_claims(const std::filesystem::path& path, std::string_view format);

}  // namespace coppermoon::texture
