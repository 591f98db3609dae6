# SPDX-License-Identifier: MIT
"""A baked Moon in Blender (3.4 or later), from what stands in the header of its texture.

    coppermoon bake 2018-07-27T20:22:00Z -o moon.exr
    OCIO=colour/config.ocio blender -b --python-exit-code 1 -P examples/blender/eclipse.py -- \\
        moon.exr --exposure 6 --render frame.exr --save eclipse.blend

The Moon is a sphere of radius 1 at the origin that shines by its texture alone; longitude 0 is at
+X, 90 east at +Y, north at +Z. The camera stands where the observer does. A film's textures, as
files or as their folder, make an animation. Left out: how refraction flattens a low Moon.

Without --python-exit-code Blender's exit status is 0 even when Python fails. Without $OCIO it uses
its own configuration, which does as well. From Blender's text editor: write the arguments into
`arguments_here` and run.

The rendered EXR is in the texture's unit, cd/m2, in the scene-linear space of the configuration
(Rec.709 primaries in ours and in Blender's). --exposure is for looking: a full Moon wants -13,
an eclipsed one 0 to 10.
"""
import argparse
import math
import os
import re
import struct
import sys

import bpy
from mathutils import Matrix, Vector

arguments_here = []  # as ["/home/me/moon.exr", "--exposure", "6"]

MOON_RADIUS_KM = 1737.4

# By coppermoon:colour_space, what it is called in colour/config.ocio, in Blender 4's own
# configuration, and in Blender 3's.
COLOUR_SPACES = {
    "lin_rec709": ("Linear Rec.709 (sRGB)", "Linear Rec.709", "Linear"),
    "acescg": ("ACEScg", "Linear ACEScg"),
    "lin_ciexyzd65_scene": ("Scene CIE-XYZ-D65", "Linear CIE-XYZ D65", "XYZ"),
}
VIEWS = ("Un-tone-mapped", "Standard")  # colours as they are: ours, Blender's

# The limb is a polygon: with n corners it falls short of the circle by up to 1 - cos(pi / n) of
# its radius, for 512 by 1.9e-5: a fiftieth of a pixel in a disc 2000 pixels wide.
SEGMENTS, RINGS = 512, 256


class Wrong(Exception):
    """What the user can put right, in one line."""


# The header of an OpenEXR file: a magic number, a version, then attributes as name, type, size and
# value, until an empty name.


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
    """The strings, floats and rationals of an OpenEXR header, by name."""
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
    """A baked texture and who looks at it, in degrees and lunar radii."""

    def __init__(self, path):
        self.path = os.path.abspath(path)
        self.header = header_of(path)
        self.colour_space = self.told("colour_space")
        if self.colour_space not in COLOUR_SPACES:
            raise Wrong(f"{path}: coppermoon:colour_space = {self.colour_space}, "
                        f"allowed {', '.join(COLOUR_SPACES)}")
        self.latitude = self.told("sub_observer_latitude")
        self.longitude = self.told("sub_observer_longitude")
        self.axis = self.told("axis_position_angle")
        self.distance = self.told("distance_km") / MOON_RADIUS_KM
        if not self.distance > 1:
            raise Wrong(f"{path}: coppermoon:distance_km is within the Moon")

    def told(self, name):
        value = self.header.get("coppermoon:" + name)
        if value is None:
            raise Wrong(f"{self.path}: its header has no coppermoon:{name}")
        return value

    def frame(self):
        """The number that the name ends in, as 1 of moon_lin_rec709.0001.exr."""
        number = re.search(r"(\d+)\.exr$", self.path)
        if not number:
            raise Wrong(f"{self.path}: its name has no frame number, as .0001.exr")
        return int(number[1])


# The camera.


def axes_of(texture, up):
    """Right, up and back (towards the observer) of the camera, each a unit vector."""
    latitude, longitude = math.radians(texture.latitude), math.radians(texture.longitude)
    east = Vector((-math.sin(longitude), math.cos(longitude), 0))
    back = Vector((math.cos(latitude) * math.cos(longitude),
                   math.cos(latitude) * math.sin(longitude), math.sin(latitude)))
    north = back.cross(east)
    # Position angles are counter-clockwise in the picture, where the Moon's east is on the right.
    turn = {"moon-north": lambda: 0,
            "celestial-north": lambda: texture.axis,
            "zenith": lambda: texture.axis - texture.told("parallactic_angle")}[up]()
    cosine, sine = math.cos(math.radians(turn)), math.sin(math.radians(turn))
    return cosine * east - sine * north, cosine * north + sine * east, back


