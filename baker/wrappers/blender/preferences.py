# SPDX-License-Identifier: MIT
"""Preferences: the path to the program and the folder for its textures."""
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
    """The value of a preference; empty if the add-on is enabled for one session only, by --addons."""
    addon = bpy.context.preferences.addons.get(__package__)
    return bpy.path.abspath(getattr(addon.preferences, name)) if addon else ""


def program():
    """The path to the program."""
    where = chosen("program")
    # a file, also without Windows' .exe; or a folder that an archive was unpacked to
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
    """The folder for textures until the scene is saved. OpenImageIO's reader of eclipses uses the same cache."""
    if os.environ.get("COPPERMOON_CACHE"):
        return os.path.abspath(os.environ["COPPERMOON_CACHE"])
    cache = os.environ.get("LOCALAPPDATA" if os.name == "nt" else "XDG_CACHE_HOME", "")
    return os.path.join(cache if os.path.isabs(cache) else os.path.expanduser("~/.cache"), "coppermoon")


register, unregister = bpy.utils.register_classes_factory((CoppermoonPreferences,))
