#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes stars.bin, the stars shown in rendered frames, from the catalogues of Debian 12's package stellarium-data.

Usage: make_stars.py [folder of the catalogues] [stars.bin]

It keeps stars down to V = 9.0 within 10 degrees of the ecliptic, where the Moon always is, and to 6.5 elsewhere.
Sections 3.1, 3.6 and 3.7 of the package's copyright file name the sources: Hipparcos Catalogue (ESA, 1997, SP-1200),
Tycho-2 Catalogue (Hog et al., 2000) and Naval Observatory Merged Astrometric Dataset NOMAD 1 (U.S. Naval
Observatory), which is free to distribute if source, name and changes are stated. The changes: magnitudes and colours
are rounded, and Stellarium's authors computed those that a catalogue lacked; positions are rounded to 0.0003
arcseconds; some stars are left out. Stars without a Hipparcos number have no proper motion.

A star takes 16 bytes, little-endian: right ascension and declination (ICRS, epoch and equinox 2000.0), in units of
2^-32 of a full turn, 4 bytes each; proper motion east and north, in units of 0.01 mas a year, 3 bytes each; then
(V + 2) / 0.05 and (B - V + 0.5) / (4/127), one byte each.
"""
import math
import struct
import sys

PHI = (1 + math.sqrt(5)) / 2
B = 1 / math.sqrt(1 + PHI * PHI)
A = B * PHI
CORNERS = [(A, -B, 0), (A, B, 0), (-A, B, 0), (-A, -B, 0), (0, A, -B), (0, A, B), (0, -A, B), (0, -A, -B), (-B, 0, A),
           (B, 0, A), (B, 0, -A), (-B, 0, -A)]
TRIANGLES = [(1, 0, 10), (0, 1, 9), (0, 9, 6), (9, 8, 6), (0, 7, 10), (6, 7, 0), (7, 6, 3), (6, 8, 3), (11, 10, 7),
             (7, 3, 11), (3, 2, 11), (2, 3, 8), (10, 11, 4), (2, 4, 11), (5, 4, 2), (2, 8, 5), (4, 1, 10), (4, 5, 1),
             (5, 9, 1), (8, 9, 5)]
OBLIQUITY = math.radians(23.4392911)
HEAD, RECORD = 32, 28


def total(*vectors):
    return tuple(map(sum, zip(*vectors)))


def scaled(factor, v):
    return tuple(factor * x for x in v)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(v):
    return scaled(1 / math.sqrt(dot(v, v)), v)


def triangles(level):
    """Divides the sky into 20 * 4^level triangles: an icosahedron whose edges are halved `level` times."""
    found = [tuple(CORNERS[i] for i in triangle) for triangle in TRIANGLES]
    for _ in range(level):
        smaller = []
        for c0, c1, c2 in found:
            e0, e1, e2 = unit(total(c1, c2)), unit(total(c2, c0)), unit(total(c0, c1))
            smaller += [(c0, e2, e1), (e2, c1, e0), (e1, e0, c2), (e0, e1, e2)]
        found = smaller
    return found


def plane(triangle):
    """Tangent plane at a triangle's middle, as (middle, east, north), and the largest coordinate of a corner in it."""
    middle = unit(total(*triangle))
    east = unit(cross((0, 0, 1), middle))
    north = cross(middle, east)
    reach = 0
    for corner in triangle:
        x, y = dot(corner, east), dot(corner, north)
        reach = max(reach, max(abs(x), abs(y)) / math.sqrt(1 - x * x - y * y))
    return (middle, east, north), reach


def stars(path):
    """Yields each star's Hipparcos number (0 if it has none), direction, V magnitude and colour code in a catalogue."""
    with open(path, "rb") as file:
        data = file.read()
    magic, kind, version, _, level, brightest, extent, steps = struct.unpack_from("<5I2iI", data)
    if (magic, kind, version) != (0x835F040A, 0, 0):
        sys.exit(f"{path}: is no star catalogue of Stellarium's of type 0, version 0")
    planes = [plane(triangle) for triangle in triangles(level)]
    step = max(reach for _, reach in planes) / (2**31 - 1)
    counts = struct.unpack_from(f"<{len(planes)}I", data, HEAD)
    at = HEAD + 4 * len(planes)
    for ((middle, east, north), _), count in zip(planes, counts):
        for _ in range(count):
            number, x, y, colour, magnitude = struct.unpack_from("<I2i2B", data, at)
            place = unit(total(middle, scaled(step * x, east), scaled(step * y, north)))
            yield number & 0xFFFFFF, place, (brightest + extent * magnitude / steps) / 1000, colour
            at += RECORD


def motions(path):
    """Proper motion east and north [mas a year] by Hipparcos number."""
    found = {}
    with open(path, encoding="utf-8") as file:
        for line in file:
            if line.strip() and not line.startswith("#"):
                number, east, north = line.split("\t")[:3]
                found[int(number)] = float(east), float(north)
    return found


def is_kept(place, magnitude):
    latitude = math.asin(place[2] * math.cos(OBLIQUITY) - place[1] * math.sin(OBLIQUITY))
    return magnitude < (9.025 if abs(latitude) < math.radians(10) else 6.525)


def record(place, magnitude, colour, motion):
    turn = 2**32 / (2 * math.pi)
    ascension = round(turn * math.atan2(place[1], place[0])) % 2**32
    declination = round(turn * math.asin(place[2]))
    east, north = (round(100 * part).to_bytes(3, "little", signed=True) for part in motion)
    return struct.pack("<Ii3s3s2B", ascension, declination, east, north, round((magnitude + 2) / 0.05), colour)


def main():
    usual = ["/usr/share/stellarium/stars/default", "stars.bin"]
    folder, made = sys.argv[1:3] + usual[len(sys.argv) - 1:]
    motion = motions(f"{folder}/hip_pm.dat")
    kept = b""
    for name in ("stars_0_0v0_8.cat", "stars_1_0v0_8.cat", "stars_2_0v0_8.cat"):
        for number, place, magnitude, colour in stars(f"{folder}/{name}"):
            if is_kept(place, magnitude):
                kept += record(place, magnitude, colour, motion.get(number, (0, 0)))
    with open(made, "wb") as file:
        file.write(kept)
    print(f"{len(kept) // 16} stars")


if __name__ == "__main__":
    main()