def place_camera(camera, texture, up):
    right, upward, back = axes_of(texture, up)
    camera.location = texture.distance * back
    turned = Matrix((right, upward, back)).transposed().to_quaternion()
    turned.make_compatible(camera.rotation_quaternion)
    camera.rotation_quaternion = turned


def new_camera(scene, textures, options):
    data = bpy.data.cameras.new("Observer")
    data.sensor_fit = "HORIZONTAL"
    # By the lens: an angle that is set directly is at least 0.37 degrees in Blender.
    data.lens = data.sensor_width / 2 / math.tan(math.radians(options.field) / 2)
    data.clip_start = min(texture.distance for texture in textures) - 1
    data.clip_end = max(texture.distance for texture in textures) + 1
    camera = bpy.data.objects.new("Observer", data)
    camera.rotation_mode = "QUATERNION"
    scene.collection.objects.link(camera)
    for texture in textures:
        place_camera(camera, texture, options.up)
        if len(textures) > 1:
            for path in ("location", "rotation_quaternion"):
                camera.keyframe_insert(path, frame=texture.frame())
    return camera


# The Moon.


def first_known(owner, setting, names):
    """Sets what Blender has under one of several names."""
    for name in names:
        try:
            setattr(owner, setting, name)
            return
        except TypeError:
            continue
    raise Wrong(f"{setting}: the OpenColorIO configuration has none of {', '.join(names)}")


def new_image(textures):
    image = bpy.data.images.load(textures[0].path)
    if min(image.size) == 0:
        raise Wrong(f"{textures[0].path}: Blender cannot read its texels")
    first_known(image.colorspace_settings, "name", COLOUR_SPACES[textures[0].colour_space])
    if len(textures) > 1:
        image.source = "SEQUENCE"
    return image


def follow_frames(image_user, textures):
    """Frame by frame: the number of the frame is that of the file."""
    first = textures[0].frame()
    image_user.frame_start = first
    image_user.frame_offset = first - 1
    image_user.frame_duration = len(textures)
    image_user.use_auto_refresh = True


def new_material(textures):
    material = bpy.data.materials.new("Moon")
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    texels = nodes.new("ShaderNodeTexImage")
    texels.image = new_image(textures)
    texels.extension = "REPEAT"
    texels.interpolation = "Linear"
    if len(textures) > 1:
        follow_frames(texels.image_user, textures)
    emission = nodes.new("ShaderNodeEmission")
    emission.inputs["Strength"].default_value = 1
    output = nodes.new("ShaderNodeOutputMaterial")
    links.new(texels.outputs["Color"], emission.inputs["Color"])
    links.new(emission.outputs["Emission"], output.inputs["Surface"])
    return material


def new_sphere():
    """Its UV is plate carrée: longitude 0 in the middle, east to the right, north up."""
    across, up = range(SEGMENTS + 1), range(RINGS + 1)
    uv = [(i / SEGMENTS, j / RINGS) for j in up for i in across]
    angles = [(math.tau * (u - 0.5), math.pi * (v - 0.5)) for u, v in uv]
    places = [(math.cos(latitude) * math.cos(longitude),
               math.cos(latitude) * math.sin(longitude), math.sin(latitude))
              for longitude, latitude in angles]
    corners = [(k, k + 1, k + len(across) + 1, k + len(across))
               for j in up[:-1] for k in range(j * len(across), (j + 1) * len(across) - 1)]
    mesh = bpy.data.meshes.new("Moon")
    mesh.from_pydata(places, [], corners)
    mesh.polygons.foreach_set("use_smooth", [True] * len(corners))
    flat = [number for face in corners for k in face for number in uv[k]]
    mesh.uv_layers.new(name="UVMap").data.foreach_set("uv", flat)
    return mesh


def new_moon(scene, textures):
    mesh = new_sphere()
    mesh.materials.append(new_material(textures))
    scene.collection.objects.link(bpy.data.objects.new("Moon", mesh))


# The scene.


def new_scene():
    if bpy.app.background:
        bpy.ops.wm.read_factory_settings(use_empty=True)
        scene = bpy.context.scene
    else:  # in the text editor: beside the user's own
        scene = bpy.context.window.scene = bpy.data.scenes.new("Eclipse")
    scene.world = bpy.data.worlds.new("Black")
    scene.world.color = (0, 0, 0)
    return scene


def set_time(scene, textures):
    if len(textures) == 1:
        return
    scene.frame_start, scene.frame_end = textures[0].frame(), textures[-1].frame()
    scene.frame_set(scene.frame_start)
    rate = textures[0].header.get("framesPerSecond")
    if rate:
        scene.render.fps = max(1, round(rate))
        scene.render.fps_base = scene.render.fps / rate


