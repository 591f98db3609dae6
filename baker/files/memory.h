// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

namespace coppermoon::files {

/// Memory available to programs [bytes], as the system reports it; 1e9 if the system does not report it.
double available_memory();

/// Throws, before a piece of work begins, if the work needs more memory than is available.
///
/// Given   what   what needs the memory, such as "a.glb"
///         bytes  memory needed [bytes]
/// Throws  Error  if too little is available; the message gives the memory needed and the memory available
void require_memory(std::string_view what, double bytes);

/// Whether the address space of this process is limited.
bool addresses_are_limited();

/// Whether this process could still reserve the given amount of address space.
bool has_addresses(std::size_t bytes);

/// Keeps freed memory for reuse, because fetching new pages takes a tenth of the time needed to bake a texture.
void keep_freed_memory();

}  // namespace coppermoon::files
