// SPDX-License-Identifier: MIT
#pragma once

#include <OpenColorIO/OpenColorIO.h>

#include <filesystem>

namespace coppermoon::colour {

/// Refuses a file that OpenColorIO would read for ever: one that is no regular file, or whose YAML repeats
/// its parts by more than 16 aliases, each of which may double what it holds.
///
/// Throws  Error  with the file's name
void require_readable(const std::filesystem::path& config);

/// Refuses a configuration whose colour spaces, looks, views and named transforms lead back to
/// themselves, or on without a reasonable end: OpenColorIO would follow them until its stack is full.
///
/// Throws  Error  names the first that does: one that is made of itself, of more than 64 others one
///                within the other, or of more than 4096 transforms in all
void require_end(const OCIO_NAMESPACE::Config& config);

}  // namespace coppermoon::colour
