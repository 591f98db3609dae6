# SPDX-License-Identifier: MIT
"""The Moon: a sphere that shines by its texture alone, 1 cd/m² of it as radiance 1."""
import math

import bpy

from .texture import COLOUR_SPACES
from .wrong import Wrong

# Corners of the limb. A polygon of n corners falls short of the circle by 1 - cos(pi / n) of the radius at most: for
# 512 by 1.9e-5, a fiftieth of a pixel in a disc 2000 pixels wide. Far from the limb that the Earth sees, 90 degrees
# from the middle and at most 10 more or less, a fourth of the meridians does.
SEGMENTS, RINGS = 512, 256
MERIDIANS = [i for i in range(SEGMENTS + 1) if abs(abs(i - SEGMENTS // 2) - SEGMENTS // 4) < SEGMENTS // 32 or i % 4 == 0]


def first_known(owner, setting, names):
    """Sets a property that Blender has under one of several names."""
    for name in names:
        try:
            setattr(owner, setting, name)
            return
        except TypeError:
            continue
    raise Wrong(f"{setting}: the OpenColorIO configuration has none of {', '.join(names)}")


def set_colours(texture):
    """Sets the colour space of an image to that of the texture."""
    return lambda image: first_known(image.colorspace_settings, "name",
                                     COLOUR_SPACES[texture.colour_space])


def new_mesh():
    """Sphere with UV in plate carrée: longitude 0 in the middle, east to the right, north up."""
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
    """Has Cycles send no rays to the sphere to find light: the lamp lights the scene. Else the lamp, dimmer than the
    sphere seems, is chosen too seldom, and what it lights is noisy."""
    cycles = getattr(material, "cycles", None)
    if hasattr(cycles, "emission_sampling"):
        cycles.emission_sampling = "NONE"
    elif hasattr(cycles, "sample_as_light"):  # before Blender 3.5
        cycles.sample_as_light = False


def new_material():
    material = bpy.data.materials.new("Moon")
    if material.node_tree is None:  # before Blender 5
        material.use_nodes = True
    keep_from_sampling(material)
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    texels = nodes.new("ShaderNodeTexImage")
    texels.location = (-300, 0)
    texels.extension = "REPEAT"
    texels.interpolation = "Linear"
    emission = nodes.new("ShaderNodeEmission")
    emission.inputs["Color"].default_value = (0, 0, 0, 1)
    emission.inputs["Strength"].default_value = 1
    output = nodes.new("ShaderNodeOutputMaterial")
    output.location = (200, 0)
    links.new(texels.outputs["Color"], emission.inputs["Color"])
    links.new(emission.outputs["Emission"], output.inputs["Surface"])
    return material


def new_moon(scene):
    mesh = new_mesh()
    mesh.materials.append(new_material())
    moon = bpy.data.objects.new("Moon", mesh)
    scene.collection.objects.link(moon)
    return moon


def texture_node(moon):
    """Node of the Moon's texture."""
    for slot in moon.material_slots:
        if slot.material and slot.material.node_tree:
            for node in slot.material.node_tree.nodes:
                if node.type == "TEX_IMAGE":
                    return node
    raise Wrong(f"{moon.name}: has no material with an image texture")


def image_of(texture):
    """New image of a texture, named by its moment."""
    image = bpy.data.images.load(texture.path)
    if min(image.size) == 0:
        bpy.data.images.remove(image)
        raise Wrong(f"{texture.path}: Blender cannot read its texels")
    set_colours(texture)(image)
    if bpy.data.filepath:
        image.filepath = bpy.path.relpath(texture.path)
    image.name = f"Moon {texture.moment()}".strip()
    return image


def put_textures(moon, textures):
    """Has the Moon shine by these textures, in a film by one in each frame."""
    node = texture_node(moon)
    first = textures[0]
    image = image_of(first)
    if len(textures) > 1:
        image.name += " film"
    before, node.image = node.image, image
    if before and before.users == 0:
        bpy.data.images.remove(before)
    if len(textures) > 1:
        image.source = "SEQUENCE"
        user = node.image_user
        user.frame_start = first.frame()
        user.frame_offset = first.number() - 1
        user.frame_duration = len(textures)
        user.use_auto_refresh = True
