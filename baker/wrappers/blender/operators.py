# SPDX-License-Identifier: MIT
"""Operators that add an eclipse, bake it again and import its textures. If Blender has a window, the program works
in the background. Otherwise the operator waits for the program."""
import datetime
import os
import time

import bpy
from bpy.props import BoolProperty, EnumProperty, IntProperty, StringProperty
from bpy_extras.io_utils import ImportHelper

from . import baking, values
from .texture import textures_of
from .wrong import Wrong

PAUSE_S = 0.1


def result(steps):
    """Runs a generator to its end, and returns the value that the generator returns."""
    while True:
        try:
            next(steps)
        except StopIteration as end:
            return end.value
        time.sleep(PAUSE_S)


class Running:
    """A bake that is running in the background. There is at most one at a time, which is stored in `now`."""
    now = None

    def __init__(self, moon):
        self.moon, self.steps = moon.name, baking.bake(values.plain(moon.coppermoon))
        self.progress, self.stopped = ("start", 0.0), False

    def text(self):
        what, part = self.progress
        return f"{what}: {100 * part:.0f} %"


def moon_named(name):
    """The Moon with the given name. Moons are remembered by name, because undo makes new objects at other addresses."""
    moon = bpy.data.objects.get(name)
    return moon if moon and moon.coppermoon.is_moon else None


def redraw(context):
    for window in context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "VIEW_3D":
                area.tag_redraw()


def reported(execute):
    """Wraps an operator's method `execute`, so that an exception Wrong is reported and cancels the operator."""
    def execute_or_cancel(self, context):
        try:
            return execute(self, context) or {"FINISHED"}
        except Wrong as wrong:
            self.report({"ERROR"}, str(wrong))
            return {"CANCELLED"}
    return execute_or_cancel


class BakeEclipse(bpy.types.Operator):
    """Bakes the textures of the active Moon from its values, and builds its light and its camera anew"""
    bl_idname = "coppermoon.bake"
    bl_label = "Bake Again"
    bl_options = {"UNDO"}

    @classmethod
    def poll(cls, context):
        moon = context.active_object
        return bool(moon and moon.coppermoon.is_moon and moon.coppermoon.date and not Running.now)

    @reported
    def execute(self, context):
        moon = context.active_object
        baking.show(moon, result(baking.bake(values.plain(moon.coppermoon))))

    def invoke(self, context, event):
        if bpy.app.background:
            return self.execute(context)
        Running.now = Running(context.active_object)
        self.timer = context.window_manager.event_timer_add(PAUSE_S, window=context.window)
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type != "TIMER":
            return {"PASS_THROUGH"}
        running = Running.now
        if running.stopped:
            return self.ended(context, {"CANCELLED"})
        try:
            running.progress = next(running.steps)
        except StopIteration as end:
            return self.shown(context, end.value)
        except Wrong as wrong:
            self.report({"ERROR"}, str(wrong))
            return self.ended(context, {"CANCELLED"})
        context.workspace.status_text_set(f"Eclipse: {running.text()}")
        redraw(context)
        return {"PASS_THROUGH"}

    def shown(self, context, baked):
        moon = moon_named(Running.now.moon)
        if not moon:
            self.report({"WARNING"}, f"{Running.now.moon}: is gone; its textures are kept")
            return self.ended(context, {"CANCELLED"})
        try:
            baking.show(moon, baked)
        except Wrong as wrong:
            self.report({"ERROR"}, str(wrong))
        return self.ended(context, {"FINISHED"})

    def ended(self, context, how):
        self.cancel(context)
        context.workspace.status_text_set(None)
        redraw(context)
        return how

    def cancel(self, context):
        """Ends the program. Blender also calls this method when it closes."""
        context.window_manager.event_timer_remove(self.timer)
        Running.now.steps.close()
        Running.now = None


class StopBaking(bpy.types.Operator):
    """Ends the program; what the Moon shows stays as it is"""
    bl_idname = "coppermoon.stop"
    bl_label = "Stop"

    @classmethod
    def poll(cls, context):
        return bool(Running.now)

    def execute(self, context):
        Running.now.stopped = True
        return {"FINISHED"}


# Lists of eclipses, by first and last year. They are kept here because Blender itself does not keep the lists alive.
listed = {}


