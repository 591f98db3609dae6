# SPDX-License-Identifier: MIT
"""Node group "Eclipse shadow": light on the Moon over full sunlight at a place and a time, from a strip and the steps of
a formula that `coppermoon shader` writes into eclipse.json."""
import json
import os

import bpy
import numpy

from . import moon, moonlight
from .texture import second_of_day
from .wrong import Wrong

NAME = "Eclipse shadow"
MATHS = {"add": "ADD", "subtract": "SUBTRACT", "multiply": "MULTIPLY", "divide": "DIVIDE", "min": "MINIMUM",
         "sqrt": "SQRT", "atan2": "ARCTAN2", "floor": "FLOOR"}
FUNCTIONS = {"add": numpy.add, "subtract": numpy.subtract, "multiply": numpy.multiply, "divide": numpy.divide,
             "min": numpy.minimum, "sqrt": numpy.sqrt, "atan2": numpy.arctan2, "floor": numpy.floor,
             "clamp": lambda a: numpy.clip(a, 0, 1), "mix": lambda a, b, share: a + (b - a) * share,
             "dotproduct": lambda a, b: numpy.sum(a * b, axis=-1, keepdims=True),
             "normalize": lambda a: a / numpy.linalg.norm(a, axis=-1, keepdims=True)}


class Shader:
    """Folder of `coppermoon shader`."""

    def __init__(self, folder):
        path = os.path.join(folder, "eclipse.json")
        try:
            with open(path, encoding="utf-8") as file:
                facts = json.load(file)
            self.steps, self.greatest = facts["steps"], second_of_day(facts["greatest"])
            self.strip = os.path.join(folder, facts["strip"])
        except OSError as error:
            raise Wrong(f"{path}: {error.strerror}") from error
        except (ValueError, KeyError) as error:
            raise Wrong(f"{path}: is not of coppermoon's shader") from error
        self.texels = None

    def time(self, texture):
        """Seconds from greatest eclipse to a texture's moment, at most half a day."""
        return (texture.second() - self.greatest + 43200) % 86400 - 43200

    def image(self):
        image = bpy.data.images.load(self.strip, check_existing=True)
        image.colorspace_settings.name = "Non-Color"
        return image

    def texel(self, u, v):
        """Texels between straight lines, v from the image's top."""
        if self.texels is None:
            image = self.image()
            width, height = image.size
            texels = numpy.empty(width * height * 4, dtype=numpy.float32)
            image.pixels.foreach_get(texels)
            self.texels = texels.reshape(height, width, 4)[::-1, :, :3]
        height, width, _ = self.texels.shape
        x, y = numpy.clip(u * width - 0.5, 0, width - 1.001), numpy.clip(v * height - 0.5, 0, height - 1.001)
        i, j = x[:, 0].astype(int), y[:, 0].astype(int)
        right, down = x - i[:, None], y - j[:, None]
        above = self.texels[j, i] * (1 - right) + self.texels[j, i + 1] * right
        return above * (1 - down) + (self.texels[j + 1, i] * (1 - right) + self.texels[j + 1, i + 1] * right) * down

    def light(self, places, time):
        """Light over sunlight, [place][channel].

        Given  places  [place][axis], Moon-fixed
               time    seconds from greatest eclipse
        """
        values = []
        for step in self.steps:
            of = [values[operand] for operand in step["from"]]
            operation = step["operation"]
            values.append(places if operation == "place" else numpy.full((1, 1), float(time)) if operation == "time"
                          else numpy.atleast_2d(step["value"]) if operation == "constant"
                          else self.texel(*of) if operation == "image" else FUNCTIONS[operation](*of))
        return values[-1]


