# SPDX-License-Identifier: MIT
"""Adds eclipsed Moons to Blender (Add > Eclipse). Coppermoon bakes the textures, and the add-on builds the scene."""
bl_info = {
    "name": "Coppermoon",
    "description": "Eclipsed Moons: texture, light, camera and time line from a date and a place",
    "author": "The coppermoon authors",
    "version": (0, 2, 0),
    "blender": (3, 4, 0),
    "location": "3D Viewport > Add > Eclipse; sidebar > Eclipse; File > Import",
    "category": "Add Mesh",
}

from . import operators, panel, preferences, saving, values

MODULES = (preferences, values, operators, panel, saving)


def register():
    for module in MODULES:
        module.register()


def unregister():
    for module in reversed(MODULES):
        module.unregister()
