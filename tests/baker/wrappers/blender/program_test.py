# SPDX-License-Identifier: MIT
"""How the add-on for Blender finds and runs the program, on this system and as it does on Windows; without Blender.

As on Windows: os.name is "nt", there are no pseudo-terminals, and Popen takes CREATE_NO_WINDOW, which this test takes off again.
"""
import importlib
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import types
import unittest
from unittest import mock

bpy = mock.MagicMock()
bpy.types.AddonPreferences = object
bpy.path.abspath = lambda path: path
sys.modules["bpy"] = bpy
bpy.utils.register_classes_factory.return_value = (None, None)
package = types.ModuleType("add_on")
package.__path__ = [str(pathlib.Path(__file__).parents[4] / "baker/wrappers/blender")]
sys.modules["add_on"] = package
sys.dont_write_bytecode = True
preferences, program, wrong = (importlib.import_module("add_on." + name) for name in ("preferences", "program", "wrong"))

no_window = 0x08000000
program_text = """#!/bin/sh
echo "one $1"
printf '\\rlight        [=====     ]  17 %%' >&2
sleep 0.3
printf '\\r\\033[K' >&2
printf 'Ö 月\\r\\n'
[ "$1" != fail ] || { echo "coppermoon: dustbin = 3: no such word" >&2; exit 1; }
[ "$1" != wait ] || exec sleep 60
"""


def outcome(run):
    """What a run returns, and all progress that it yields."""
    seen = []
    while True:
        try:
            seen.append(next(run))
            time.sleep(0.02)
        except StopIteration as end:
            return end.value, seen


class Runs(unittest.TestCase):
    name = "coppermoon"

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = os.path.join(scratch.name, "with blank Ö 月")
        os.makedirs(os.path.join(self.folder, "bin"))
        self.file = os.path.join(self.folder, "bin", self.name)
        with open(self.file, "w", encoding="utf-8") as file:
            file.write(program_text)
        os.chmod(self.file, 0o755)
        self.set("")

    def set(self, where):
        bpy.context.preferences.addons.get.return_value = types.SimpleNamespace(
            preferences=types.SimpleNamespace(program=where, textures=""))

    def test_is_found_where_the_setting_says(self):
        for where in (self.file, self.folder, os.path.join(self.folder, "bin"), os.path.join(self.folder, "bin", "coppermoon")):
            self.set(where)
            self.assertEqual(preferences.program(), self.file)

    def test_is_found_on_the_path(self):
        with mock.patch.dict(os.environ, PATH=os.path.dirname(self.file)):
            self.assertEqual(preferences.program(), self.file)

    def test_is_not_found_in_one_line(self):
        self.set(self.folder + "2")
        with self.assertRaisesRegex(wrong.Wrong, "^[^\n]*2: no such program; the add-on's preferences say [^\n]*$"):
            preferences.program()

    def test_returns_its_lines(self):
        self.set(self.file)
        taken = []
        lines, progress = outcome(program.run(["a Ö"], taken.append))
        self.assertEqual(lines, ["one a Ö", "Ö 月"])
        self.assertEqual(taken, lines)
        self.assertIn(("light", 0.17), progress)

    def test_says_why_it_failed(self):
        self.set(self.file)
        with self.assertRaisesRegex(wrong.Wrong, "^dustbin = 3: no such word$"):
            outcome(program.run(["fail"]))

    def test_ends_when_it_is_stopped(self):
        self.set(self.file)
        begin = time.monotonic()
        run = program.run(["wait"])
        next(run)
        run.close()
        self.assertLess(time.monotonic() - begin, 5)

    def test_textures_are_kept_where_the_program_keeps_them(self):
        with mock.patch.dict(os.environ, {"XDG_CACHE_HOME": "/caches", "LOCALAPPDATA": "/local"}):
            os.environ.pop("COPPERMOON_CACHE", None)
            self.assertEqual(preferences.cache_folder(), self.caches + "/coppermoon")

    caches = "/caches"


class RunsOnWindows(Runs):
    name, caches = "coppermoon.exe", "/local"

    def setUp(self):
        super().setUp()
        self.flags = []
        popen = subprocess.Popen

        def on_windows(words, creationflags=0, **streams):
            self.flags.append(creationflags)
            return popen(words, **streams)

        for plant in (mock.patch.object(os, "name", "nt"), mock.patch.object(subprocess, "Popen", on_windows),
                      mock.patch.object(subprocess, "CREATE_NO_WINDOW", no_window, create=True),
                      mock.patch.object(os, "set_blocking", None)):
            plant.start()
            self.addCleanup(plant.stop)
        openpty = os.openpty
        del os.openpty
        self.addCleanup(setattr, os, "openpty", openpty)

    def test_has_no_window(self):
        self.set(self.file)
        outcome(program.run([]))
        self.assertEqual(self.flags, [no_window])


if __name__ == "__main__":
    unittest.main()
