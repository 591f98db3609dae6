# SPDX-License-Identifier: MIT
"""The night sky as a scene's world: 1 cd/m² of it as radiance 1, north towards +Y, east towards +X."""
import math
import os

import bpy

from . import moon, program, values

WIDTH = 1024  # of the sky [texels]; stars are a mesh of their own


def file_beside(texture, of_film):
    """File of a texture's sky: beside it; those of a film in a folder."""
    folder, name = os.path.split(texture.path)
    if of_film:
        return os.path.join(folder, "sky", f"sky.{texture.number():04d}.exr")
    return os.path.join(folder, f"{os.path.splitext(name)[0]}_sky.exr")


def domes(wanted, textures):
    """Yields as `program.run`; returns a file for each texture. What is there already is not made again."""
    light = [word for word in values.options(wanted) if not word.startswith("--texture-width")]
    files = []
    for texture in textures:
        file = file_beside(texture, len(textures) > 1)
        os.makedirs(os.path.dirname(file), exist_ok=True)
        if not os.path.exists(file):
            words = ["dome", f"--instant={texture.moment().replace(' ', 'T')}Z", *light, "--stars=off",
                     f"--width={WIDTH}", f"--output={file}"]
            for _ in program.run(words, lambda line: None):
                yield "night sky", len(files) / len(textures)
        files.append(file)
    return files


def sky_texels(tree, place, scale):
    """Node of the sky's texels in a tree; `place`, a socket, times `scale` is the direction that is looked at."""
    nodes, links = tree.nodes, tree.links
    turned, texels = nodes.new("ShaderNodeMapping"), nodes.new("ShaderNodeTexEnvironment")
    turned.inputs["Rotation"].default_value = (0, 0, -math.pi / 2)  # the image's middle, +X, is north
    turned.inputs["Scale"].default_value = (scale, scale, scale)
    # half a texel up: the lowest row of the sky reaches down to the horizon, without a dark edge of the ground's
    turned.inputs["Location"].default_value = (0, 0, math.pi / WIDTH)
    turned.location, texels.location = (-300, -400), (0, -400)
    links.new(place, turned.inputs["Vector"])
    links.new(turned.outputs["Vector"], texels.inputs["Vector"])
    return texels


def new_world():
    world = bpy.data.worlds.new("Night Sky")
    if world.node_tree is None:  # before Blender 5
        world.use_nodes = True
    nodes, links = world.node_tree.nodes, world.node_tree.links
    nodes.clear()
    place, light, output = [nodes.new(f"ShaderNode{kind}") for kind in ("TexCoord", "Background", "OutputWorld")]
    for k, node in enumerate((place, light, output)):
        node.location = (300 * (2 * k - 3), 0)
    texels = sky_texels(world.node_tree, place.outputs["Generated"], 1)
    links.new(texels.outputs["Color"], light.inputs["Color"])
    links.new(light.outputs["Background"], output.inputs["Surface"])
    return world


def texels_before(material):
    """Node of the sky's texels in the Moon's material: the air before the Moon shines as that beside it."""
    tree = material.node_tree
    known = next((node for node in tree.nodes if node.type == "TEX_ENVIRONMENT"), None)
    if known:
        return known
    output = next(node for node in tree.nodes if node.type == "OUTPUT_MATERIAL")
    of_moon = output.inputs["Surface"].links[0].from_socket
    view, air, both = [tree.nodes.new(f"ShaderNode{kind}") for kind in ("NewGeometry", "Emission", "AddShader")]
    texels = sky_texels(tree, view.outputs["Incoming"], -1)
    view.location, air.location, both.location, output.location = (-600, -400), (300, -400), (500, 0), (700, 0)
    tree.links.new(texels.outputs["Color"], air.inputs["Color"])
    tree.links.new(of_moon, both.inputs[0])
    tree.links.new(air.outputs["Emission"], both.inputs[1])
    tree.links.new(both.outputs["Shader"], output.inputs["Surface"])
    return texels


def put_world(of_moon, textures, files):
    """Has the scene of the Moon lit by these skies, in a film by one in each frame; each shines before the Moon as well. A
    world of the user's is kept."""
    wanted, scene = of_moon.coppermoon, of_moon.users_scene[0]
    if not wanted.world:
        wanted.world = new_world()
        if scene.world:
            scene.world.use_fake_user = True
        scene.world = wanted.world
    image = bpy.data.images.load(files[0])
    moon.set_colours(textures[0])(image)
    if bpy.data.filepath:
        image.filepath = bpy.path.relpath(files[0])
    image.name = "Night sky"
    if len(files) > 1:
        image.source = "SEQUENCE"
    around = next(node for node in wanted.world.node_tree.nodes if node.type == "TEX_ENVIRONMENT")
    for node in (around, texels_before(of_moon.material_slots[0].material)):
        before, node.image = node.image, image
        if before and before.users == 0:
            bpy.data.images.remove(before)
        if len(files) > 1:
            user = node.image_user
            user.frame_start = textures[0].frame()
            user.frame_offset = textures[0].number() - 1
            user.frame_duration = len(files)
            user.use_auto_refresh = True
