// SPDX-License-Identifier: MIT
#pragma once

#include <OpenColorIO/OpenColorIO.h>

#include <filesystem>

namespace coppermoon::colour {

/// Configuration in a file, which may be anybody's: refuses what ends OpenColorIO 2.1, or keeps it busy for ever.
///
/// What a downloaded .ocio does without: a colour space, look, view or view transform that is made of itself fills the
/// stack; thirty that are each made of two of the one before, twenty aliases of YAML that do so, a look-up table that is a
/// pipe or /dev/zero, or a CTF that names one, are read for ever.
///
/// Throws  Error            names the file, or the first thing that is made of itself, of more than 64 others one within
///                          the other, or of more than 4096 transforms in all
///         ocio::Exception  where OpenColorIO cannot read it
OCIO_NAMESPACE::ConstConfigRcPtr guarded_config(const std::filesystem::path& path);

}  // namespace coppermoon::colour
