# SPDX-License-Identifier: MIT
"""Where the program is, and where its textures go."""
import os
import shutil

import bpy

from .wrong import Wrong


class CoppermoonPreferences(bpy.types.AddonPreferences):
    bl_idname = __package__

    program: bpy.props.StringProperty(
        name="Program", subtype="FILE_PATH",
        description="The program coppermoon; empty: the one on the PATH")
    textures: bpy.props.StringProperty(
        name="Textures", subtype="DIR_PATH",
        description="Folder for baked textures; empty: the folder coppermoon beside the .blend file, "
                    "or ~/.cache/coppermoon until that is saved")

    def draw(self, context):
        self.layout.prop(self, "program")
        self.layout.prop(self, "textures")


def chosen(name):
    """What a preference says; empty where the add-on was enabled for this session alone, with --addons."""
    addon = bpy.context.preferences.addons.get(__package__)
    return bpy.path.abspath(getattr(addon.preferences, name)) if addon else ""


def program():
    """The path of the program."""
    name = chosen("program") or "coppermoon"
    path = shutil.which(name)
    if not path:
        raise Wrong(f"{name}: no such program; the add-on's preferences say where coppermoon is")
    return path


def texture_folder():
    """The folder of baked textures."""
    if chosen("textures"):
        return os.path.abspath(chosen("textures"))
    return beside_file() if bpy.data.filepath else cache_folder()


def beside_file():
    """The folder of textures beside the .blend file."""
    return bpy.path.abspath("//coppermoon")


def cache_folder():
    """The folder of textures as long as the scene is not saved: that of OpenImageIO's reader."""
    if os.environ.get("COPPERMOON_CACHE"):
        return os.path.abspath(os.environ["COPPERMOON_CACHE"])
    cache = os.environ.get("XDG_CACHE_HOME", "")
    return os.path.join(cache if os.path.isabs(cache) else os.path.expanduser("~/.cache"), "coppermoon")


def register():
    bpy.utils.register_class(CoppermoonPreferences)


def unregister():
    bpy.utils.unregister_class(CoppermoonPreferences)
