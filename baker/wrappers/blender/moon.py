# SPDX-License-Identifier: MIT
"""The Moon as a sphere that emits the light in its texture. A luminance of 1 cd/m² becomes a radiance of 1."""
import math

import bpy

from .nodes import add, emptied, first, show
from .texture import COLOUR_SPACES
from .wrong import Wrong

# Numbers of the sphere's meridians and rows. A limb with n corners falls short of a circle by at most 1 - cos(pi / n)
# of the radius. With 512 corners this is 1.9e-5, or a fiftieth of a pixel in a disc 2000 pixels wide. The limb seen
# from the Earth is at longitudes of 80 to 100 degrees. At other longitudes, a quarter of the meridians is enough.
SEGMENTS, RINGS = 512, 256
MERIDIANS = [i for i in range(SEGMENTS + 1) if abs(abs(i - SEGMENTS // 2) - SEGMENTS // 4) < SEGMENTS // 32 or i % 4 == 0]


def first_known(owner, setting, names):
    """Sets a property to the first of the given names that Blender knows."""
    for name in names:
        try:
            setattr(owner, setting, name)
            return
        except TypeError:
            continue
    raise Wrong(f"{setting}: the OpenColorIO configuration has none of {', '.join(names)}")


def set_colours(image, texture):
    """Sets an image's colour space to that of its texture."""
    first_known(image.colorspace_settings, "name", COLOUR_SPACES[texture.colour_space])


def new_mesh():
    """A sphere whose UV coordinates are plate carrée: longitude 0 in the middle, east to the right, north up."""
    across, up = MERIDIANS, range(RINGS + 1)
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


def keep_from_sampling(material):
    """Keeps Cycles from sampling the sphere as a light source, because the lamp lights the scene instead. Otherwise
    Cycles would take too few samples of the lamp, which seems dimmer, and the lamp's light would be noisy."""
    cycles = getattr(material, "cycles", None)
    if hasattr(cycles, "emission_sampling"):
        cycles.emission_sampling = "NONE"
    elif hasattr(cycles, "sample_as_light"):  # before Blender 3.5
        cycles.sample_as_light = False


def new_material():
    material = bpy.data.materials.new("Moon")
    tree = emptied(material)
    keep_from_sampling(material)
    texels = add(tree, "TexImage", at=(-300, 0), extension="REPEAT", interpolation="Linear")
    emission = add(tree, "Emission", {"Color": (0, 0, 0, 1), "Strength": 1})
    tree.links.new(texels.outputs["Color"], emission.inputs["Color"])
    add(tree, "OutputMaterial", {"Surface": emission.outputs["Emission"]}, (200, 0))
    return material


def new_moon(scene):
    mesh = new_mesh()
    mesh.materials.append(new_material())
    moon = bpy.data.objects.new("Moon", mesh)
    scene.collection.objects.link(moon)
    return moon


def texture_node(moon):
    """The image node that shows the Moon's texture."""
    trees = [slot.material.node_tree for slot in moon.material_slots if slot.material]
    node = next(filter(None, (first(tree, "TEX_IMAGE") for tree in trees if tree)), None)
    if not node:
        raise Wrong(f"{moon.name}: has no material with an image texture")
    return node


def loaded(path, texture, name):
    """Loads an image file, and gives the image the colour space of a texture."""
    image = bpy.data.images.load(path)
    if min(image.size) == 0:
        bpy.data.images.remove(image)
        raise Wrong(f"{path}: Blender cannot read its texels")
    set_colours(image, texture)
    if bpy.data.filepath:
        image.filepath = bpy.path.relpath(path)
    image.name = name
    return image


def image_of(texture):
    """Loads a texture as an image, which is named after the texture's moment."""
    return loaded(texture.path, texture, f"Moon {texture.moment()}".strip())


def put_textures(moon, textures):
    """Makes the Moon shine with a texture or, in a film, with one texture in each frame."""
    node, image = texture_node(moon), image_of(textures[0])
    if len(textures) > 1:
        image.name += " film"
    show(node, image, textures)
