# SPDX-License-Identifier: MIT
"""Textures of a Moon's values, by the program; and the scene built from them."""
import hashlib
import json
import os

from . import film, moon, moonlight, observer, preferences, program, values
from .texture import Texture, textures_of


class Baked:
    """Textures in the order of their frames, the light of each disc, and contacts by name.

    Given  measured  illuminance by path, as far as it is known already
    """

    def __init__(self, textures, contacts=None, measured=None):
        self.textures, self.contacts = textures, contacts or {}
        self.lights = [(measured or {}).get(texture.path) or light_of(texture) for texture in textures]


def light_of(texture):
    return moonlight.illuminance(texture, moon.set_colours(texture))


def seconds_of(contact):
    """The time of day of 2018-07-27T19:30:17Z."""
    hours, minutes, seconds = contact.rstrip("Z").split("T")[-1].split(":")
    return 3600 * int(hours) + 60 * int(minutes) + float(seconds)


def parts_of(contacts):
    """The part of the time from P1 to P4 that has passed at each contact, of an eclipse shorter than a day."""
    since_first = {name: (seconds_of(time) - seconds_of(contacts["P1"])) % 86400
                   for name, time in contacts.items()}
    return {name: since / since_first["P4"] for name, since in since_first.items()}


def eclipses(first, last):
    """Yields as `program.run`; returns what the almanac says of the eclipses between two moments."""
    lines = []
    yield from program.run(["almanac", "--json", f"--from={first}", f"--to={last}"], lines.append)
    return json.loads("".join(lines))


def bake_moment(wanted):
    lines = []
    yield from program.run(["bake", values.moment(wanted), *values.options(wanted),
                            f"--cache={preferences.texture_folder()}"], lines.append)
    return Baked([Texture(lines[-1])])


def film_folder(words):
    """Its name says what the film is made from."""
    name = hashlib.sha256("\n".join(words).encode()).hexdigest()[:12]
    return os.path.join(preferences.texture_folder(), f"{words[1]}_{name}")


def bake_film(wanted):
    day = values.day_of(wanted)
    contacts = {}
    for eclipse in (yield from eclipses(day, f"{day}T23:59:59Z")):
        contacts = parts_of(eclipse["contacts"])
    words = ["animate", day, *values.options(wanted), f"--frames={wanted.frames}", "--make=textures"]
    folder = film_folder(words)
    os.makedirs(folder, exist_ok=True)
    measured = {}  # as they come, so that it takes no time at the end

    def take(line):
        for file in json.loads(line).get("files", ()):
            texture = Texture(os.path.join(folder, os.path.basename(file)))
            measured[texture.path] = light_of(texture)

    for what, part in program.run([*words, "--json", "--replace", f"--output={folder}"], take):
        frames = len(measured)
        if frames:
            what, part = f"frame {frames} of {wanted.frames}", frames / wanted.frames
        yield what, part
    return Baked(textures_of(folder), contacts, measured)


def bake(wanted):
    """Yields (what, part done) while the program works, and returns Baked. Closing it ends the program.

    Given  wanted  plain values
    """
    values.require_sound(wanted)
    return (yield from (bake_film if wanted.film else bake_moment)(wanted))


def show(of_moon, baked):
    """Has the Moon, its light, its observer and its scene be those of these textures."""
    wanted = of_moon.coppermoon
    moon.put_textures(of_moon, baked.textures)
    if wanted.lamp:
        moonlight.place_lamp(wanted.lamp, baked.textures, baked.lights)
    if wanted.scene:
        film.set_exposure(wanted.scene, baked.textures, baked.lights)
        film.set_time(wanted.scene, baked.textures, baked.contacts)
    if wanted.camera:
        render = (wanted.scene or wanted.camera.users_scene[0]).render
        observer.place_camera(wanted.camera, baked.textures, wanted.up, wanted.field, render)


def new_eclipse(context, own_scene):
    """A Moon that does not shine yet, with its light; with a scene of its own an observer too."""
    scene = film.new_scene() if own_scene else context.scene
    of_moon = moon.new_moon(scene)
    wanted = of_moon.coppermoon
    wanted.is_moon = True
    wanted.lamp = moonlight.new_lamp(scene, of_moon)
    if own_scene:
        wanted.scene = scene
        wanted.camera = scene.camera = observer.new_camera(scene, of_moon)
        context.window.scene = scene
    for other in context.view_layer.objects:
        other.select_set(False)
    of_moon.select_set(True)
    context.view_layer.objects.active = of_moon
    return of_moon
