# SPDX-License-Identifier: MIT
"""Prints what the package computes, to the last digit: tests/wheels.sh compares it from one interpreter with another.

Standard error then says which libraries outside the wheel were needed.
"""
import pathlib
import re
import sys
import tempfile
import zlib

import coppermoon

when = "2018-07-27T20:21:45Z"
light = coppermoon.Light(bands=4, rays=60)


def show(name, array):
    print(name, array.dtype, array.shape, f"{zlib.crc32(array.tobytes()):08x}", " ".join(float(x).hex() for x in array.flat[:3]))


profile = coppermoon.shadow_profile(when, [450, 650], [0, 2000, 4000])
show("shadow", profile.irradiance_ratio)
show("moon", coppermoon.bake(when, width=64, light=light, albedo_map="built-in").pixels)
with tempfile.TemporaryDirectory() as folder:  # read by OpenImageIO
    file = pathlib.Path(folder) / "map.ppm"
    file.write_bytes(b"P6 64 32 255 " + bytes(range(96)) * 64)
    show("moon of a picture", coppermoon.bake(when, width=64, light=light, albedo_map=str(file)).pixels)
show("dome", coppermoon.dome(when, at="Nairobi", width=32, stars="3", light=coppermoon.Light(tolerance=0.05)).pixels)
for band, magnitude in coppermoon.brightness(when, at="Nairobi", light=light).seen.magnitudes.items():
    print(band, float(magnitude).hex())
print(coppermoon.nearest_eclipse("2018-07-27").contacts["U2"])

mapped = set(re.findall(r"/\S*/([^/\s]+)\.so", pathlib.Path("/proc/self/maps").read_text()))
inside = {path.name.split(".so")[0] for path in pathlib.Path(coppermoon.__file__).parents[1].rglob("*.so*")}
print("from outside:", *sorted(mapped - inside), file=sys.stderr)
