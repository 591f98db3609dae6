# SPDX-License-Identifier: MIT
"""What the tests of the Python package share: small settings, the program, the tests' folder."""
import os
import pathlib
import subprocess

import coppermoon

when = "2018-07-27T20:21:45Z"
clear = coppermoon.Air(atmosphere="clear")
draft = coppermoon.Light(bands=4, rays=60)  # hundredths of a second
small = {"width": 64, "albedo_map": "built-in", "air": clear, "light": draft}
small_flags = ["--texture-width", "64", "--albedo-map", "built-in", "--atmosphere", "clear", "--bands", "4", "--rays", "60"]
thorough = "COPPERMOON_THOROUGH" in os.environ
tests_folder = pathlib.Path(os.environ["COPPERMOON_TEST_DATA"])


def command(*words, **more):
    """What the program prints."""
    return subprocess.run([os.environ["COPPERMOON_PROGRAM"], *words], check=True, capture_output=True, text=True, **more).stdout
