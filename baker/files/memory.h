// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
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

/// Whether this process may take only so many addresses.
bool addresses_are_limited();

/// Whether the system would give this process so many addresses [bytes].
bool has_addresses(std::size_t bytes);

/// Keeps memory that is freed for this process's next use: pages of the system cost a tenth of a texture's time.
void keep_freed_memory();

}  // namespace coppermoon::files
