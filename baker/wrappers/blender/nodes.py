# SPDX-License-Identifier: MIT
"""Functions that add nodes to a material or a world, and link them."""
import bpy


def add(tree, kind, inputs=(), at=(0, 0), **settings):
    """Adds a node to a tree.

    Given  kind    type of the node without the prefix "ShaderNode"
           inputs  maps the name or number of an input to its value, or to a socket to link it to
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
    """The first node of the given type, such as "TEX_IMAGE". None if the tree has no such node."""
    return next((node for node in tree.nodes if node.type == kind), None)


def emptied(owner):
    """Removes all nodes from the node tree of a new material or world, and returns the tree."""
    if owner.node_tree is None:  # before Blender 5
        owner.use_nodes = True
    owner.node_tree.nodes.clear()
    return owner.node_tree


def show(node, image, textures):
    """Makes a node show an image or, for a film, one image in each frame of the scene."""
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
