# SPDX-License-Identifier: MIT
"""Entries in the menus Add and File > Import, and the panel for a Moon in the viewport's sidebar."""
import bpy

from . import operators, saving, values


def draw_values(layout, of):
    layout.use_property_split = True
    layout.use_property_decorate = False

    def column(*names, active=True, **how):
        part = layout.column()
        part.active = active
        for name in names:
            part.prop(of, name, **how)

    column("date", "film")
    if of.film:
        column("frames", "begin", "end", "start_frame", "shader")
    else:
        column("contact", "offset", active=values.is_day(of))
    column("place")
    column("night", active=values.has_sky(of))
    column("air", "by_danjon")
    if of.by_danjon:
        column("danjon", slider=True)
    column("quality", "texture_width", "space")
    column("up", "field")


class EclipsePanel(bpy.types.Panel):
    bl_idname = "COPPERMOON_PT_eclipse"
    bl_label = "Eclipse"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Eclipse"

    def draw(self, context):
        layout = self.layout
        running = operators.Running.now
        moon = context.active_object
        if moon and moon.coppermoon.is_moon:
            wanted = moon.coppermoon
            if wanted.date:
                draw_values(layout, wanted)
                layout.operator("coppermoon.bake", icon="FILE_REFRESH")
            else:
                layout.label(text="Imported: add an eclipse to bake")
            if wanted.lamp:
                lamp = layout.column()
                lamp.label(text=f"Illuminance {wanted.lamp.data.energy:.3g} lux", icon="LIGHT_SUN")
        else:
            layout.operator("coppermoon.add_eclipse", text="Add Eclipse", icon="LIGHT_HEMI")
        if saving.left_in_cache():
            layout.label(text="Textures are still in the cache: save again", icon="ERROR")
        if running:
            row = layout.row()
            row.label(text=running.text(), icon="TIME")
            row.operator("coppermoon.stop", icon="X", text="")


def add_entry(self, context):
    self.layout.operator_context = "INVOKE_DEFAULT"
    self.layout.operator("coppermoon.add_eclipse", icon="LIGHT_HEMI")


def import_entry(self, context):
    self.layout.operator("coppermoon.import_eclipse", text="Eclipse (.exr of coppermoon)")


def register():
    bpy.utils.register_class(EclipsePanel)
    bpy.types.VIEW3D_MT_add.append(add_entry)
    bpy.types.TOPBAR_MT_file_import.append(import_entry)


def unregister():
    bpy.types.TOPBAR_MT_file_import.remove(import_entry)
    bpy.types.VIEW3D_MT_add.remove(add_entry)
    bpy.utils.unregister_class(EclipsePanel)
