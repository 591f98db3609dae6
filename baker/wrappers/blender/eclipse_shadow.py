# SPDX-License-Identifier: MIT
"""Node group "Eclipse shadow", which computes the ratio of the light on the Moon to full sunlight at a place and time.
It evaluates a formula on a strip image. The command `coppermoon shader` writes the formula into eclipse.json."""
import json
import os

import bpy
import numpy

from . import moon, moonlight
from .nodes import add, first
from .texture import second_of_day
from .wrong import Wrong

NAME = "Eclipse shadow"
# Blender's name and NumPy's function for each operation in a formula.
MATHS = {"add": ("ADD", numpy.add), "subtract": ("SUBTRACT", numpy.subtract), "multiply": ("MULTIPLY", numpy.multiply),
         "divide": ("DIVIDE", numpy.divide), "min": ("MINIMUM", numpy.minimum), "sqrt": ("SQRT", numpy.sqrt),
         "atan2": ("ARCTAN2", numpy.arctan2), "floor": ("FLOOR", numpy.floor)}
FUNCTIONS = {"clamp": lambda a: numpy.clip(a, 0, 1), "mix": lambda a, b, share: a + (b - a) * share,
             "dotproduct": lambda a, b: numpy.sum(a * b, axis=-1, keepdims=True),
             "normalize": lambda a: a / numpy.linalg.norm(a, axis=-1, keepdims=True),
             **{name: function for name, (_, function) in MATHS.items()}}


