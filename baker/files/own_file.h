// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace coppermoon::files {

/// A text with its fingerprint appended as a comment on the last line. The fingerprint reveals later changes.
///
/// Given  text     complete lines
///        comment  what starts a comment in the text's language, such as "//"
///        end      what ends the comment, such as " -->"; empty if comments end with the line
std::string stamped(std::string_view text, std::string_view comment, std::string_view end = {});

/// Whether a file ends with the fingerprint of its text; false for a link.
bool is_stamped(const std::filesystem::path& file);

/// Throws if a path that the program itself chose is a link. Paths that the user gave may be links.
///
/// Throws  Error
void require_no_link(const std::filesystem::path& path);

/// Error message for a file that must not be overwritten, because it is not as this program wrote it.
std::string not_as_written(const std::filesystem::path& file);

/// Throws if a file to be overwritten has no fingerprint or was changed since it got one. A missing file is accepted.
///
/// Throws  Error  also if the path is a link
void require_stamped(const std::filesystem::path& file);

}  // namespace coppermoon::files
