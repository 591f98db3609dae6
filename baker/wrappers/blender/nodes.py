# SPDX-License-Identifier: MIT
"""Nodes of a material or a world, made and linked in one step."""
import bpy


def add(tree, kind, inputs=(), at=(0, 0), **settings):
    """New node of a tree.

    Given  kind    its type, without "ShaderNode"
           inputs  by name or number: sockets that they are linked to, or values
    """
    node = tree.nodes.new(kind if kind.startswith("NodeGroup") else f"ShaderNode{kind}")
    node.location = at
    for name, value in settings.items():
        setattr(node, name, value)
    for name, value in dict(inputs).items():
        if isinstance(value, bpy.types.NodeSocket):
            tree.links.new(value, node.inputs[name])
        else:
            node.inputs[name].default_value = value
    return node


def first(tree, kind):
    """First node of a type, as "TEX_IMAGE"; None where there is none."""
    return next((node for node in tree.nodes if node.type == kind), None)


def emptied(owner):
    """Node tree of a new material or world, without nodes."""
    if owner.node_tree is None:  # before Blender 5
        owner.use_nodes = True
    owner.node_tree.nodes.clear()
    return owner.node_tree


def show(node, image, textures):
    """Has a node show an image; of a film, in each frame of the scene the file of that frame."""
    before, node.image = node.image, image
    if before and before.users == 0:
        bpy.data.images.remove(before)
    if len(textures) > 1:
        image.source = "SEQUENCE"
        user = node.image_user
        user.frame_start = textures[0].frame()
        user.frame_offset = textures[0].number() - 1
        user.frame_duration = len(textures)
        user.use_auto_refresh = True
