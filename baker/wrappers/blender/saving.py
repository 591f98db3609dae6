# SPDX-License-Identifier: MIT
"""Keeps a saved scene's textures in a folder "coppermoon" beside the .blend file, because caches may be emptied."""
import os
import shutil
import sys

import bpy

from . import preferences


def name_in_cache(path):
    """A path relative to the cache folder, or None if the path is outside that folder."""
    path = os.path.abspath(bpy.path.abspath(path))
    cache = os.path.join(os.path.abspath(preferences.cache_folder()), "")
    return path.removeprefix(cache) if path.startswith(cache) else None


def left_in_cache():
    """The images of a saved scene whose files are still in the cache."""
    if not bpy.data.filepath or name_in_cache(bpy.data.filepath):
        return []
    return [image for image in bpy.data.images if image.filepath and name_in_cache(image.filepath)]


def link_or_copy(source, target):
    """Makes a hard link, which takes no space, or a copy if links are not possible."""
    try:
        os.link(source, target)
    except OSError:
        shutil.copy2(source, target + ".part")
        os.replace(target + ".part", target)


def bring(image):
    """Links or copies an image's file, or a film's whole folder, to the folder beside the .blend file."""
    name = name_in_cache(image.filepath)
    first = name.split(os.sep)[0]
    source, folder = os.path.join(preferences.cache_folder(), first), preferences.beside_file()
    os.makedirs(folder, exist_ok=True)
    target = os.path.join(folder, first)
    if os.path.isdir(source):
        shutil.copytree(source, target, copy_function=link_or_copy, dirs_exist_ok=True)
    elif not os.path.exists(target):
        link_or_copy(source, target)
    image.filepath = bpy.path.relpath(os.path.join(folder, name))


@bpy.app.handlers.persistent
def keep_textures(*_):
    """Handler that runs after a scene is saved, because only then is its folder known. It saves the scene once more."""
    images = left_in_cache()
    try:
        for image in images:
            bring(image)
    except OSError as error:
        print(f"Eclipse: textures are still in the cache: {error}", file=sys.stderr)
        return
    if images:
        bpy.ops.wm.save_mainfile()


def register():
    bpy.app.handlers.save_post.append(keep_textures)


def unregister():
    bpy.app.handlers.save_post.remove(keep_textures)
