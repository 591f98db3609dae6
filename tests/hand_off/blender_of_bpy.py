# SPDX-License-Identifier: MIT
"""Blender's command line, as far as the tests use it, by the module bpy: to try the add-on in versions that Debian has not.

A script named `blender`, before Debian's on the PATH, that calls this file with a Python that has bpy.
"""

import os
import sys
import traceback

import bpy

given = sys.argv[1:]
bpy.ops.wm.read_factory_settings(use_empty=False)
failed_status = 1


def done(status):
    """Ends without the module's own clean-up, which Blender itself does not run either."""
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)


def taken():
    return given.pop(0)


def run(source, name):
    try:
        exec(compile(source, name, "exec"), {"__name__": "__main__"})
    except SystemExit as end:
        done(end.code or 0)
    except BaseException:
        traceback.print_exc()
        done(failed_status)


while given:
    word = taken()
    if word in ("-b", "--background", "--factory-startup"):
        continue
    elif word == "--version":
        print("Blender", bpy.app.version_string)
    elif word == "--python-exit-code":
        failed_status = int(taken())
    elif word == "--addons":
        for name in taken().split(","):
            bpy.ops.preferences.addon_enable(module=name)
    elif word == "--python-expr":
        run(taken(), "expression")
    elif word == "--python":
        path = taken()
        with open(path, encoding="utf-8") as file:
            run(file.read(), path)
    elif word == "-o":
        bpy.context.scene.render.filepath = taken()
    elif word == "-f":
        scene = bpy.context.scene
        scene.frame_set(int(taken()))
        folder = scene.render.filepath
        scene.render.filepath = scene.render.frame_path(frame=scene.frame_current)
        bpy.ops.render.render(write_still=True)
        scene.render.filepath = folder
    elif word == "-a":
        bpy.ops.render.render(animation=True)
    elif word == "--":
        break
    elif word.startswith("-"):
        sys.exit(f"{word}: is not known to tests/hand_off/blender_of_bpy.py")
    else:
        bpy.ops.wm.open_mainfile(filepath=word)
done(0)
