# SPDX-License-Identifier: MIT
"""Moonlight in a scene: a Sun lamp, whose strength is illuminance in lux where radiance is luminance in cd/m²."""
import array
import math

import bpy

from .observer import axes_of, turn

ROWS = 128  # of the texture, shrunk; to 0.2 % of its light


def shrunk(path, set_colours):
    """Texels of a texture, [row][column][RGBA] from the south up, scene-linear."""
    image = bpy.data.images.load(path)
    try:
        set_colours(image)
        image.scale(2 * ROWS, ROWS)
        texels = array.array("f", bytes(4 * 4 * 2 * ROWS * ROWS))
        image.pixels.foreach_get(texels)
        return texels
    finally:
        bpy.data.images.remove(image)


def illuminance(texture, set_colours):
    """Illuminance by channel [lux] of a surface at the observer's place that faces the Moon:

        E = sum L cos e dA / d^2        e: emission angle, d: texel to observer
    """
    texels = shrunk(texture.path, set_colours)
    distance = texture.distance
    step = math.pi / ROWS
    south = math.radians(texture.latitude)
    across = [math.cos(step * (i + 0.5) - math.pi - math.radians(texture.longitude))
              for i in range(2 * ROWS)]
    sums = [0.0, 0.0, 0.0]
    for j in range(ROWS):
        latitude = step * (j + 0.5) - math.pi / 2
        area = step * step * math.cos(latitude)
        along, level = (distance * math.sin(latitude) * math.sin(south),
                        distance * math.cos(latitude) * math.cos(south))
        for i, cosine in enumerate(across):
            height = along + level * cosine  # of the observer above the texel's horizon, plus 1
            if height <= 1:
                continue
            squared = distance * distance + 1 - 2 * height
            weight = area * (height - 1) / (squared * math.sqrt(squared))
            k = 4 * (2 * ROWS * j + i)
            for c in range(3):
                sums[c] += weight * texels[k + c]
    return [max(0.0, value) for value in sums]


# Luminance of each channel in the spaces that Blender 5 works in, by the Color Interop Forum's names.
LUMINANCE = {
    "lin_rec709_scene": (0.2126, 0.7152, 0.0722),
    "lin_rec2020_scene": (0.2627, 0.6780, 0.0593),
    "lin_ap1_scene": (0.2676, 0.6744, 0.0580),  # adapted from its own white to D65
}


def luminance(colour):
    """Luminance of a colour in the space that Blender works in: before Blender 5, linear Rec.709."""
    space = getattr(getattr(bpy.data, "colorspace", None), "working_space_interop_id", "")
    weights = LUMINANCE.get(space, LUMINANCE["lin_rec709_scene"])
    return sum(weight * channel for weight, channel in zip(weights, colour))


def new_lamp(scene, moon):
    """Lets the sphere be seen, straight and in mirrors, but not light the scene, which the lamp does."""
    lamp = bpy.data.objects.new("Moonlight", bpy.data.lights.new("Moonlight", "SUN"))
    lamp.rotation_mode = "QUATERNION"
    lamp.parent = moon
    lamp.visible_glossy = lamp.visible_transmission = False
    moon.visible_diffuse = moon.visible_volume_scatter = moon.visible_shadow = False
    scene.collection.objects.link(lamp)
    return lamp


def keep_dim_light(scene):
    """Ends Cycles' threshold below which light is dropped at random: moonlight is below its default."""
    if hasattr(scene, "cycles"):
        scene.cycles.light_sampling_threshold = 0


def place_lamp(lamp, textures, lights):
    """Has the lamp shine from the Moon to the observer, as bright as the disc, in each frame of a film.

    Given  lights  illuminance by channel [lux], of each texture
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
        if len(textures) > 1:
            frame = texture.frame()
            lamp.keyframe_insert("rotation_quaternion", frame=frame)
            for path in ("energy", "color", "angle"):
                data.keyframe_insert(path, frame=frame)