def set_render(scene, options):
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.samples = options.samples
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.max_bounces = 0  # nothing but the Moon's own light
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.pixel_filter_type = "BOX"  # one pixel wide: each is the mean of its own area
    render = scene.render
    render.resolution_x, render.resolution_y = options.width, options.height
    render.resolution_percentage = 100
    render.image_settings.file_format = "OPEN_EXR"
    render.image_settings.color_mode = "RGB"
    render.image_settings.color_depth = "32"
    render.image_settings.exr_codec = "ZIP"
    first_known(scene.view_settings, "view_transform", VIEWS)
    scene.view_settings.exposure = options.exposure


def build(textures, options):
    scene = new_scene()
    new_moon(scene, textures)
    scene.camera = new_camera(scene, textures, options)
    set_time(scene, textures)
    set_render(scene, options)
    return scene


def render(scene, path, animation):
    """One EXR, or of an animation one a frame: eclipse.exr becomes eclipse.0001.exr."""
    stem, ending = os.path.splitext(os.path.abspath(path))
    scene.render.filepath = stem + (".####" if animation else "") + (ending or ".exr")
    bpy.ops.render.render(animation=animation, write_still=True, scene=scene.name)


# The command line.


class Options(argparse.ArgumentParser):
    def error(self, message):
        raise Wrong(message)


def within(least, most, kind=float):
    def number(text):
        value = kind(text)
        if not least <= value <= most:
            raise argparse.ArgumentTypeError(f"{text}, allowed {least} to {most}")
        return value
    return number


def options_of(words):
    options = Options(prog="blender -b -P eclipse.py --", description="A baked Moon in Blender")
    options.add_argument("textures", nargs="+", metavar="moon.exr",
                         help="a texture that coppermoon baked; several, or a folder, make a film")
    options.add_argument("--up", default="celestial-north",
                         choices=("celestial-north", "zenith", "moon-north"))
    options.add_argument("--field", type=within(1e-3, 170), default=0.8445, metavar="DEGREES",
                         help="angle across the frame; 0.8445")
    options.add_argument("--width", type=within(1, 65535, int), default=1500, help="1500 pixels")
    options.add_argument("--height", type=within(1, 65535, int), default=1000, help="1000 pixels")
    options.add_argument("--exposure", type=within(-32, 32), default=0, metavar="STOPS",
                         help="of the view; the EXR stays in cd/m2")
    options.add_argument("--samples", type=within(1, 65536, int), default=64, help="a pixel; 64")
    options.add_argument("--render", metavar="OUT.exr")
    options.add_argument("--save", metavar="SCENE.blend")
    return options.parse_args(words)


def files_of(names):
    """What is named; of a folder its textures, moon_*.exr."""
    for name in names:
        if not os.path.isdir(name):
            yield name
            continue
        inside = [file for file in os.listdir(name)
                  if file.startswith("moon_") and file.endswith(".exr")]
        if not inside:
            raise Wrong(f"{name}: has no texture in it, moon_*.exr")
        yield from (os.path.join(name, file) for file in inside)


def require_sequence(textures):
    """Blender finds the frames by their numbers alone, beside the first."""
    first = textures[0]
    start = first.frame()
    before = re.sub(r"\d+\.exr$", "", first.path)
    for number, texture in enumerate(textures, start):
        if texture.frame() != number:
            raise Wrong(f"{texture.path}: frame {texture.frame()}, where {number} should follow")
        if re.sub(r"\d+\.exr$", "", texture.path) != before:
            raise Wrong(f"{texture.path}: is not of one film with {first.path}")
        if texture.colour_space != first.colour_space:
            raise Wrong(f"{texture.path}: {texture.colour_space}, where {first.path} "
                        f"is {first.colour_space}")


def main(words):
    options = options_of(words)
    textures = [Texture(path) for path in files_of(options.textures)]
    if len(textures) > 1:
        textures.sort(key=Texture.frame)
        require_sequence(textures)
    scene = build(textures, options)
    if options.save:
        bpy.ops.wm.save_as_mainfile(filepath=os.path.abspath(options.save), compress=True)
    if options.render:
        render(scene, options.render, animation=len(textures) > 1)


if __name__ == "__main__":
    try:
        main(sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else arguments_here)
    except Wrong as wrong:
        if bpy.app.background:
            sys.exit(f"eclipse.py: {wrong}")
        raise
