# SPDX-License-Identifier: MIT
"""The observer's camera. The Moon has radius 1 and stands at the origin, with longitude 0 at +X, 90° east at +Y and
north at +Z."""
import math

import bpy
from mathutils import Matrix, Vector

from . import values
from .texture import key


def axes_of(texture, up):
    """Unit vectors that point right, up and backwards (towards the observer) from the camera."""
    latitude, longitude = math.radians(texture.latitude), math.radians(texture.longitude)
    east = Vector((-math.sin(longitude), math.cos(longitude), 0))
    back = Vector((math.cos(latitude) * math.cos(longitude),
                   math.cos(latitude) * math.sin(longitude), math.sin(latitude)))
    north = back.cross(east)
    # Position angles are measured counter-clockwise in the picture, where the Moon's east is on the right.
    turn = {"moon-north": lambda: 0,
            "celestial-north": lambda: texture.axis,
            "zenith": lambda: texture.axis - texture.attribute("parallactic_angle")}[up]()
    cosine, sine = math.cos(math.radians(turn)), math.sin(math.radians(turn))
    return cosine * east - sine * north, cosine * north + sine * east, back


def turn(thing, axes):
    """Rotates an object so that its X, Y and Z point along given axes. Turns the shorter way from its last rotation."""
    turned = Matrix(axes).transposed().to_quaternion()
    turned.make_compatible(thing.rotation_quaternion)
    thing.rotation_quaternion = turned


def new_camera(scene, moon):
    camera = bpy.data.objects.new("Observer", bpy.data.cameras.new("Observer"))
    camera.rotation_mode = "QUATERNION"
    camera.parent = moon
    scene.collection.objects.link(camera)
    return camera


def set_lens(data, render, wanted):
    """Fits the field of view into the picture's shorter side, unless the user has changed the lens."""
    wide = render.resolution_x * render.pixel_aspect_x > render.resolution_y * render.pixel_aspect_y
    # The focal length is set, because Blender accepts no angle of view below 0.37 degrees.
    side = data.sensor_height if wide else data.sensor_width
    values.put(wanted, data, anew=values.changed(wanted, "field"),
               sensor_fit="VERTICAL" if wide else "HORIZONTAL", lens=side / 2 / math.tan(wanted.field / 2))


def place_camera(camera, textures, wanted, render):
    """Puts the camera where the observer is, in each frame of a film.

    Given  wanted  the values that the user has set for the Moon
    """
    data = camera.data
    set_lens(data, render, wanted)
    values.put(wanted, data, clip_start=0.1, clip_end=max(texture.distance for texture in textures) + 1)
    camera.animation_data_clear()
    for texture in textures:
        axes = axes_of(texture, wanted.up)
        camera.location = texture.distance * axes[2]
        turn(camera, axes)
        key(camera, texture, "location", "rotation_quaternion")
