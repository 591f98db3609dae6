// SPDX-License-Identifier: MIT
#pragma once

#include "files/handle.h"

namespace coppermoon::files {

/// Whether a file that another program wrote is complete. A PNG must end with the chunk IEND, a PDF with %%EOF, and an
/// SVG with </svg>; the last box of an MP4, MOV or AVIF must end where the file ends. All files need at least 8 bytes.
///
/// Source  PNG (ISO/IEC 15948), PDF (ISO 32000), ISO base media file format (ISO/IEC 14496-12)
bool has_its_end(const Handle& file);

}  // namespace coppermoon::files