class Builder:
    """Nodes of the formula's steps in a group."""

    def __init__(self, group, shader):
        self.nodes, self.links, self.shader = group.nodes, group.links, shader
        self.inputs = self.nodes.new("NodeGroupInput")
        self.sockets, self.count = [], 0

    def node(self, kind, **settings):
        node = self.nodes.new(kind)
        node.location = (200 * (self.count // 8), -160 * (self.count % 8))
        node.hide = True
        self.count += 1
        for name, value in settings.items():
            setattr(node, name, value)
        return node

    def put(self, socket, value):
        """Links a socket, or sets its value."""
        if isinstance(value, bpy.types.NodeSocket):
            self.links.new(value, socket)
        else:
            socket.default_value = value

    def made(self, kind, operation, *operands, output=0):
        node = self.node(kind, operation=operation)
        for socket, operand in zip(node.inputs, operands):
            self.put(socket, operand)
        return node.outputs[output]

    def scaled(self, vector, number):
        node = self.node("ShaderNodeVectorMath", operation="SCALE")
        self.put(node.inputs[0], vector)
        self.put(node.inputs["Scale"], number)
        return node.outputs[0]

    def texel(self, u, v):
        across = self.made("ShaderNodeMath", "SUBTRACT", 1.0, v)
        place = self.node("ShaderNodeCombineXYZ")
        self.put(place.inputs[0], u)
        self.put(place.inputs[1], across)
        image = self.node("ShaderNodeTexImage", interpolation="Linear", extension="EXTEND", image=self.shader.image())
        self.links.new(place.outputs[0], image.inputs["Vector"])
        return image.outputs["Color"]

    def value(self, step):
        operation, of = step["operation"], [self.sockets[operand] for operand in step["from"]]
        if operation == "place":
            return self.inputs.outputs["Place"]
        if operation == "time":
            return self.inputs.outputs["Time"]
        if operation == "constant":
            return step["value"]
        if operation == "image":
            return self.texel(*of)
        if operation == "clamp":
            node = self.node("ShaderNodeClamp")
            self.put(node.inputs["Value"], of[0])
            return node.outputs[0]
        if operation == "dotproduct":
            return self.made("ShaderNodeVectorMath", "DOT_PRODUCT", *of, output="Value")
        if operation == "normalize":
            return self.made("ShaderNodeVectorMath", "NORMALIZE", *of)
        if step["kind"] == "float":
            return self.made("ShaderNodeMath", MATHS[operation], *of)
        if operation == "mix":
            further = self.made("ShaderNodeVectorMath", "SUBTRACT", of[1], of[0])
            return self.made("ShaderNodeVectorMath", "ADD", of[0], self.scaled(further, of[2]))
        kinds = [self.shader.steps[operand]["kind"] for operand in step["from"]]
        if operation == "multiply" and kinds[0] != kinds[1]:
            return self.scaled(*of)
        return self.made("ShaderNodeVectorMath", MATHS[operation], *of)


def add_sockets(group):
    """Place and Time come in, Light goes out."""
    sockets = (("Place", "INPUT", "NodeSocketVector"), ("Time", "INPUT", "NodeSocketFloat"),
               ("Light", "OUTPUT", "NodeSocketColor"))
    for name, way, kind in sockets:
        if hasattr(group, "interface"):  # from Blender 4.0 on
            group.interface.new_socket(name=name, in_out=way, socket_type=kind)
        else:
            (group.inputs if way == "INPUT" else group.outputs).new(kind, name)


def new_group(shader):
    """Node group of a shader: place (Moon-fixed, of any length) and time (seconds from greatest eclipse) in."""
    group = bpy.data.node_groups.new(NAME, "ShaderNodeTree")
    add_sockets(group)
    builder = Builder(group, shader)
    for step in shader.steps:
        builder.sockets.append(builder.value(step))
    output = builder.node("NodeGroupOutput")
    builder.links.new(builder.sockets[-1], output.inputs["Light"])
    return group


def drive(owner, path, first, last):
    """Has a property follow the scene's frame along a straight line.

    Given  first, last  (frame, value)
    """
    slope = (last[1] - first[1]) / (last[0] - first[0])
    owner.driver_remove(path)
    driver = owner.driver_add(path).driver
    driver.type = "SCRIPTED"
    driver.expression = f"{first[1]:.6f} + (frame - {first[0]}) * {slope:.9f}"


def unshadow(material):
    """Has a material show its image texture alone."""
    nodes, links = material.node_tree.nodes, material.node_tree.links
    ours = [node for node in nodes if node.name.startswith(NAME)]
    for node in ours:
        group = getattr(node, "node_tree", None)
        nodes.remove(node)
        if group and group.users == 0:
            bpy.data.node_groups.remove(group)
    if ours:
        texels = next(node for node in nodes if node.type == "TEX_IMAGE")
        emission = next(node for node in nodes if node.type == "EMISSION")
        links.new(texels.outputs["Color"], emission.inputs["Color"])


def shadow_nodes(material, shader, textures, later):
    """Multiplies a material's image texture, the sunlit Moon, by the light of a shader, in each frame at its time.

    Given  later  image of the sunlit Moon in the last frame, to which that of the first gives way

    Returned  socket of a colour that is multiplied too
    """
    tree = material.node_tree
    nodes, links = tree.nodes, tree.links
    unshadow(material)
    texels = next(node for node in nodes if node.type == "TEX_IMAGE")
    emission = next(node for node in nodes if node.type == "EMISSION")

    def new(kind, name, x, y, **settings):
        node = nodes.new(kind)
        node.name, node.location = f"{NAME} {name}".strip(), (x, y)
        for setting, value in settings.items():
            setattr(node, setting, value)
        return node

    place = new("ShaderNodeTexCoord", "place", -1100, -300)
    last_texels = new("ShaderNodeTexImage", "later", -1200, 250, image=later, interpolation="Linear")
    share = new("ShaderNodeValue", "share", -1100, 450)
    change = new("ShaderNodeVectorMath", "change", -850, 250, operation="SUBTRACT")
    part = new("ShaderNodeVectorMath", "part", -700, 250, operation="SCALE")
    sunlit = new("ShaderNodeVectorMath", "sunlit", -550, 150, operation="ADD")
    group = new("ShaderNodeGroup", "", -900, -300, node_tree=new_group(shader))
    lit = new("ShaderNodeVectorMath", "lit", -600, 0, operation="MULTIPLY")
    changed = new("ShaderNodeVectorMath", "phase", -300, -150, operation="MULTIPLY")
    colour = new("ShaderNodeRGB", "factor", -600, -250)
    links.new(place.outputs["Object"], group.inputs["Place"])
    texels.location = (-900, 0)
    links.new(last_texels.outputs["Color"], change.inputs[0])
    links.new(texels.outputs["Color"], change.inputs[1])
    links.new(change.outputs[0], part.inputs[0])
    links.new(share.outputs[0], part.inputs["Scale"])
    links.new(texels.outputs["Color"], sunlit.inputs[0])
    links.new(part.outputs[0], sunlit.inputs[1])
    links.new(sunlit.outputs[0], lit.inputs[0])
    links.new(group.outputs["Light"], lit.inputs[1])
    links.new(lit.outputs[0], changed.inputs[0])
    links.new(colour.outputs[0], changed.inputs[1])
    links.new(changed.outputs[0], emission.inputs["Color"])
    first, last = textures[0], textures[-1]
    drive(share.outputs[0], "default_value", (first.frame(), 0), (last.frame(), 1))
    drive(group.inputs["Time"], "default_value", (first.frame(), shader.time(first)),
          (last.frame(), shader.time(last)))
    return colour.outputs[0]


def shade(material, shader, sunlit, textures, lights):
    """Has a material show a film by a shader, as bright in each frame as its texture is.

    Given  sunlit    textures of the sunlit Moon in the first and in the last frame; the first is in the material
           textures  of the film, in little, with the observer of each frame
           lights    illuminance by channel [lux], of each texture
    """
    factor = shadow_nodes(material, shader, textures, moon.image_of(sunlit[1]))
    first, last = (moonlight.shrunk(one.path, moon.set_colours(one)) for one in sunlit)
    places = moonlight.places_of_texels()
    for i, (texture, lux) in enumerate(zip(textures, lights)):
        texels = first + (last - first) * (i / (len(textures) - 1))
        shaded = moonlight.illuminance(texels * shader.light(places, shader.time(texture)), texture)
        factor.default_value = (*(true / ours if ours > 0 else 1 for true, ours in zip(lux, shaded)), 1)
        factor.keyframe_insert("default_value", frame=texture.frame())
