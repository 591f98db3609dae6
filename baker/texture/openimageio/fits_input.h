// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "texture/openimageio/oiio.h"

namespace coppermoon::texture {

/// A reader for FITS images that uses CFITSIO. OpenImageIO's own reader ignores BZERO, BSCALE and BLANK, and shifts
/// every row by one. A file name is taken literally, without CFITSIO's extended syntax.
///
/// Reads the first unit of a file, which must have two axes, or three for one plane or for red, green and blue. Rows
/// come from the top, whichever ROWORDER says is first. The numbers are light:
///
///     BZERO + BSCALE n      for integers in steps of one, divided by the format's largest value,
///                           so that unsigned ones are 0 to 1; not a number if n is BLANK
///
/// Attributes have EXIF's names: time of exposure (EXPTIME, else EXPOSURE) [s], f-number (FOCRATIO), ISO speed
/// (ISOSPEED), date (DATE-OBS, with TIME-OBS if DATE-OBS is only a day). TIMESYS, the time scale of the date, is always
/// present: UTC if the file does not state it. INSTRUME, GAIN and DATAMAX are as in the file. coppermoon:clipped_at is
/// DATAMAX on the scale of the numbers that are read.
///
/// Refuses compressed files, other axes, images in extensions, mosaics of a camera's filters (BAYERPAT), and files that
/// end early.
/// Source  FITS Standard 4.0 (2018); TIMESYS: its section 9.2.1
std::unique_ptr<OIIO::ImageInput> fits_input();

}  // namespace coppermoon::texture
