// SPDX-License-Identifier: MIT
#pragma once

#include <OpenColorIO/OpenColorIO.h>

namespace coppermoon::colour {

/// Refuses a configuration with a look-up table that is no regular file, or that names such a file (CTF): a pipe
/// would be read for ever.
///
/// Throws  Error  with the file's name; where more than 16 files name one another
void require_regular_luts(const OCIO_NAMESPACE::Config& config);

/// Refuses look-up tables with an infinite or NaN entry, which OpenColorIO turns into some grey.
///
/// Throws  Error  with the file's name, the line and the entry
void require_finite_luts(const OCIO_NAMESPACE::Processor& processor);

}  // namespace coppermoon::colour
