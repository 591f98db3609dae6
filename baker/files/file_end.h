// SPDX-License-Identifier: MIT
#pragma once

#include "files/handle.h"

namespace coppermoon::files {

/// Whether a file that another program wrote is complete: a PNG ends with the chunk IEND, a PDF with %%EOF, an SVG
/// with </svg>; in MP4, MOV and AVIF the last box ends with the file. Any other file needs at least 8 bytes.
///
/// Source  PNG (ISO/IEC 15948), PDF (ISO 32000), ISO base media file format (ISO/IEC 14496-12)
bool has_its_end(const Handle& file);

}  // namespace coppermoon::files
