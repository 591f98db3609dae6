// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace coppermoon::files {

/// A text that tells later whether somebody has changed it: its last line is a fingerprint of the
/// lines before, in a comment.
///
/// Given  text     whole lines
///        comment  begins a comment in the text's language, as "//"
///        end      ends it where the line does not: " -->"
std::string stamped(std::string_view text, std::string_view comment, std::string_view end = {});

/// Whether a file ends in its own fingerprint. A link does not count, wherever it leads.
bool is_stamped(const std::filesystem::path& file);

/// Refuses a link where a file or a folder gets its name from us: links are followed only where the
/// user named them.
///
/// Throws  Error
void require_no_link(const std::filesystem::path& path);

/// Error message for a file that is not ours and would be overwritten.
std::string not_as_written(const std::filesystem::path& file);

/// Refuses a file that was not written as `stamped` has it, or was changed since: it would be
/// overwritten. None at all may be there.
///
/// Throws  Error  for a link too
void require_stamped(const std::filesystem::path& file);

}  // namespace coppermoon::files
