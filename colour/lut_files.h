// SPDX-License-Identifier: MIT
#pragma once

#include <OpenColorIO/OpenColorIO.h>

namespace coppermoon::colour {

/// Refuses a configuration that names a look-up table which is no regular file, or which names such a file in
/// its turn, as CTF can: to read a pipe would take for ever.
///
/// Throws  Error  with the file's name; where more than 16 files name one another
void require_regular_luts(const OCIO_NAMESPACE::Config& config);

/// Refuses look-up tables with an entry that is infinite or no number, of which OpenColorIO makes some
/// grey.
///
/// Throws  Error  with the file's name, the line and what stands there
void require_finite_luts(const OCIO_NAMESPACE::Processor& processor);

}  // namespace coppermoon::colour
