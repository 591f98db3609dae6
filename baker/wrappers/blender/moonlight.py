# SPDX-License-Identifier: MIT
"""Moonlight in a scene, as a lamp of type Sun. Its strength is the illuminance in lux, because radiance is in cd/m²."""
import math

import bpy
import numpy

from .moon import set_colours
from .observer import axes_of, turn
from .texture import key

ROWS = 128  # of the shrunk texture; enough for its light to 0.2 %


def shrunk(texture):
    """Shrinks a texture to ROWS rows. Returns its scene-linear texels, [row × column][RGB], from south to north."""
    image = bpy.data.images.load(texture.path)
    try:
        set_colours(image, texture)
        image.scale(2 * ROWS, ROWS)
        texels = numpy.empty(4 * 2 * ROWS * ROWS, dtype=numpy.float32)
        image.pixels.foreach_get(texels)
        return texels.reshape(-1, 4)[:, :3]
    finally:
        bpy.data.images.remove(image)


def places_of_texels():
    """Unit vectors from the Moon's centre to a shrunk texture's texels, in Moon-fixed axes, [row × column][axis]."""
    step = numpy.pi / ROWS
    latitude, longitude = numpy.meshgrid(step * (numpy.arange(ROWS) + 0.5) - numpy.pi / 2,
                                         step * (numpy.arange(2 * ROWS) + 0.5) - numpy.pi, indexing="ij")
    places = (numpy.cos(latitude) * numpy.cos(longitude), numpy.cos(latitude) * numpy.sin(longitude),
              numpy.sin(latitude))
    return numpy.stack(places, axis=-1).reshape(-1, 3)


def illuminance(texels, texture):
    """Illuminance by channel [lux] on a surface that faces the Moon at the observer's place:

        E = sum L cos e dA / d^2        e: emission angle, dA: area of a texel, d: its distance from the observer

    Given  texels   luminances L by channel, from `shrunk`
           texture  texture whose header gives the observer's position
    """
    places = places_of_texels()
    south, east = math.radians(texture.latitude), math.radians(texture.longitude)
    observer = texture.distance * numpy.array([math.cos(south) * math.cos(east), math.cos(south) * math.sin(east),
                                               math.sin(south)])
    height = places @ observer  # the observer's height above the texel's horizon, plus 1
    squared = texture.distance ** 2 + 1 - 2 * height
    area = (math.pi / ROWS) ** 2 * numpy.sqrt(1 - places[:, 2] ** 2)
    weight = area * numpy.maximum(height - 1, 0) / squared ** 1.5
    return [max(0.0, float(value)) for value in weight @ texels]


# Luminance of one unit of red, green and blue in Blender 5's working spaces. Keys are names by the Color Interop Forum.
LUMINANCE = {
    "lin_rec709_scene": (0.2126, 0.7152, 0.0722),
    "lin_rec2020_scene": (0.2627, 0.6780, 0.0593),
    "lin_ap1_scene": (0.2676, 0.6744, 0.0580),  # adapted from its own white point to D65
}


def luminance(colour):
    """Luminance of a colour in Blender's working space. Before Blender 5, that space is linear Rec.709."""
    space = getattr(getattr(bpy.data, "colorspace", None), "working_space_interop_id", "")
    weights = LUMINANCE.get(space, LUMINANCE["lin_rec709_scene"])
    return sum(weight * channel for weight, channel in zip(weights, colour))


def new_lamp(scene, moon):
    """Adds a lamp that lights the scene in place of the Moon's sphere, which stays visible directly and in mirrors."""
    lamp = bpy.data.objects.new("Moonlight", bpy.data.lights.new("Moonlight", "SUN"))
    lamp.rotation_mode = "QUATERNION"
    lamp.parent = moon
    lamp.visible_glossy = lamp.visible_transmission = False
    moon.visible_diffuse = moon.visible_volume_scatter = moon.visible_shadow = False
    scene.collection.objects.link(lamp)
    return lamp


def keep_dim_light(scene):
    """Turns off the threshold below which Cycles drops light at random, because moonlight is below Cycles' default."""
    if hasattr(scene, "cycles"):
        scene.cycles.light_sampling_threshold = 0


def place_lamp(lamp, textures, lights):
    """Makes the lamp shine from the Moon towards the observer, as brightly as the disc, in each frame of a film.

    Given  lights  illuminance by the Moon [lux] in each channel, for each texture
    """
    data = lamp.data
    for owner in (lamp, data):
        owner.animation_data_clear()
    for texture, lux in zip(textures, lights):
        right, upward, back = axes_of(texture, "moon-north")
        turn(lamp, (-right, upward, -back))  # a lamp shines along its -Z
        bright = luminance(lux)
        data.energy = bright
        data.color = [value / bright for value in lux] if bright > 0 else (1, 1, 1)
        data.angle = 2 * math.asin(1 / texture.distance)
        key(lamp, texture, "rotation_quaternion")
        key(data, texture, "energy", "color", "angle")
