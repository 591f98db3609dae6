// SPDX-License-Identifier: MIT
#pragma once

#include <OpenColorIO/OpenColorIO.h>

#include <filesystem>

namespace coppermoon::colour {

/// Reads a configuration from an untrusted file, refusing what would crash OpenColorIO 2.1 or keep it busy for ever.
///
/// Without this guard, a downloaded .ocio can do harm. A colour space, look, view or view transform that refers to
/// itself overflows the stack. Reading never ends for thirty of them that each use the one before twice, for twenty
/// YAML aliases that do so, or for a look-up table that is a pipe or /dev/zero, or a CTF that names one.
///
/// Throws  Error            names the file, or the first element that refers to itself, is nested more than 64 deep, or
///                          consists of more than 4096 transforms in all
///         ocio::Exception  when OpenColorIO cannot read the file
OCIO_NAMESPACE::ConstConfigRcPtr guarded_config(const std::filesystem::path& path);

}  // namespace coppermoon::colour
