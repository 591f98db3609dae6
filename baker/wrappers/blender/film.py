# SPDX-License-Identifier: MIT
"""Sets up the scene of an eclipse: black sky, time line, and the settings for rendering and viewing."""
import math
import os

import bpy

from . import values
from .moon import first_known
from .nodes import first
from .texture import header_of, key

VIEWS = ("Hue-preserving", "Un-tone-mapped", "Standard")  # in our own configuration, in the ACES one, in Blender's
MEAN = 0.25  # mean of the disc's strongest channel after exposure, so that nothing clips


def black_world():
    world = bpy.data.worlds.new("Black")
    world.color = (0, 0, 0)
    if world.node_tree:  # in Blender 5 a new world is grey
        first(world.node_tree, "BACKGROUND").inputs["Color"].default_value = (0, 0, 0, 1)
    return world


def new_scene():
    scene = bpy.data.scenes.new("Eclipse")
    scene.world = black_world()
    set_render(scene)
    return scene


def users_device():
    """Value for a scene's setting "device": "CPU" or "GPU", according to the user's preferences for Cycles."""
    cycles = bpy.context.preferences.addons.get("cycles")
    kind = getattr(cycles.preferences, "compute_device_type", "NONE") if cycles else "NONE"
    return "CPU" if kind == "NONE" else "GPU"


def set_render(scene):
    """Sets up rendering to OpenEXR files in cd/m². Each pixel is the mean over its own area."""
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.device = users_device()
    cycles.samples = 64
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.pixel_filter_type = "BOX"  # one pixel wide
    settings = scene.render.image_settings
    settings.file_format = "OPEN_EXR"
    settings.color_mode = "RGB"
    settings.color_depth = "32"
    settings.exr_codec = "ZIP"
    first_known(scene.view_settings, "view_transform", VIEWS)


def set_time(scene, textures, parts, wanted):
    """Sets the time line from the first texture to the last, with a marker at each contact.

    Given  parts   for each contact's name, its time as a fraction of the time from the first to the last texture
           wanted  the values that the user has set for the Moon
    """
    for name in ("P1", "U1", "U2", "U3", "U4", "P4"):
        marker = scene.timeline_markers.get(name)
        if marker:
            scene.timeline_markers.remove(marker)
    if len(textures) == 1:
        return
    begin, end = textures[0].frame(), textures[-1].frame()
    if values.put(wanted, scene, frame_start=begin, frame_end=end):
        scene.frame_set(begin)
    for name, part in parts.items():
        scene.timeline_markers.new(name, frame=round(begin + part * (end - begin)))
    rate = textures[0].header.get("framesPerSecond")
    if rate:
        fps = max(1, round(rate))
        values.put(wanted, scene.render, fps=fps, fps_base=fps / rate)


def remove_curve(owner, path):
    """Removes all keyframes of a property. Since Blender 4.4, an action stores its curves by slot."""
    animation = owner.animation_data
    action = animation.action if animation else None
    if not action:
        return
    holders = [action] if hasattr(action, "fcurves") else [
        strip.channelbag(animation.action_slot) for layer in action.layers for strip in layer.strips]
    for holder in holders:
        curve = holder.fcurves.find(path) if holder else None
        if curve:
            holder.fcurves.remove(curve)


def exposure(texture, lux):
    """Exposure of the view [stops] for a texture. If the program has saved a film's frame beside the texture, it is the
    frame's exposure. Otherwise it follows from the disc's mean luminance, and is None if the disc is dark.
    """
    folder, name = os.path.split(texture.path)
    frame = os.path.join(folder, name.replace("moon_", "frame_", 1))
    shot = header_of(frame) if name.startswith("moon_") and os.path.exists(frame) else {}
    if "expTime" in shot:
        return math.log2(0.65 * shot["expTime"] * shot["isoSpeed"] / (78 * shot["aperture"] ** 2))  # ISO 12232
    strongest = max(lux) * texture.distance ** 2 / math.pi  # cd/m², mean over the disc
    return math.log2(MEAN / strongest) if strongest > 0 else None


def set_exposure(scene, textures, lights):
    """Adapts the view's exposure to the light in each frame. Renders to OpenEXR are not affected, and are in cd/m².

    Given  lights  illuminance by the Moon [lux] in each channel, for each texture
    """
    path = "view_settings.exposure"
    remove_curve(scene, path)
    for texture, lux in zip(textures, lights):
        stops = exposure(texture, lux)
        if stops is not None:
            scene.view_settings.exposure = stops
        key(scene, texture, path)
