// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "files/handle.h"

namespace coppermoon::files {

/// Prepares the standard streams at the start of a program. The numbers of closed streams are reserved, so that no
/// file opened later is mistaken for one of them; using them still fails. Writing to stderr never ends the program:
/// a reader who closes it loses only the messages. A file that grows too large is an error like any other.
void prepare_standard_streams();

/// Whether stderr is a terminal.
bool errors_on_terminal();

/// Writes to stderr without allocating memory.
void say_at_once(std::string_view words);

/// Discards whatever any code writes to stderr.
///
/// Returned  the previous stderr, for hear_errors
[[nodiscard]] Handle silence_errors();

/// Restores stderr after silence_errors.
void hear_errors(const Handle& before);

}  // namespace coppermoon::files
