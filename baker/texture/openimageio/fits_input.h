// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "texture/openimageio/oiio.h"

namespace coppermoon::texture {

/// A reader of FITS images: OpenImageIO's own leaves out BZERO, BSCALE and BLANK, and shows every row
/// one place off.
///
/// The first unit of a file, of two axes, or of three with one plane or red, green and blue; rows from
/// the top, whichever ROWORDER says is the first. Its numbers are light:
///
///     BZERO + BSCALE n      over the largest that the format holds where integers are counted by ones,
///                           so that unsigned ones are 0 to 1; no number where n is BLANK
///
/// Refused are other axes, images in extensions, mosaics of a camera's filters (BAYERPAT), and files
/// that end early.
/// Source  FITS Standard 4.0 (2018)
std::unique_ptr<OIIO::ImageInput> fits_input();

}  // namespace coppermoon::texture
