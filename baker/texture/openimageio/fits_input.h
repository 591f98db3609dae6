// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "texture/openimageio/oiio.h"

namespace coppermoon::texture {

/// A reader of FITS images, by CFITSIO: OpenImageIO's own leaves out BZERO, BSCALE and BLANK, and shows every
/// row one place off. A file's name is only a name, whatever CFITSIO's extended syntax would make of it.
///
/// The first unit of a file, of two axes, or of three with one plane or red, green and blue; rows from
/// the top, whichever ROWORDER says is the first. Its numbers are light:
///
///     BZERO + BSCALE n      over the largest that the format holds where integers are counted by ones,
///                           so that unsigned ones are 0 to 1; no number where n is BLANK
///
/// Attributes are those of EXIF: time of exposure (EXPTIME, else EXPOSURE) [s], f-number (FOCRATIO), ISO speed
/// (ISOSPEED), date (DATE-OBS, with TIME-OBS where it is a day alone). TIMESYS, the time scale of the date, is always
/// there, UTC where the file does not say it; INSTRUME, GAIN and DATAMAX are as in the file. coppermoon:clipped_at is
/// DATAMAX in the scale of the numbers that are read.
///
/// Refused are compressed files, other axes, images in extensions, mosaics of a camera's filters (BAYERPAT), and files
/// that end early.
/// Source  FITS Standard 4.0 (2018); TIMESYS: its section 9.2.1
std::unique_ptr<OIIO::ImageInput> fits_input();

}  // namespace coppermoon::texture
