// SPDX-License-Identifier: MIT
#pragma once

#include "files/handle.h"

namespace coppermoon::files {

/// Whether a file that another program wrote has its end: a PNG its chunk IEND, a PDF its %%EOF, an SVG its </svg>, and
/// of MP4, MOV and AVIF the boxes end with the file. A file of another kind has it where it is not shorter than 8 bytes.
///
/// Source  PNG (ISO/IEC 15948), PDF (ISO 32000), ISO base media file format (ISO/IEC 14496-12)
bool has_its_end(const Handle& file);

}  // namespace coppermoon::files
