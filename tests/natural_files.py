#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Files as strangers have them, made from moon.png and moon.exr of the folder that this runs in."""

import numpy
import OpenImageIO as oiio

moon = oiio.ImageBuf("moon.png")
pixels = moon.get_pixels(oiio.FLOAT)[..., :3]
TAKEN = {"Make": "Canon", "Model": "Canon EOS 600D", "Exif:DateTimeOriginal": "2018:07:27 18:54:00"}


def write(name, values, channels=("R", "G", "B"), **attributes):
    values = numpy.ascontiguousarray(values, numpy.float32)
    spec = oiio.ImageSpec(values.shape[1], values.shape[0], values.shape[2], attributes.pop("kind", oiio.UINT8))
    spec.channelnames = channels
    for key, value in attributes.items():
        if isinstance(value, tuple):
            spec.attribute(key, *value)
        else:
            spec.attribute(key, value)
    out = oiio.ImageOutput.create(name)
    if not (out and out.open(name, spec) and out.write_image(values) and out.close()):
        raise SystemExit(f"{name}: {oiio.geterror()}")


def photograph(name, **attributes):
    write(name, pixels, **{"CompressionQuality": 95, **TAKEN, **attributes})


def fits(name, *cards):
    """A float FITS in a sensor's counts, a plane for each colour, its first row at the bottom."""
    light = numpy.where(pixels <= 0.04045, pixels / 12.92, ((pixels + 0.055) / 1.055) ** 2.4)[..., :3]
    counts = 300 + 29000 * numpy.moveaxis(light[::-1], -1, 0)
    rows = ["SIMPLE  =                    T", "BITPIX  =                  -32", "NAXIS   =                    3",
            f"NAXIS1  = {counts.shape[2]:20d}", f"NAXIS2  = {counts.shape[1]:20d}", f"NAXIS3  = {counts.shape[0]:20d}",
            "DATE-OBS= '2018-07-27T18:54:17'", "EXPTIME =              0.03125", "GAIN    =                  100",
            "INSTRUME= 'a camera'", *cards, "END"]
    header = "".join(row.ljust(80) for row in rows)
    data = counts.astype(">f4").tobytes()
    with open(name, "wb") as file:
        file.write(header.ljust(-len(header) // 2880 * -2880).encode() + data + bytes(-len(data) % 2880))


photograph("dt.jpg", Software="darktable 4.2.1", ExposureTime=1 / 30, FNumber=8.0)
photograph("apex.jpg", **{"Exif:ShutterSpeedValue": 5.0, "Exif:ApertureValue": 6.0, "Exif:PhotographicSensitivity": 800})
photograph("odd.jpg", **{"Exif:OffsetTimeOriginal": "+14:60", "ExposureTime": 1 / 30, "FNumber": 8.0})
fits("m.fits")
fits("d.fits", "DATAMAX =                60000")
write("b.bmp", pixels)
write("t.tif", pixels)
for named, name in (("b.bmp", "b.png"), ("t.tif", "t.CR2")):
    open(name, "wb").write(open(named, "rb").read())
light = oiio.ImageBuf("frame.exr").get_pixels(oiio.FLOAT)[..., :3]
write("bl.exr", light, tuple(f"ViewLayer.Combined.{c}" for c in "RGB"), kind=oiio.HALF)
write("two.exr", numpy.concatenate([light, light], axis=2), tuple(f"{layer}.{c}" for layer in "AB" for c in "RGB"), kind=oiio.HALF)
rogue = numpy.full((64, 128, 3), 0.3)
rogue[5, 10] = 1e5
write("rogue.exr", rogue, kind=oiio.FLOAT)
open("none.ocio", "w").write("""ocio_profile_version: 2
roles: {default: Studio}
displays:
  sRGB:
    - !<View> {name: Standard, colorspace: Studio}
colorspaces:
  - !<ColorSpace> {name: Studio}
""")
