// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace coppermoon::verbs {

/// Whether a string is valid UTF-8.
///
/// Source  RFC 3629, which forbids overlong encodings, surrogates and anything above U+10FFFF
bool is_utf8(std::string_view text);

/// Makes text, such as a file name, safe to show on a terminal as one line. Control characters and bytes that are not
/// UTF-8 are escaped. If the text is longer than 2000 bytes, its middle is left out.
std::string one_line(std::string_view text);

/// Quotes text with single quotes so that a POSIX shell takes it as one word.
std::string in_single_quotes(std::string_view text);

}  // namespace coppermoon::verbs
