// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace coppermoon::files {

/// Memory that programs may still take [bytes], as the system says; 1e9 where it says nothing.
double available_memory();

/// Refuses work for which this machine has too little memory, before it begins.
///
/// Given   what   needs it, as "a.glb"
///         bytes  that it will take
/// Throws  Error  with both numbers
void require_memory(std::string_view what, double bytes);

}  // namespace coppermoon::files
