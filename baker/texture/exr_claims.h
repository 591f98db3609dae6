// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace coppermoon::texture {

/// Refuses an OpenEXR file whose header claims attributes that the file cannot hold: OpenEXR asks for
/// their memory, up to 2 GB each, before it finds out.
///
/// Given   path   of a file that begins as OpenEXR's do
/// Omits   all that OpenEXR itself finds out without such harm
/// Throws  Error  one line with the path and the attribute's name
/// Source  OpenEXR File Layout (openexr.com): magic number, version, attributes as name, type, size
void require_honest_exr(const std::filesystem::path& path);

}  // namespace coppermoon::texture
