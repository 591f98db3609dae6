// SPDX-License-Identifier: MIT
#pragma once

#include <OpenColorIO/OpenColorIO.h>

#include <filesystem>

namespace coppermoon::colour {

/// Reads a configuration from an untrusted file. Refuses one that would crash OpenColorIO 2.1 or keep it busy for ever.
///
/// Without this guard, a downloaded .ocio can do harm. A colour space, look, view or view transform that refers to
/// itself overflows the stack. Reading takes for ever if thirty of these, or twenty YAML aliases, form a chain in which
/// each uses the previous one twice, or if a look-up table is a pipe or /dev/zero, or a CTF file that refers to one.
///
/// Throws  Error            when the configuration is refused. The message names the file, or the first element that
///                          refers to itself, is nested more than 64 deep, or consists of more than 4096 transforms in
///                          all
///         ocio::Exception  when OpenColorIO cannot read the file
OCIO_NAMESPACE::ConstConfigRcPtr guarded_config(const std::filesystem::path& path);

}  // namespace coppermoon::colour
