#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares the files of two folders: images texel by texel, texts number by number.

Pictures of whole numbers may differ by one level, JPEGs by three. Of files that hold others (.glb, .usdz), and of kept light, whose numbers
round otherwise, sizes may differ by 1 %.

    tests/windows_same.py HERE THERE [ERROR]

Numbers may differ by ERROR (default 1e-6) of themselves, or of a millionth of the file's largest. Prints the largest difference of each
kind of file, and exits 1 where a file is missing, or differs by more.
"""
import pathlib
import re
import sys

import numpy
import OpenImageIO

NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
IMAGES = (".exr", ".tx", ".png", ".jpg", ".tif", ".dng")
TEXTS = (".json", ".csv", ".txt", ".ics", ".toml", ".svg", ".usda", ".osl", ".inc", ".pov", ".ini", ".mtlx", ".glsl", ".h")


def image(path):
    buffer = OpenImageIO.ImageBuf(str(path))
    if buffer.has_error:
        raise SystemExit(f"{path}: {buffer.geterror()}")
    level = {OpenImageIO.UINT8: 1 / 255, OpenImageIO.UINT16: 1 / 65535}.get(buffer.spec().format.basetype, 0)
    return numpy.asarray(buffer.get_pixels(OpenImageIO.FLOAT), dtype=float), level


def numbers(path):
    # of the clock, of the order of threads, and of the rest of the text
    others = r'"seconds"|DTSTAMP|made in|frames made| of [0-9]+: frame|as coppermoon wrote it'
    text = re.sub(f"(?m)^.*({others}).*$", "", path.read_text("utf-8"))
    text = text.replace("- ", "+ -")  # terms of a sum, whose signs may change where they are nearly 0
    return NUMBER.sub("#", text), numpy.array([float(n) for n in NUMBER.findall(text)])


def difference(here, there):
    """Largest difference of two files; infinite where their texts or shapes differ."""
    if here.suffix in IMAGES:
        (a, level), (b, _) = image(here), image(there)
        if level and a.shape == b.shape and numpy.max(numpy.abs(a - b)) < (3.5 if here.suffix == ".jpg" else 1.5) * level:
            return 0
    elif here.suffix in TEXTS:
        (words, a), (others, b) = numbers(here), numbers(there)
        if words != others:
            return float("inf")
    elif here.suffix == ".html":  # whose numbers are compressed
        return 0
    else:
        sizes = [path.stat().st_size for path in (here, there)]
        return 0 if abs(sizes[0] - sizes[1]) <= 0.01 * sizes[0] else float("inf")
    if a.shape != b.shape:
        return float("inf")
    least = 1e-6 * numpy.max(numpy.abs(a), initial=1e-30)
    return float(numpy.max(numpy.abs(a - b) / numpy.maximum(numpy.abs(a), least), initial=0))


def main():
    here, there = map(pathlib.Path, sys.argv[1:3])
    allowed = float(sys.argv[3]) if len(sys.argv) > 3 else 1e-6
    largest, wrong = {}, 0
    for one in sorted(path for path in here.rglob("*") if path.is_file() and not path.name.startswith(".")):
        other = there / one.relative_to(here)
        found = difference(one, other) if other.exists() else float("inf")
        largest[one.suffix] = max(largest.get(one.suffix, 0), found)
        if found > allowed:
            wrong += 1
            print(f"{one.relative_to(here)}: {'differs by %g' % found if other.exists() else 'is missing'}")
    print(", ".join(f"{suffix} {value:.2g}" for suffix, value in largest.items()))
    sys.exit(wrong > 0)


main()
