// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "files/handle.h"

namespace coppermoon::files {

/// Prepares the standard streams at the start of a program. If a stream is closed, its number is reserved, so that no
/// file opened later is mistaken for it; using the stream still fails. If stderr's reader closes it, messages are lost,
/// but the program continues. Exceeding the limit on file sizes becomes an ordinary error instead of a signal.
void prepare_standard_streams();

/// Returns the status for main to return. On Windows, flushes all streams and ends the program at once instead, because
/// the threads of some image libraries would wait for each other for ever.
int end_program(int status);

/// Whether stderr is a terminal.
bool errors_on_terminal();

/// Writes to stderr without allocating memory.
void say_at_once(std::string_view words);

/// Discards everything that is written to stderr, even by libraries, until hear_errors is called.
///
/// Returned  the previous stderr, to be passed to hear_errors
[[nodiscard]] Handle silence_errors();

/// Restores the stderr that silence_errors returned.
void hear_errors(const Handle& before);

}  // namespace coppermoon::files
