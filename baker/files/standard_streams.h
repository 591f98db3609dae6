// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "files/handle.h"

namespace coppermoon::files {

/// Prepares the standard streams of a program that begins. Closed ones are held, so that no file opened later is written
/// into in their place; using them still fails. Writing to stderr never fails: who does not hear what is said beside
/// the results loses nothing else. A file that grows too large is an error like any other.
void prepare_standard_streams();

/// Whether stderr is a terminal.
bool errors_on_terminal();

/// Writes to stderr without asking for memory.
void say_at_once(std::string_view words);

/// Sends what any code writes to stderr nowhere.
///
/// Returned  what it was before, for hear_errors
[[nodiscard]] Handle silence_errors();

/// Makes stderr what it was.
void hear_errors(const Handle& before);

}  // namespace coppermoon::files
