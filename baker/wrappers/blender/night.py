# SPDX-License-Identifier: MIT
"""The night sky as the world of a scene. A luminance of 1 cd/m² becomes a radiance of 1. North is +Y, east is +X."""
import math
import os

import bpy

from . import moon, program, values
from .nodes import add, emptied, first, show

WIDTH = 1024  # of the sky [texels]; stars are a separate mesh


def file_beside(texture, of_film):
    """Path of the image of the sky for a texture. It is beside the texture or, for a film, in the subfolder "sky"."""
    folder, name = os.path.split(texture.path)
    if of_film:
        return os.path.join(folder, "sky", f"sky.{texture.number():04d}.exr")
    return os.path.join(folder, f"{os.path.splitext(name)[0]}_sky.exr")


def domes(wanted, textures):
    """Makes each texture's image of the sky if missing. Returns all files. Yields progress as `program.run` does."""
    light = [word for word in values.options(wanted) if not word.startswith("--texture-width")]
    files = []
    for texture in textures:
        file = file_beside(texture, len(textures) > 1)
        os.makedirs(os.path.dirname(file), exist_ok=True)
        if not os.path.exists(file):
            words = ["dome", f"--instant={texture.instant()}", *light, "--stars=off",
                     f"--width={WIDTH}", f"--output={file}"]
            for _ in program.run(words):
                yield "night sky", len(files) / len(textures)
        files.append(file)
    return files


def sky_texels(tree, place, scale):
    """Adds a node to a node tree that samples the sky's image. The direction of view is `place` times `scale`."""
    turned = add(tree, "Mapping", {
        "Vector": place,
        "Rotation": (0, 0, -math.pi / 2),  # the image's middle, +X, is north
        "Scale": (scale, scale, scale),
        # Looks half a texel higher, so that the horizon shows the sky's lowest row and is not darkened by the ground.
        "Location": (0, 0, math.pi / WIDTH)}, (-300, -400))
    return add(tree, "TexEnvironment", {"Vector": turned.outputs["Vector"]}, (0, -400))


def new_world():
    world = bpy.data.worlds.new("Night Sky")
    tree = emptied(world)
    place = add(tree, "TexCoord", at=(-900, 0))
    texels = sky_texels(tree, place.outputs["Generated"], 1)
    light = add(tree, "Background", {"Color": texels.outputs["Color"]}, (-300, 0))
    add(tree, "OutputWorld", {"Surface": light.outputs["Background"]}, (300, 0))
    return world


def texels_before(material):
    """Adds the sky's light to the Moon's material, because the air in front of the Moon shines. Returns the node."""
    tree = material.node_tree
    if known := first(tree, "TEX_ENVIRONMENT"):
        return known
    output = first(tree, "OUTPUT_MATERIAL")
    view = add(tree, "NewGeometry", at=(-600, -400))
    texels = sky_texels(tree, view.outputs["Incoming"], -1)
    air = add(tree, "Emission", {"Color": texels.outputs["Color"]}, (300, -400))
    both = add(tree, "AddShader", {0: output.inputs["Surface"].links[0].from_socket, 1: air.outputs["Emission"]}, (500, 0))
    tree.links.new(both.outputs["Shader"], output.inputs["Surface"])
    output.location = (700, 0)
    return texels


def put_world(of_moon, textures, files):
    """Sets images of the sky, one per frame in a film, as the world of the Moon's scene, and adds their light in front
    of the Moon. The world that the user had before stays in the .blend file."""
    wanted, scene = of_moon.coppermoon, of_moon.users_scene[0]
    if not wanted.world:
        wanted.world = new_world()
        if scene.world:
            scene.world.use_fake_user = True
        scene.world = wanted.world
    image = moon.loaded(files[0], textures[0], "Night sky")
    for node in (first(wanted.world.node_tree, "TEX_ENVIRONMENT"), texels_before(of_moon.material_slots[0].material)):
        show(node, image, textures)
