# SPDX-License-Identifier: MIT
"""Menus and panel: Add > Eclipse, File > Import, and the panel of a Moon in the viewport's sidebar."""
import bpy

from . import operators, saving, values


def draw_values(layout, of):
    layout.use_property_split = True
    layout.use_property_decorate = False
    column = layout.column()
    column.prop(of, "date")
    column.prop(of, "film")
    if of.film:
        column.prop(of, "frames")
        column.prop(of, "begin")
        column.prop(of, "end")
        column.prop(of, "start_frame")
        column.prop(of, "shader")
    else:
        moment = column.column()
        moment.active = values.is_day(of)
        moment.prop(of, "contact")
        moment.prop(of, "offset")
    column = layout.column()
    column.prop(of, "place")
    night = column.column()
    night.active = values.has_sky(of)
    night.prop(of, "night")
    column.prop(of, "air")
    column.prop(of, "by_danjon")
    if of.by_danjon:
        column.prop(of, "danjon", slider=True)
    column = layout.column()
    column.prop(of, "quality")
    column.prop(of, "texture_width")
    column.prop(of, "space")
    column = layout.column()
    column.prop(of, "up")
    column.prop(of, "field")


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
