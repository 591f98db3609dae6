// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace coppermoon::verbs {

/// Whether a text is valid UTF-8.
///
/// Source  RFC 3629: only shortest encodings, no surrogates, nothing above U+10FFFF
bool is_utf8(std::string_view text);

/// Any text, such as a file's name, as one line that is safe to show on a terminal. Control characters and bytes that
/// are not UTF-8 are escaped. If the text exceeds 2000 bytes, its middle is left out.
std::string one_line(std::string_view text);

/// Text in single quotes, as one word for a POSIX shell.
std::string in_single_quotes(std::string_view text);

}  // namespace coppermoon::verbs
