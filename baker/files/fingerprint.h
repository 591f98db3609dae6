// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

namespace coppermoon::files {

/// 64 bits that tell two texts apart unless someone means them not to: the same on every machine.
///
/// Source  FarmHash's Fingerprint64, by OpenImageIO
std::uint64_t fingerprint(std::string_view bytes);

}  // namespace coppermoon::files
