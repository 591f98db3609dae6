// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace coppermoon::files {

/// Text with its fingerprint appended as a comment on a last line, which reveals later changes.
///
/// Given  text     whole lines
///        comment  begin of a comment in the text's language, as "//"
///        end      end of the comment where the line's is none: " -->"
std::string stamped(std::string_view text, std::string_view comment, std::string_view end = {});

/// Whether a file ends in its own fingerprint; false for a link.
bool is_stamped(const std::filesystem::path& file);

/// Refuses a link under a name that the program chose; links that the user named are followed.
///
/// Throws  Error
void require_no_link(const std::filesystem::path& path);

/// Error message for a file that is not ours and would be overwritten.
std::string not_as_written(const std::filesystem::path& file);

/// Refuses to overwrite a file that is not stamped, or was changed since. A missing file passes.
///
/// Throws  Error  also for a link
void require_stamped(const std::filesystem::path& file);

}  // namespace coppermoon::files
