# SPDX-License-Identifier: MIT
"""Runs the program coppermoon to bake a Moon's textures, and builds the scene from them."""
import hashlib
import json
import os

from . import eclipse_shadow, film, moon, moonlight, night, observer, preferences, program, sky, values
from .texture import Texture, second_of_day, textures_of


class Baked:
    """Results of a bake: textures in the order of their frames, the Moon's illuminance for each of them, and contacts.

    Given  contacts  moments of the contacts in UTC, by name
           shaded    the film's shader, and textures of the sunlit Moon; None if the film uses no shader
           measured  illuminances that are already known, by texture path
           skies     descriptions of the sky, one for each texture; None if the Moon has a scene of its own
           domes     image files of the night sky, one for each texture; None unless requested
    """

    def __init__(self, textures, contacts=None, measured=None, shaded=None):
        self.textures, self.contacts, self.shaded = textures, contacts or {}, shaded
        self.skies = self.domes = None
        self.lights = [(measured or {}).get(texture.path) or light_of(texture) for texture in textures]


def light_of(texture):
    return moonlight.illuminance(moonlight.shrunk(texture), texture)


def parts_of(contacts, textures):
    """Time of each contact, as a fraction of the film from first to last texture. Assumes a film shorter than a day."""
    if not contacts:
        return {}
    first = textures[0].second()
    length = (textures[-1].second() - first) % 86400
    # Texture headers give whole seconds, so the first and the last contact may lie half a second outside the film.
    since = {name: (second_of_day(moment) - first + 1) % 86400 - 1 for name, moment in contacts.items()}
    return {name: min(max(s / length, 0), 1) for name, s in since.items() if length and s <= length + 1}


def eclipses(first, last):
    """Returns the eclipses between two moments, as listed by the program. Yields progress as `program.run` does."""
    return json.loads("".join((yield from program.run(["almanac", "--json", f"--from={first}", f"--to={last}"]))))


def bake_texture(moment, words):
    lines = yield from program.run(
        ["bake", f"--instant={moment}", *words, f"--cache={preferences.texture_folder()}"])
    return Texture(lines[-1])


def bake_moment(wanted):
    return Baked([(yield from bake_texture(values.moment(wanted), values.options(wanted)))])


def bake_shader(wanted, textures):
    """Bakes the shader for a film's eclipse, and textures of the sunlit Moon for the film's first and last frames."""
    day = values.day_of(wanted)
    words = ["shader", f"--eclipse={day}", *values.light_options(wanted)]
    folder = film_folder(day, words)
    yield from program.run([*words, f"--output={folder}"])
    words = [*values.options(wanted), "--unshadowed"]
    sunlit = []
    for texture in (textures[0], textures[-1]):
        sunlit.append((yield from bake_texture(texture.moment() + "Z", words)))
    return eclipse_shadow.Shader(folder), sunlit


def film_folder(day, words):
    """The folder for a film. Its name is derived from the day and from the options with which the film is made."""
    name = hashlib.sha256("\n".join(words).encode()).hexdigest()[:12]
    return os.path.join(preferences.texture_folder(), f"{day}_{name}")


def film_words(wanted):
    """Arguments for baking a film's textures (small if a shader is used) and small frames, which record exposures."""
    words = ["animate", f"--eclipse={values.day_of(wanted)}", *values.options(wanted), *values.span(wanted),
             f"--frames={wanted.frames}", "--make=textures,frames", "--width=64", "--height=64", "--stars=off"]
    if not (wanted.in_sky and wanted.night):  # the world has no night sky
        words.append("--sky=off")
    return [*words, f"--texture-width={min(wanted.texture_width, 2 * moonlight.ROWS)}"] if wanted.shader else words


def bake_film(wanted):
    day = values.day_of(wanted)
    contacts = {}
    for eclipse in (yield from eclipses(day, f"{day}T23:59:59Z")):
        contacts = eclipse["contacts"]
    words = film_words(wanted)
    folder = film_folder(day, words)
    os.makedirs(folder, exist_ok=True)
    measured = {}  # measured as textures come, so that no time is lost at the end

    def take(line):
        for file in json.loads(line).get("files", ())[:1]:
            texture = Texture(os.path.join(folder, os.path.basename(file)))
            measured[texture.path] = light_of(texture)

    for what, part in program.run([*words, "--json", "--replace", f"--output={folder}"], take):
        frames = len(measured)
        if frames:
            what, part = f"frame {frames} of {wanted.frames}", frames / wanted.frames
        yield what, part
    textures = textures_of(folder)
    for texture in textures:
        texture.frames_later = wanted.start_frame - textures[0].number()
    shaded = (yield from bake_shader(wanted, textures)) if wanted.shader else None
    return Baked(textures, contacts, measured, shaded)


def bake(wanted):
    """Yields (step, fraction done) while the program works, and returns Baked. Closing the generator ends the program.

    Given  wanted  the Moon's values, from `values.plain`
    """
    values.require_sound(wanted)
    baked = yield from (bake_film if wanted.film else bake_moment)(wanted)
    if wanted.in_sky:
        baked.skies = yield from sky.skies(wanted, baked.textures)
        if wanted.night:
            baked.domes = yield from night.domes(wanted, baked.textures)
    return baked


def show(of_moon, baked):
    """Sets up the Moon, its lamp, the observer's camera and the scene with baked textures."""
    wanted = of_moon.coppermoon
    material = of_moon.material_slots[0].material
    if baked.shaded:
        shader, sunlit = baked.shaded
        moon.put_textures(of_moon, sunlit[:1])
        eclipse_shadow.shade(material, shader, sunlit, baked.textures, baked.lights)
    else:
        eclipse_shadow.unshadow(material)
        moon.put_textures(of_moon, baked.textures)
    for scene in of_moon.users_scene:
        moonlight.keep_dim_light(scene)
    if wanted.stars and baked.skies:
        sky.hang(of_moon, of_moon.users_scene[0], baked.textures, baked.skies)
    if baked.domes:
        night.put_world(of_moon, baked.textures, baked.domes)
    if wanted.lamp:
        moonlight.place_lamp(wanted.lamp, baked.textures, baked.lights)
    scene = wanted.scene
    if baked.skies and (len(baked.textures) > 1 or values.was_set(wanted, "frame_start")):
        scene = of_moon.users_scene[0]
    if scene:
        film.set_exposure(scene, baked.textures, baked.lights)
        film.set_time(scene, baked.textures, parts_of(baked.contacts, baked.textures), wanted)
    if wanted.camera:
        render = (wanted.scene or wanted.camera.users_scene[0]).render
        observer.place_camera(wanted.camera, baked.textures, wanted, render)
    values.remember(wanted, "field")


def new_eclipse(context, own_scene, in_sky=False):
    """Adds a Moon, still dark, and its lamp. A new scene also gets a camera, and an existing scene's sky gets stars."""
    scene = film.new_scene() if own_scene else context.scene
    of_moon = moon.new_moon(scene)
    wanted = of_moon.coppermoon
    wanted.is_moon = True
    wanted.lamp = moonlight.new_lamp(scene, of_moon)
    if own_scene:
        wanted.scene = scene
        wanted.camera = scene.camera = observer.new_camera(scene, of_moon)
        context.window.scene = scene
    elif in_sky:
        wanted.stars = sky.new_stars(scene)
    for other in context.view_layer.objects:
        other.select_set(False)
    of_moon.select_set(True)
    context.view_layer.objects.active = of_moon
    return of_moon
