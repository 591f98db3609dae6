# SPDX-License-Identifier: MIT
"""The values that describe an eclipse, which are stored in its Moon, and the program's options for these values."""
import json
import math
import os
import re
from types import SimpleNamespace

import bpy
from bpy.props import (BoolProperty, EnumProperty, FloatProperty, IntProperty, PointerProperty,
                       StringProperty)

from .wrong import Wrong

CONTACTS = (
    ("greatest", "Greatest eclipse", "The Moon is nearest to the shadow's axis"),
    ("P1", "P1", "The penumbra reaches the Moon"),
    ("U1", "U1", "The umbra reaches the Moon"),
    ("U2", "U2", "Totality begins"),
    ("U3", "U3", "Totality ends"),
    ("U4", "U4", "The Moon leaves the umbra"),
    ("P4", "P4", "The Moon leaves the penumbra"),
)
SPACES = (
    ("lin_rec709", "Linear Rec.709", "Blender's own; reds outside it are paler"),
    ("acescg", "ACEScg", "Holds all reds of an eclipse"),
    ("lin_ciexyzd65_scene", "CIE XYZ", "CIE XYZ, D65"),
)


def described():
    """The program's parameters by name, as `coppermoon describe --json` lists them."""
    with open(os.path.join(os.path.dirname(__file__), "parameters.json"), encoding="utf-8") as file:
        commands = json.load(file)["commands"]
    return {each["name"]: each for command in commands for each in command["parameters"]}


def hint(word, meaning):
    """Finds the explanation of a word in a text such as "clear: air and ozone only; …" or "draft (5 %), …"."""
    found = re.search(rf"\b{re.escape(word)}(?:: ([^;]*)| \(([^)]*)\))", meaning)
    text = found and (found[1] or found[2]) or ""
    return text[:1].upper() + text[1:]


PARAMETERS = described()


def choice(name, parameter, description, first=()):
    """A property for a parameter whose value is one of several words.

    Given  first  words that must come first, in this order, because a .blend file stores a word's position in the list
    """
    known = PARAMETERS[parameter]
    words = [*first, *(word for word in known["words"] if word not in first)]
    items = [(word, word.replace("-", " ").capitalize(), hint(word, known["meaning"])) for word in words]
    return EnumProperty(name=name, items=items, default=known["default"], description=description)


def ends(parameter):
    """The lowest and the highest value of a parameter, as arguments for a property."""
    low, high = PARAMETERS[parameter]["range"]
    return {"min": low, "max": high}


class Values:
    """The values that the user sets, first in the operator that adds a Moon and later in the Moon itself."""
    date: StringProperty(
        name="Date", default="2018-07-27",
        description="Day of greatest eclipse (UTC), as 2018-07-27; or a moment in UTC, as "
                    "2018-07-27T20:40Z")
    film: BoolProperty(
        name="Whole eclipse", description="A film from the first contact to the last; otherwise one moment")
    shader: BoolProperty(
        name="By a shader", default=True,
        description="The film is one texture of the sunlit Moon and the node group \"Eclipse shadow\", which knows the "
                    "time; otherwise a texture for each frame. Alike within 1 %, 2 % where sunlight begins")
    frames: IntProperty(
        name="Frames", default=240, min=2, max=1000000, soft_max=5000,
        description="Number of frames, evenly from the first moment to the last")
    begin: StringProperty(
        name="From",
        description="First moment of the film: a contact, as U1 or P1-10min, or a time in UTC; empty: P1, "
                    "or moonrise where a place is given and the Moon rises later")
    end: StringProperty(
        name="To",
        description="Last moment of the film: a contact, as U4 or P4+10min, or a time in UTC; empty: P4, "
                    "or moonset where a place is given and the Moon sets before")
    start_frame: IntProperty(
        name="Start Frame", default=1, min=0, max=1000000,
        description="Frame of the scene that shows the first moment, as 1001")
    contact: EnumProperty(
        name="Contact", items=CONTACTS, default="greatest", description="What the moment is counted from")
    offset: FloatProperty(
        name="Offset", subtype="TIME_ABSOLUTE", unit="TIME_ABSOLUTE", soft_min=-7200, soft_max=7200,
        step=6000, description="Time from the contact to the moment; seconds, or as typed: 10min")
    place: StringProperty(
        name="Place",
        description="Place of the observer, whose air dims and reddens the Moon: a city, as Nairobi, or "
                    "latitude, longitude and elevation, as -1.28,36.82,1684 [degrees north and east, "
                    "metres]; empty: the Earth's centre, without air")
    night: BoolProperty(
        name="Night Sky",
        description="The sky of that night as the world of your scene: airglow, twilight and the moonlight that the "
                    "air scatters, in cd/m²; with a place, and without a scene of its own")
    air: choice("Air", "atmosphere", "Air of the Earth around its limb",
                first=("standard", "undated", "clear", "molecular", "paper"))
    by_danjon: BoolProperty(
        name="By Danjon",
        description="Cloud and aerosol are scaled until totality is as bright as Danjon's scale says")
    danjon: IntProperty(
        name="Danjon", default=2, **ends("danjon"),
        description="Brightness of totality on Danjon's scale, 0 (very dark) to 4 (bright)")
    quality: choice("Quality", "quality", "Largest error of luminance on the disc")
    texture_width: IntProperty(
        name="Texture", default=4096, **ends("texture-width"), step=2, subtype="PIXEL",
        description="Width of the texture, even; it is half as high")
    space: EnumProperty(
        name="Colours", items=SPACES, default="lin_rec709", description="Colour space of the texture")
    up: choice("Up", "up", "Direction that is up in the picture")
    field: FloatProperty(
        name="Field", subtype="ANGLE", unit="ROTATION", default=math.radians(0.6),
        min=math.radians(1e-3), max=math.radians(170), precision=4,
        description="Angle of view across the shorter side of the picture; the Moon has half a degree")


