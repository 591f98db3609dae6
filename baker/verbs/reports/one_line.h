// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace coppermoon::verbs {

/// Whether a text is UTF-8.
///
/// Source  RFC 3629: no longer spelling than needed, no surrogates, nothing above U+10FFFF
bool is_utf8(std::string_view text);

/// Any text, such as a file's name, as one line that a terminal may show: control characters and bytes that are no
/// UTF-8 are escaped, and of more than 2000 bytes the middle is left out.
std::string one_line(std::string_view text);

/// Text in single quotes, one word for a POSIX shell.
std::string in_single_quotes(std::string_view text);

}  // namespace coppermoon::verbs
