// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

namespace coppermoon::texture {

/// Refuses a value above the given maximum, with a one-line error message that names the file.
void require_within(const std::filesystem::path& path, std::string_view what, double value,
                    double most);

/// Largest number of values (texels times channels) that an image may have, given the size of its file. The limit
/// follows from most_numbers_of_any_file and most_numbers_a_byte.
double most_numbers_in(const std::filesystem::path& path);

/// Refuses a picture with more values (texels times channels) than most_numbers or most_numbers_in allow.
void require_numbers(const std::filesystem::path& path, double numbers);

/// Refuses an untrusted file whose header would do harm before OpenImageIO notices that it is wrong.
///
/// Without this check, a downloaded file of 400 bytes can do this (OpenImageIO 2.4.7 on Debian 12):
///   OpenEXR  a text or vector longer than the file: 2 GB are allocated and cleared in 13 s; an undefined pixel type in
///            a part of unknown type: the program aborts
///   PNG      a chunk longer than the file: 2.2 GB are allocated in 7 s
///   JPEG     a progressive picture of 60 000 x 60 000: 21 GB are allocated on opening
///   GIF      a screen of 23 000 x 23 000: 2.1 GB are allocated on opening; a larger one: an unexpected exception
///
/// Given   format  "openexr", "png", "jpeg" or "gif"; files in any other format pass
/// Throws  Error   in one line: the path, and either the name and size [bytes] of the attribute or chunk, the channel's
///                 name and pixel type, or the picture's number of values and the limit
/// Omits   faults that OpenImageIO's readers detect without such harm
/// Source  OpenEXR File Layout (openexr.com): magic number, version, attributes as name, type, size; PNG (ISO/IEC
///         15948), 5.3: chunks as length, type, data, CRC; JPEG (ITU-T T.81), B.1 and B.2.2: markers, frame header;
///         GIF89a, 18: logical screen descriptor
void require_honest_claims(const std::filesystem::path& path, std::string_view format);

}  // namespace coppermoon::texture