NAMES = tuple(Values.__annotations__)


class MoonValues(Values, bpy.types.PropertyGroup):
    is_moon: BoolProperty(description="This object is a Moon of this add-on")
    camera: PointerProperty(type=bpy.types.Object, description="The observer; moved when baked again")
    lamp: PointerProperty(type=bpy.types.Object, description="The light; changed when baked again")
    stars: PointerProperty(type=bpy.types.Object, description="The stars of the sky; made anew when baked again")
    world: PointerProperty(type=bpy.types.World, description="The night sky; changed when baked again")
    scene: PointerProperty(type=bpy.types.Scene, description="The scene of this eclipse alone, if any")
    last_set: StringProperty(
        default="{}", description="What was set in scene and camera, by name, as JSON: a setting that "
                                  "is another now was changed by the user, and stays")


def copy(source, target):
    for name in NAMES:
        setattr(target, name, getattr(source, name))


def changed(wanted, name):
    """Whether a value of the Moon has changed since the last bake."""
    return json.loads(wanted.last_set).get(name, getattr(wanted, name)) != getattr(wanted, name)


def put(wanted, owner, anew=False, **settings):
    """Sets several properties, unless the user has changed one of them since they were last set.

    Given     wanted  the Moon's values, in which the new settings are recorded
              anew    whether to set the properties even if the user has changed them
    Returned  whether the properties were set
    """
    known = json.loads(wanted.last_set)
    now = {name: getattr(owner, name) for name in settings}
    if not anew and any(known.get(name, value) != value for name, value in now.items()):
        return False
    for name, value in settings.items():
        setattr(owner, name, value)
    known.update({name: getattr(owner, name) for name in settings})
    wanted.last_set = json.dumps(known)
    return True


def was_set(wanted, name):
    return name in json.loads(wanted.last_set)


def remember(wanted, name):
    """Records the present value of a property, with which `changed` will compare later values."""
    wanted.last_set = json.dumps(json.loads(wanted.last_set) | {name: getattr(wanted, name)})


def has_sky(source):
    """Whether the Moon with these values is in the sky of the user's own scene."""
    return bool(source.place.strip() and getattr(source, "stars", not getattr(source, "own_scene", True)))


def plain(source):
    """A copy of the values that remains valid after an undo, which invalidates Blender's own values."""
    return SimpleNamespace(in_sky=has_sky(source), **{name: getattr(source, name) for name in NAMES})


def day_of(values):
    return re.split("[T ]", values.date.strip())[0]


def is_day(values):
    return "T" not in values.date and " " not in values.date.strip()


def require_sound(values):
    # Without this check, the date in someone else's file could act as an option or a path.
    if not re.fullmatch(r"[+-]?\d[\w:.+ -]*", values.date.strip(), re.ASCII):
        raise Wrong(f"date = {values.date.strip()}; allowed is a day, as 2018-07-27, or a moment in UTC, "
                    "as 2018-07-27T20:40Z")
    if values.texture_width % 2:
        raise Wrong(f"texture width = {values.texture_width}, allowed is an even number")
    if values.up == "zenith" and not values.place.strip():
        raise Wrong("up = zenith: needs a place")


def moment(values):
    """The moment in the form that the program reads, such as 2018-07-27 U2+600s."""
    if not is_day(values):
        return values.date.strip()
    if values.contact == "greatest" and values.offset == 0:
        return values.date.strip()
    offset = f"{values.offset:+.0f}s" if values.offset else ""
    return f"{values.date.strip()} {values.contact}{offset}"


def options(values):
    """The program's options for everything but the moment, written with "=" because a place may begin with "-"."""
    words = [f"--atmosphere={values.air}", f"--quality={values.quality}",
             f"--texture-width={values.texture_width}", f"--space={values.space}"]
    if values.by_danjon:
        words.append(f"--danjon={values.danjon}")
    if values.place.strip():
        words.append(f"--at={values.place.strip()}")
    return words


def light_options(values):
    """The program's options that affect the light in the shadow."""
    return [word for word in options(values) if not word.startswith(("--texture-width", "--at"))]


def span(values):
    """The program's options for the first and the last moment of a film."""
    observed = bool(values.place.strip())
    first, last = values.begin.strip() or (observed and "moonrise"), values.end.strip() or (observed and "moonset")
    return [f"--{name}={moment}" for name, moment in (("from", first), ("to", last)) if moment]


def register():
    bpy.utils.register_class(MoonValues)
    bpy.types.Object.coppermoon = PointerProperty(type=MoonValues)


def unregister():
    del bpy.types.Object.coppermoon
    bpy.utils.unregister_class(MoonValues)
