// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "texture/openimageio/oiio.h"

namespace coppermoon::texture {

/// A reader for FITS images that uses CFITSIO. OpenImageIO's own reader ignores BZERO, BSCALE and BLANK, and is off by
/// one row. A file name is taken literally, without CFITSIO's extended syntax.
///
/// Reads the first header and data unit of a file. It must have two axes, or a third one of length 1 or 3 (red, green
/// and blue). The top row comes first, whichever row ROWORDER says is first in the file. The numbers are light:
///
///     BZERO + BSCALE n      NaN if n is BLANK. Integers with BSCALE 1 are divided by the largest value
///                           of their format, so that unsigned integers become 0 to 1
///
/// Attributes have EXIF's names: time of exposure (EXPTIME, else EXPOSURE) [s], f-number (FOCRATIO), ISO speed
/// (ISOSPEED), date (DATE-OBS, with TIME-OBS if DATE-OBS is only a day). TIMESYS, the time scale of the date, is always
/// present: it is UTC if the file does not state it. INSTRUME, GAIN and DATAMAX are as in the file.
/// coppermoon:clipped_at is DATAMAX, scaled like the numbers above.
///
/// Refuses compressed files, images with other axes or in extensions, mosaics of colour filters (BAYERPAT), and files
/// that end early.
/// Source  FITS Standard 4.0 (2018); TIMESYS: its section 9.2.1
std::unique_ptr<OIIO::ImageInput> fits_input();

}  // namespace coppermoon::texture