def eclipses_listed(self, context):
    years = (self.first_year, self.last_year)
    if years not in listed:
        items = [("DATE", "By date", "The date below")]
        try:
            first, last = f"{years[0]:04d}-01-01", f"{years[1]:04d}-12-31T23:59:59Z"
            for eclipse in result(baking.eclipses(first, last)):
                day = eclipse["greatest"].split("T")[0]
                magnitude = eclipse["umbral_magnitude"]
                size = f", {magnitude:.2f}" if magnitude > 0 else ""
                items.append((day, f"{day}  {eclipse['type']}{size}",
                              f"Greatest at {eclipse['greatest']}; umbral magnitude {magnitude:.2f}"))
        except Wrong as wrong:
            return [("DATE", "By date", str(wrong))]
        listed[years] = items
    return listed[years]


def take_date(self, context):
    if self.eclipse != "DATE":
        self.date = self.eclipse


def by_date(self, context):
    if self.first_year > self.last_year:
        self.last_year = self.first_year
    self.eclipse = "DATE"


class AddEclipse(values.Values, bpy.types.Operator):
    """Adds an eclipsed Moon: texture, light, camera and time line"""
    bl_idname = "coppermoon.add_eclipse"
    bl_label = "Eclipse"
    bl_options = {"UNDO"}  # not REGISTER: the values belong to the Moon and are changed in the sidebar

    own_scene: BoolProperty(
        name="Scene of its own", default=True,
        description="A new scene with the observer's camera, a black world, time line and render "
                    "settings; otherwise the Moon and its light alone, in this scene, with a place in its "
                    "sky among the stars: +Z up, +Y north")
    first_year: IntProperty(name="From", default=datetime.date.today().year, min=1, max=3000,
                            options={"SKIP_SAVE"}, update=by_date, description="First year of the list")
    last_year: IntProperty(name="To", default=datetime.date.today().year + 10, min=1, max=3000,
                           options={"SKIP_SAVE"}, update=by_date, description="Last year of the list")
    eclipse: EnumProperty(name="Eclipse", items=eclipses_listed, options={"SKIP_SAVE"}, update=take_date,
                          description="Eclipses of these years")

    @classmethod
    def poll(cls, context):
        return not Running.now

    def invoke(self, context, event):
        return context.window_manager.invoke_props_dialog(self, width=360)

    def draw(self, context):
        from .panel import draw_values
        years = self.layout.row(align=True)
        years.prop(self, "first_year")
        years.prop(self, "last_year")
        self.layout.prop(self, "eclipse")
        draw_values(self.layout, self)
        self.layout.prop(self, "own_scene")

    @reported
    def execute(self, context):
        values.require_sound(self)
        baked = result(baking.bake(values.plain(self))) if bpy.app.background else None
        moon = baking.new_eclipse(context, self.own_scene, bool(self.place.strip()))
        values.copy(self, moon.coppermoon)
        if baked:
            baking.show(moon, baked)
        else:
            bpy.ops.coppermoon.bake("INVOKE_DEFAULT")


class ImportEclipse(bpy.types.Operator, ImportHelper):
    """Builds the scene of a texture that coppermoon baked, or of a film's"""
    bl_idname = "coppermoon.import_eclipse"
    bl_label = "Import Eclipse"
    bl_options = {"REGISTER", "UNDO"}

    filename_ext = ".exr"
    filter_glob: StringProperty(default="*.exr;*.tx", options={"HIDDEN"})
    film: BoolProperty(
        name="Film", description="All textures of the film that this one is a frame of, in its folder")
    own_scene: AddEclipse.__annotations__["own_scene"]
    up: values.Values.__annotations__["up"]
    field: values.Values.__annotations__["field"]

    @reported
    def execute(self, context):
        baked = baking.Baked(textures_of(os.path.dirname(self.filepath) if self.film else self.filepath))
        moon = baking.new_eclipse(context, self.own_scene)
        wanted = moon.coppermoon
        wanted.date, wanted.up, wanted.field = "", self.up, self.field
        baking.show(moon, baked)


register, unregister = bpy.utils.register_classes_factory((BakeEclipse, StopBaking, AddEclipse, ImportEclipse))