class Shader:
    """A shader, read from a folder that `coppermoon shader` has made."""

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
        """Seconds from greatest eclipse to a texture's moment, at most half a day in either direction."""
        return (texture.second() - self.greatest + 43200) % 86400 - 43200

    def image(self):
        image = bpy.data.images.load(self.strip, check_existing=True)
        image.colorspace_settings.name = "Non-Color"
        return image

    def texel(self, u, v):
        """Colours of the strip image at (u, v), linearly interpolated. v is measured from the top of the image."""
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
        """Ratios of the light on the Moon to full sunlight, [place][channel].

        Given  places  vectors to places on the Moon in Moon-fixed axes, [place][axis]
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
    """Adds the nodes that compute a shader's formula to a node group."""

    def __init__(self, group, shader):
        self.group, self.shader = group, shader
        self.inputs = add(group, "NodeGroupInput").outputs
        self.sockets, self.count = [], 0

    def node(self, kind, inputs, **settings):
        node = add(self.group, kind, inputs, (200 * (self.count // 8), -160 * (self.count % 8)), hide=True, **settings)
        self.count += 1
        return node

    def number(self, operation, *operands):
        return self.node("Math", enumerate(operands), operation=operation).outputs[0]

    def vector(self, operation, *operands, output=0):
        return self.node("VectorMath", enumerate(operands), operation=operation).outputs[output]

    def scaled(self, vector, number):
        return self.node("VectorMath", {0: vector, "Scale": number}, operation="SCALE").outputs[0]

    def texel(self, u, v):
        place = self.node("CombineXYZ", {0: u, 1: self.number("SUBTRACT", 1.0, v)}).outputs[0]
        return self.node("TexImage", {"Vector": place}, interpolation="Linear", extension="EXTEND",
                         image=self.shader.image()).outputs["Color"]

    def value(self, step):
        operation, of = step["operation"], [self.sockets[operand] for operand in step["from"]]
        if operation in ("place", "time"):
            return self.inputs[operation.capitalize()]
        if operation == "constant":
            return step["value"]
        if operation == "image":
            return self.texel(*of)
        if operation == "clamp":
            return self.node("Clamp", {"Value": of[0]}).outputs[0]
        if operation == "dotproduct":
            return self.vector("DOT_PRODUCT", *of, output="Value")
        if operation == "normalize":
            return self.vector("NORMALIZE", *of)
        if operation == "mix":
            return self.vector("ADD", of[0], self.scaled(self.vector("SUBTRACT", of[1], of[0]), of[2]))
        if step["kind"] == "float":
            return self.number(MATHS[operation][0], *of)
        kinds = [self.shader.steps[operand]["kind"] for operand in step["from"]]
        return self.scaled(*of) if kinds[0] != kinds[1] else self.vector(MATHS[operation][0], *of)


def add_sockets(group):
    """Gives a node group the inputs Place and Time and the output Light."""
    sockets = (("Place", "INPUT", "NodeSocketVector"), ("Time", "INPUT", "NodeSocketFloat"),
               ("Light", "OUTPUT", "NodeSocketColor"))
    for name, way, kind in sockets:
        if hasattr(group, "interface"):  # from Blender 4.0 on
            group.interface.new_socket(name=name, in_out=way, socket_type=kind)
        else:
            (group.inputs if way == "INPUT" else group.outputs).new(kind, name)


def new_group(shader):
    """Node group for a shader. Inputs are a Moon-fixed vector of any length, and the seconds from greatest eclipse."""
    group = bpy.data.node_groups.new(NAME, "ShaderNodeTree")
    add_sockets(group)
    builder = Builder(group, shader)
    for step in shader.steps:
        builder.sockets.append(builder.value(step))
    builder.node("NodeGroupOutput", {"Light": builder.sockets[-1]})
    return group


def drive(owner, path, first, last):
    """Makes a property change linearly with the scene's frame.

    Given  first, last  two pairs (frame, value) that define the line
    """
    slope = (last[1] - first[1]) / (last[0] - first[0])
    owner.driver_remove(path)
    driver = owner.driver_add(path).driver
    driver.type = "SCRIPTED"
    driver.expression = f"{first[1]:.6f} + (frame - {first[0]}) * {slope:.9f}"


def unshadow(material):
    """Removes the nodes of a shader from a material, so that the material shows only its image texture."""
    tree = material.node_tree
    ours = [node for node in tree.nodes if node.name.startswith(NAME)]
    for node in ours:
        group = getattr(node, "node_tree", None)
        tree.nodes.remove(node)
        if group and group.users == 0:
            bpy.data.node_groups.remove(group)
    if ours:
        tree.links.new(first(tree, "TEX_IMAGE").outputs["Color"], first(tree, "EMISSION").inputs["Color"])


def shadow_nodes(material, shader, textures, later):
    """Multiplies a material's image texture of the sunlit Moon by the light that a shader computes for each frame.

    Given  later  image of the sunlit Moon in the last frame, which gradually replaces that of the first frame

    Returned  socket for one more colour by which the result is multiplied
    """
    unshadow(material)
    tree = material.node_tree
    texels, emission = first(tree, "TEX_IMAGE"), first(tree, "EMISSION")
    texels.location = (-900, 0)

    def new(kind, name, at, inputs=(), **settings):
        return add(tree, kind, inputs, at, name=f"{NAME} {name}".strip(), **settings)

    def vector(operation, name, at, inputs):
        return new("VectorMath", name, at, inputs, operation=operation).outputs[0]

    place = new("TexCoord", "place", (-1100, -300)).outputs["Object"]
    group = new("Group", "", (-900, -300), {"Place": place}, node_tree=new_group(shader))
    share = new("Value", "share", (-1100, 450)).outputs[0]
    colour = new("RGB", "factor", (-600, -250)).outputs[0]
    of_first, of_last = texels.outputs["Color"], new(
        "TexImage", "later", (-1200, 250), image=later, interpolation="Linear").outputs["Color"]
    change = vector("SUBTRACT", "change", (-850, 250), {0: of_last, 1: of_first})
    part = vector("SCALE", "part", (-700, 250), {0: change, "Scale": share})
    sunlit = vector("ADD", "sunlit", (-550, 150), {0: of_first, 1: part})
    lit = vector("MULTIPLY", "lit", (-600, 0), {0: sunlit, 1: group.outputs["Light"]})
    tree.links.new(vector("MULTIPLY", "phase", (-300, -150), {0: lit, 1: colour}), emission.inputs["Color"])
    frames = textures[0], textures[-1]
    drive(share, "default_value", *((texture.frame(), end) for end, texture in enumerate(frames)))
    drive(group.inputs["Time"], "default_value", *((texture.frame(), shader.time(texture)) for texture in frames))
    return colour


def shade(material, shader, sunlit, textures, lights):
    """Makes a material show a film by means of a shader. Each frame gets the brightness of its small texture.

    Given  sunlit    textures of the sunlit Moon in the first and the last frame; the material already shows the first
           textures  small textures of the film, whose headers give the observer's position
           lights    illuminance by the Moon [lux] in each channel, for each texture
    """
    factor = shadow_nodes(material, shader, textures, moon.image_of(sunlit[1]))
    before, after = (moonlight.shrunk(one) for one in sunlit)
    places = moonlight.places_of_texels()
    for i, (texture, lux) in enumerate(zip(textures, lights)):
        texels = before + (after - before) * (i / (len(textures) - 1))
        shaded = moonlight.illuminance(texels * shader.light(places, shader.time(texture)), texture)
        factor.default_value = (*(true / ours if ours > 0 else 1 for true, ours in zip(lux, shaded)), 1)
        factor.keyframe_insert("default_value", frame=texture.frame())
