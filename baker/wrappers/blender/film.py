# SPDX-License-Identifier: MIT
"""The scene of an eclipse: a black sky, the time line, and how it is rendered and looked at."""
import math

import bpy

from .moon import first_known

VIEWS = ("Un-tone-mapped", "Standard")  # colours as they are: ours, Blender's
MEAN = 0.25  # what the exposure brings the mean of the disc's strongest channel to: nothing clips


def new_scene():
    scene = bpy.data.scenes.new("Eclipse")
    scene.world = bpy.data.worlds.new("Black")
    scene.world.color = (0, 0, 0)
    set_render(scene)
    return scene


def set_render(scene):
    """Each pixel is the mean of its own area, in cd/m² where it is kept as OpenEXR."""
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.device = "CPU"
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


def set_time(scene, textures, contacts):
    """The time line from the first texture to the last, with a marker at each contact.

    Given  contacts  by name, in the order of the eclipse, the part of its time that has passed
    """
    for name in ("P1", "U1", "U2", "U3", "U4", "P4"):
        marker = scene.timeline_markers.get(name)
        if marker:
            scene.timeline_markers.remove(marker)
    if len(textures) == 1:
        return
    scene.frame_start, scene.frame_end = textures[0].frame(), textures[-1].frame()
    for name, part in contacts.items():
        frame = scene.frame_start + part * (len(textures) - 1)
        scene.timeline_markers.new(name, frame=round(frame))
    rate = textures[0].header.get("framesPerSecond")
    if rate:
        scene.render.fps = max(1, round(rate))
        scene.render.fps_base = scene.render.fps / rate
    scene.frame_set(scene.frame_start)


def set_exposure(scene, textures, lights):
    """The exposure of the view follows the disc's mean brightness; a render in OpenEXR keeps cd/m².

    Given  lights  illuminance by channel [lux], of each texture
    """
    path = "view_settings.exposure"
    for frame in range(scene.frame_start, scene.frame_end + 1) if scene.animation_data else ():
        try:
            scene.keyframe_delete(path, frame=frame)
        except RuntimeError:  # it has no such key
            pass
    for texture, lux in zip(textures, lights):
        strongest = max(lux) * texture.distance ** 2 / math.pi  # cd/m², over the disc
        if strongest > 0:
            scene.view_settings.exposure = math.log2(MEAN / strongest)
        if len(textures) > 1:
            scene.keyframe_insert(path, frame=texture.frame())
