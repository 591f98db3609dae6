# SPDX-License-Identifier: MIT
"""Moon and stars in the sky of the user's own scene: +X is east, +Y north, +Z up; the observer is at the origin."""
import json
import math

import bpy
from mathutils import Matrix, Quaternion, Vector

from . import program, values
from .nodes import add, emptied
from .observer import axes_of, turn
from .texture import MOON_RADIUS_KM, key

NEARER = 1000  # how many times nearer and smaller the Moon is than in reality: 380 km off, radius 1.7 km
BEYOND = 1.2  # ratio of the stars' distance to the Moon's
NAKED_EYE = 6.5  # magnitude of the faintest star
NONE = -5  # brighter than any star


def direction(place):
    """Unit vector towards a place in the sky. The program gives the place's altitude and azimuth in degrees."""
    altitude = math.radians(place["altitude_deg"])
    azimuth = math.radians(place["azimuth_deg"])
    return Vector((math.cos(altitude) * math.sin(azimuth), math.cos(altitude) * math.cos(azimuth), math.sin(altitude)))


def skies(wanted, textures):
    """Returns the sky's state for each texture, the first with stars. Yields progress as `program.run` does."""
    accounts = []
    for texture in textures:
        lines = yield from program.run(["sky", f"--instant={texture.instant()}", f"--at={wanted.place.strip()}",
                                        "--json", f"--stars={NONE if accounts else NAKED_EYE}"])
        accounts.append(json.loads("".join(lines)))
    return accounts


def scale(scene):
    """Radius of the sphere that represents the Moon, in the scene's units of length."""
    return 1000 * MOON_RADIUS_KM / NEARER / scene.unit_settings.scale_length


def hang_moon(moon, scene, textures, skies_seen):
    """Puts the Moon where the observer sees it, in its apparent size and orientation."""
    moon.rotation_mode = "QUATERNION"
    moon.scale = [scale(scene)] * 3
    for texture, sky in zip(textures, skies_seen):
        to_moon = direction(sky)
        moon.location = scale(scene) * texture.distance * to_moon
        right = to_moon.cross(Vector((0, 0, 1))).normalized()
        seen = Matrix((right, right.cross(to_moon), -to_moon)).transposed()
        turn(moon, (seen @ Matrix(axes_of(texture, "zenith"))).transposed())
        key(moon, texture, "location", "rotation_quaternion")


def star_material():
    """A material whose light adds to the light of the sky behind it."""
    material = bpy.data.materials.new("Stars")
    tree = emptied(material)
    light = add(tree, "Attribute", attribute_name="Light")
    emission = add(tree, "Emission", {"Color": light.outputs["Color"]})
    both = add(tree, "AddShader", {0: emission.outputs[0], 1: add(tree, "BsdfTransparent").outputs[0]})
    add(tree, "OutputMaterial", {"Surface": both.outputs[0]})
    return material


def star_mesh(stars, distance, side):
    """A mesh with one square for each star, facing the origin.

    Given  side  angle across each square [rad]; the star's illuminance is spread over the square
    """
    corners, lights = [], []
    for star in stars:
        toward = direction(star)
        across = toward.orthogonal().normalized()
        up = toward.cross(across)
        for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            corners.append(distance * (toward + math.tan(side / 2) * (x * across + y * up)))
            lights.extend([lux / side ** 2 for lux in star["illuminance_lux"]] + [1])
    mesh = bpy.data.meshes.new("Stars")
    mesh.from_pydata(corners, [], [range(k, k + 4) for k in range(0, len(corners), 4)])
    mesh.attributes.new("Light", "FLOAT_COLOR", "POINT").data.foreach_set("color", lights)
    return mesh


def pixel(scene):
    """Angle of view of a pixel in the middle of the scene's picture [rad]."""
    data, render = scene.camera.data, scene.render
    return 2 * math.tan(data.angle / 2) / max(render.resolution_x, render.resolution_y)


def hang_stars(stars, scene, textures, skies_seen):
    """Puts the stars of the first moment behind the Moon. In a film they rotate about the celestial pole."""
    side = 2 * pixel(scene) if scene.camera else math.radians(0.05)
    old = stars.data
    stars.data = star_mesh(skies_seen[0]["stars"], BEYOND * scale(scene) * textures[0].distance, side)
    stars.data.materials.append(old.materials[0])
    bpy.data.meshes.remove(old)
    latitude = math.radians(skies_seen[0]["observer_latitude_deg"])
    pole = Vector((0, math.cos(latitude), math.sin(latitude)))
    for texture in textures:
        angle = math.tau * 1.0027379 * ((texture.second() - textures[0].second()) % 86400) / 86400
        stars.rotation_quaternion = Quaternion(pole, -angle)
        key(stars, texture, "rotation_quaternion")


def new_stars(scene):
    mesh = bpy.data.meshes.new("Stars")
    mesh.materials.append(star_material())
    stars = bpy.data.objects.new("Stars", mesh)
    stars.rotation_mode = "QUATERNION"
    stars.visible_diffuse = stars.visible_volume_scatter = stars.visible_shadow = False
    scene.collection.objects.link(stars)
    return stars


def hang(moon, scene, textures, skies_seen):
    """Puts the Moon and the stars into the sky, and extends the camera's clipping distance to include them."""
    wanted = moon.coppermoon
    for thing in (moon, wanted.stars):
        thing.animation_data_clear()
    hang_moon(moon, scene, textures, skies_seen)
    hang_stars(wanted.stars, scene, textures, skies_seen)
    if scene.camera:
        farthest = 2 * BEYOND * scale(scene) * max(texture.distance for texture in textures)
        values.put(wanted, scene.camera.data, clip_end=max(scene.camera.data.clip_end, farthest))
