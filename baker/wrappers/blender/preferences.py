# SPDX-License-Identifier: MIT
"""Preferences of the add-on: the path to the program coppermoon, and the folder for baked textures."""
import os
import shutil

import bpy

from .wrong import Wrong


class CoppermoonPreferences(bpy.types.AddonPreferences):
    bl_idname = __package__

    program: bpy.props.StringProperty(
        name="Program", subtype="FILE_PATH",
        description="The program coppermoon, or its folder; empty: the one on the PATH")
    textures: bpy.props.StringProperty(
        name="Textures", subtype="DIR_PATH",
        description="Folder for baked textures; empty: the folder coppermoon beside the .blend file, "
                    "or the user's cache folder until that is saved")

    def draw(self, context):
        self.layout.prop(self, "program")
        self.layout.prop(self, "textures")


def chosen(name):
    """The path that is set in a preference. Empty if --addons enabled the add-on for one session only."""
    addon = bpy.context.preferences.addons.get(__package__)
    return bpy.path.abspath(getattr(addon.preferences, name)) if addon else ""


def program():
    """The path to the program coppermoon."""
    where = chosen("program")
    # The preference may name the program's file, with or without .exe, or the folder of an unpacked archive.
    paths = [where] + [os.path.join(where, folder, "coppermoon") for folder in ("", "bin")] if where else ["coppermoon"]
    for path in paths:
        if found := shutil.which(path) or shutil.which(path + ".exe"):
            return found
    raise Wrong(f"{paths[0]}: no such program; the add-on's preferences say where coppermoon is")


def texture_folder():
    """The folder for baked textures."""
    if chosen("textures"):
        return os.path.abspath(chosen("textures"))
    return beside_file() if bpy.data.filepath else cache_folder()


def beside_file():
    """The folder for textures beside the .blend file."""
    return bpy.path.abspath("//coppermoon")


def cache_folder():
    """The folder for textures until the scene is saved. Coppermoon's OpenImageIO reader uses the same cache folder."""
    if os.environ.get("COPPERMOON_CACHE"):
        return os.path.abspath(os.environ["COPPERMOON_CACHE"])
    cache = os.environ.get("LOCALAPPDATA" if os.name == "nt" else "XDG_CACHE_HOME", "")
    return os.path.join(cache if os.path.isabs(cache) else os.path.expanduser("~/.cache"), "coppermoon")


register, unregister = bpy.utils.register_classes_factory((CoppermoonPreferences,))
