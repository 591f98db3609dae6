// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

namespace coppermoon::files {

/// Memory that the system reports as available to programs [bytes]; 1e9 if it reports none.
double available_memory();

/// Refuses work for which this machine has too little memory, before it begins.
///
/// Given   what   what needs the memory, such as "a.glb"
///         bytes  memory that it needs
/// Throws  Error  giving the memory needed and the memory available
void require_memory(std::string_view what, double bytes);

/// Whether the address space of this process is limited.
bool addresses_are_limited();

/// Whether this process could still reserve this much address space [bytes].
bool has_addresses(std::size_t bytes);

/// Keeps freed memory in this process for reuse: fetching new pages from the system takes a tenth of a texture's time.
void keep_freed_memory();

}  // namespace coppermoon::files
