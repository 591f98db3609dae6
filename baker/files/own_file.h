// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace coppermoon::files {

/// Text with its fingerprint appended in a comment on the last line, which reveals later changes.
///
/// Given  text     complete lines
///        comment  start of a comment in the text's language, such as "//"
///        end      end of a comment, such as " -->", if the end of the line does not end it
std::string stamped(std::string_view text, std::string_view comment, std::string_view end = {});

/// Whether a file ends with its own fingerprint; false for a link.
bool is_stamped(const std::filesystem::path& file);

/// Refuses a link under a name that the program chose. Links that the user named are followed.
///
/// Throws  Error
void require_no_link(const std::filesystem::path& path);

/// Error message for a file that would be overwritten although this program did not write it.
std::string not_as_written(const std::filesystem::path& file);

/// Refuses to overwrite a file that is not stamped or has changed since it was. A missing file is accepted.
///
/// Throws  Error  also for a link
void require_stamped(const std::filesystem::path& file);

}  // namespace coppermoon::files
