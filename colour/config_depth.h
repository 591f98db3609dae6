// SPDX-License-Identifier: MIT
#pragma once

#include <OpenColorIO/OpenColorIO.h>

namespace coppermoon::colour {

/// Refuses a configuration whose colour spaces, looks, views and named transforms lead back to themselves, or
/// on without a reasonable end: OpenColorIO would follow them until its stack is full.
///
/// Throws  Error  names the first that does: one that is made of itself, of more than 64 others one
///                within the other, or of more than 4096 transforms in all
void require_end(const OCIO_NAMESPACE::Config& config);

}  // namespace coppermoon::colour
