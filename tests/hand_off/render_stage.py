# SPDX-License-Identifier: MIT
"""render_stage.py COPPERMOON FOLDER PLACE MOMENT: Blender 5 imports the stage of a film that begins at that moment, and renders its first
frame: Moon and sky are where the program's own frame has them, as bright and as coloured. No air shines before the stage's Moon."""
import json
import os
import shutil
import subprocess
import sys

import bpy
import numpy as np

program, folder, place, moment = sys.argv[1:]
width, height = 96, 64


def run(*words):
    return subprocess.run([program, *words], check=True, stdout=subprocess.PIPE, text=True).stdout


def pixels(path):
    """Numbers of an OpenEXR file, [row from the top][column][channel]."""
    image = bpy.data.images.load(path)
    image.colorspace_settings.name = "Non-Color"
    values = np.empty(image.size[0] * image.size[1] * 4, dtype=np.float32)
    image.pixels.foreach_get(values)
    return values.reshape(image.size[1], image.size[0], 4)[::-1, :, :3].astype(float)


shutil.rmtree(folder, ignore_errors=True)
stage = os.path.join(folder, "film.usda")
run("animate", "--eclipse=2018-07-27", f"--at={place}", f"--from={moment}", "--to=2018-07-27T21:00Z", "--frames=2", "--make=textures,frames",
    "--tolerance=1%", "--texture-width=512", f"--width={width}", f"--height={height}", "--field=0.9", "--stars=off", "--flattening=off",
    f"--output={folder}", f"--stage={stage}")
ours = pixels(os.path.join(folder, "frame_lin_rec709.0001.exr"))
dome = pixels(os.path.join(folder, "film_sky_lin_rec709.0001.exr"))
sky = json.loads(run("sky", os.path.join(folder, "moon_lin_rec709.0001.exr"), "--at", place, "--json"))

bpy.ops.wm.usd_import(filepath=stage)
scene = bpy.context.scene
for thing in ("Cube", "Light"):
    bpy.data.objects.remove(bpy.data.objects[thing])
scene.camera = bpy.data.objects["Observer"]
assert (scene.frame_start, scene.frame_end) == (1, 2), "the film's range"
scene.frame_set(1)
render = scene.render
render.engine, scene.cycles.device, scene.cycles.samples = "CYCLES", "CPU", 64
scene.cycles.use_denoising = scene.cycles.use_adaptive_sampling = False
scene.cycles.pixel_filter_type = "BOX"
render.resolution_x, render.resolution_y, render.resolution_percentage = width, height, 100
render.image_settings.file_format, render.image_settings.color_depth = "OPEN_EXR", "32"
render.filepath = os.path.join(folder, "blender.exr")
bpy.ops.render.render(write_still=True)
theirs = pixels(render.filepath)

y, x = np.mgrid[0:height, 0:width]
out = np.hypot(x + 0.5 - width / 2, y + 0.5 - height / 2)
radius = width * np.degrees(np.arcsin(1737.4 / sky["observer_moon_distance_km"])) / 0.9
inside, outside = out < radius - 2, out > radius + 2
weights = np.array([0.2126, 0.7152, 0.0722])


def centre(light):
    light = np.where(inside, light @ weights, 0)
    return np.array([(light * x).sum(), (light * y).sum()]) / light.sum()


def alike(name, seen, given, most):
    print(name, seen, "of Blender,", given, "of the program")
    assert np.all(np.abs(seen - given) < most * np.max(given)), name


behind = ours[outside].mean(axis=0)
apart = np.hypot(*(centre(theirs) - centre(ours - behind)))
print(f"{apart:.3f} pixels apart")
assert apart < 0.2, "as the add-on's Moon is from our camera's"
alike("Moon", theirs[inside].mean(axis=0), ours[inside].mean(axis=0) - behind, 0.01)  # is asked of a hand-off
# the sky's texels are 1.4 degrees wide: by that much it changes by some per cent
alike("luminance of the sky", theirs[outside].mean(axis=0) @ weights, behind @ weights, 0.1)
row, column = (90 - sky["altitude_deg"]) / 180 * dome.shape[0], (sky["azimuth_deg"] + 180) % 360 / 360 * dome.shape[1]
alike("colours of the sky", theirs[outside].mean(axis=0), dome[int(row), int(column)], 0.1)
