#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes moon_albedo.jpg, the Moon's normal albedo, from the map in Debian 12's package stellarium-data.

Usage: make_moon_albedo.py [moon_4k.jpg] [moon_albedo.jpg]     needs python3-numpy and python3-openimageio

The map is NASA's CGI Moon Kit of 2019, made from images by LRO's cameras (LROC WAC, 643, 566 and 415 nm) at a phase
angle of 60 degrees. The package's copyright file (4.4) names USGS Astrogeology and Clementine, and says that the map is
in the public domain. Its pixel values v, the luminance of red, green and blue, are converted to normal albedo as
docs/textures.md describes for cgi-moon-kit-2019:

    A = (0.16 + 0.24 v)^(2.8/1.56)

The contrast beyond latitude 64 degrees is restored as in surface::with_polar_contrast. The result is converted back to
pixel values by the same expression, and stored as a grey JPEG with the quantisation of the package's file, so that
little is lost a second time. The script prints the error due to the JPEG.
"""
import sys

import numpy
import OpenImageIO as oiio

QUALITY = 92  # of the package's JPEG


def albedo_of(codes):
    """Normal albedo, up to a constant factor, as in surface::kit_2019_albedo."""
    return (0.16 + 0.24 * codes) ** (2.8 / 1.56)


def read(path):
    """Reads the kit's map and converts it to normal albedo, indexed by [row, column]."""
    return albedo_of(oiio.ImageBuf(path).get_pixels(oiio.FLOAT).astype(float) @ [0.2126, 0.7152, 0.0722])


def with_polar_contrast(albedo):
    """The map with its contrast beyond latitude 64 degrees restored."""
    rows = albedo.shape[0]
    latitude = abs(90 - (numpy.arange(rows) + 0.5) * 180 / rows)
    fade = 1 + (0.37 - 1) * numpy.clip((latitude - 64) / 6, 0, 1)
    mean = albedo.mean(axis=1, keepdims=True)
    return mean * (albedo / mean) ** (1 / fade[:, None])


def store(albedo, path):
    """Writes an albedo map to an image file, and returns the map that is read back from it."""
    codes = numpy.clip((albedo ** (1.56 / 2.8) - 0.16) / 0.24, 0, 1)
    image = oiio.ImageBuf(oiio.ImageSpec(albedo.shape[1], albedo.shape[0], 1, oiio.UINT8))
    image.specmod().attribute("Compression", f"jpeg:{QUALITY}")
    image.specmod().attribute("ImageDescription",
                              "Normal albedo of the Moon, coded as NASA's CGI Moon Kit of 2019 (public domain)")
    image.set_pixels(oiio.ROI.All, numpy.rint(255 * codes)[:, :, None].astype(numpy.uint8))
    if not image.write(path):
        sys.exit(image.geterror())
    return albedo_of(oiio.ImageBuf(path).get_pixels(oiio.FLOAT)[:, :, 0].astype(float))


def main():
    usual = ["/usr/share/stellarium/textures/moon_4k.jpg", "moon_albedo.jpg"]
    source, made = sys.argv[1:3] + usual[len(sys.argv) - 1:]
    albedo = with_polar_contrast(read(source))
    rows, columns = albedo.shape
    error = store(albedo, made) / albedo - 1
    latitude = 90 - (numpy.arange(rows) + 0.5) * 180 / rows
    for name, there in (("all", latitude < 90), ("within 64 degrees of latitude", abs(latitude) < 64)):
        area = numpy.cos(numpy.radians(latitude[there]))[:, None]
        rms = numpy.sqrt((area * error[there] ** 2).sum() / area.sum() / columns)
        print(f"error of storing, {name}: {100 * rms:.2f} % rms, {100 * abs(error[there]).max():.1f} % at most")
    print(f"cut, for they are brighter than the last code: {(albedo > albedo_of(1)).sum()} texels")


if __name__ == "__main__":
    main()
