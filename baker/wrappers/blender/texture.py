# SPDX-License-Identifier: MIT
"""Reads the header of a baked texture, which gives the moment, the colour space and the observer's position."""
import os
import re
import struct

from .wrong import Wrong

MOON_RADIUS_KM = 1737.4

# Names of each coppermoon:colour_space in colour/config.ocio, in Blender 4's configuration and in Blender 3's.
COLOUR_SPACES = {
    "lin_rec709": ("Linear Rec.709 (sRGB)", "Linear Rec.709", "Linear"),
    "acescg": ("ACEScg", "Linear ACEScg"),
    "lin_ciexyzd65_scene": ("Scene CIE-XYZ-D65", "Linear CIE-XYZ D65", "XYZ"),
}


# The header of an OpenEXR file has a magic number, a version, and then attributes with name, type, size and value. It
# ends with an empty name.


def text_until_null(file):
    letters = bytearray()
    while (letter := file.read(1)) not in (b"", b"\0"):
        letters += letter
    return letters.decode("utf-8", "replace")


def value_of(kind, data):
    if kind == "string":
        return data.decode("utf-8", "replace")
    if kind == "float":
        return struct.unpack("<f", data)[0]
    if kind == "rational":
        over, under = struct.unpack("<iI", data)
        return over / under if under else 0.0
    return None


def header_of(path):
    """Attributes of type string, float or rational in the header of an OpenEXR file, by name."""
    try:
        with open(path, "rb") as file:
            if file.read(4) != struct.pack("<i", 20000630):
                raise Wrong(f"{path}: is not an OpenEXR file")
            file.read(4)
            attributes = {}
            while name := text_until_null(file):
                kind = text_until_null(file)
                (size,) = struct.unpack("<I", file.read(4))
                attributes[name] = value_of(kind, file.read(size))
            return attributes
    except OSError as error:
        raise Wrong(f"{path}: {error.strerror}") from error
    except struct.error as error:
        raise Wrong(f"{path}: its header ends early") from error


class Texture:
    """A baked texture, with its observer's position relative to the Moon [degrees, lunar radii]."""

    def __init__(self, path):
        self.path = os.path.abspath(path)
        self.header = header_of(path)
        self.colour_space = self.attribute("colour_space")
        if self.colour_space not in COLOUR_SPACES:
            raise Wrong(f"{path}: coppermoon:colour_space = {self.colour_space}, "
                        f"allowed {', '.join(COLOUR_SPACES)}")
        self.latitude = self.attribute("sub_observer_latitude")
        self.longitude = self.attribute("sub_observer_longitude")
        self.axis = self.attribute("axis_position_angle")
        self.distance = self.attribute("distance_km") / MOON_RADIUS_KM
        if not self.distance > 1:
            raise Wrong(f"{path}: coppermoon:distance_km is within the Moon")
        self.frames_later, self.of_film = 0, False

    def attribute(self, name):
        value = self.header.get("coppermoon:" + name)
        if value is None:
            raise Wrong(f"{self.path}: its header has no coppermoon:{name}")
        return value

    def frame(self):
        """Number of the scene's frame that shows this texture."""
        return self.number() + self.frames_later

    def moment(self):
        """The texture's moment in UTC, such as 2018-07-27 20:21:45; empty if the header has none."""
        return self.header.get("capDate", "").replace(":", "-", 2)

    def instant(self):
        """The texture's moment in the form that the program reads, such as 2018-07-27T20:21:45Z."""
        return self.moment().replace(" ", "T") + "Z"

    def second(self):
        """The time of day at the texture's moment [s]."""
        return second_of_day(self.header.get("capDate", ""))

    def number(self):
        """The number at the end of the file's name, such as 1 for moon_lin_rec709.0001.exr."""
        number = re.search(r"(\d+)\.exr$", self.path)
        if not number:
            raise Wrong(f"{self.path}: its name has no frame number, as .0001.exr")
        return int(number[1])


def key(owner, texture, *paths):
    """Sets keyframes for properties at a texture's frame, if the texture belongs to a film."""
    for path in paths if texture.of_film else ():
        owner.keyframe_insert(path, frame=texture.frame())


def second_of_day(text):
    """The time of day [s] in a string such as 2018-07-27T19:30:17Z, or 2018:07:27 19:30:17 from a header."""
    time = re.search(r"[T ](\d+):(\d+):(\d+(?:\.\d+)?)", text)
    if not time:
        raise Wrong(f"{text}: is no moment, as 2018-07-27T19:30:17Z")
    return 3600 * int(time[1]) + 60 * int(time[2]) + float(time[3])


def stem_of(path):
    """The part of a file name before its number, such as moon_lin_rec709. for moon_lin_rec709.0001.exr."""
    return re.sub(r"\d+\.exr$", "", path)


def textures_of(path):
    """The texture in a file, or all textures in a film's folder in the order of their frames.

    Throws  Wrong  if a frame is missing, because Blender finds the files after the first by consecutive numbers
    """
    if not os.path.isdir(path):
        return [Texture(path)]
    names = [name for name in os.listdir(path) if name.startswith("moon_") and name.endswith(".exr")]
    if not names:
        raise Wrong(f"{path}: has no texture in it, moon_*.exr")
    textures = [Texture(os.path.join(path, name)) for name in names]
    if len(textures) == 1:
        return textures
    textures.sort(key=Texture.number)
    first = textures[0]
    for number, texture in enumerate(textures, first.number()):
        texture.of_film = True
        if texture.number() != number:
            raise Wrong(f"{texture.path}: frame {texture.number()}, where {number} should follow")
        if stem_of(texture.path) != stem_of(first.path):
            raise Wrong(f"{texture.path}: is not of one film with {first.path}")
        if texture.colour_space != first.colour_space:
            raise Wrong(f"{texture.path}: {texture.colour_space}, where {first.path} "
                        f"is {first.colour_space}")
    return textures
