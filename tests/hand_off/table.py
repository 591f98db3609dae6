# SPDX-License-Identifier: MIT
"""table.py BUILD FILE: the page of other programs, by the last run of the tests labelled hand_off in a build folder.

Writes FILE only where every test that the page names has run and passed.
"""
import json
import pathlib
import re
import subprocess
import sys

build, page = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
root = pathlib.Path(__file__).resolve().parents[2]
log = (build / "Testing/Temporary/LastTest.log").read_text(errors="replace")


def first_number(words):
    said = subprocess.run(words, capture_output=True, text=True)
    return re.search(r"\d+(\.\d+)+", said.stdout + said.stderr)[0]


def debian(package):
    said = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", package], capture_output=True, text=True)
    return re.match(r"(\d+:)?([\d.]+\d)", said.stdout)[2]


pinned = dict(re.findall(r"^([\w-]+)==(\S+)$", (root / "packages.hand_off.pypi").read_text(), re.M))
numpy2 = re.search(r"^#numpy==(\S+)$", (root / "packages.hand_off.pypi").read_text(), re.M)[1]
npm = json.loads((root / "tests/hand_off/gltf/package.json").read_text())["dependencies"]
bpys = sorted(set(re.findall(r"hand_off/add_on_in_blender_([\d.]+)\b", log)))

# host, version, file, what was done with it, tests
ROWS = [
    ("Blender (Debian)", debian("blender"), "a date, `.exr`, `.tx`, a film's folder", "add-on and import tested: positions, light on a wall, colours, frames, undo, a window; `.eclipse` in Cycles", ["blender", "blender_add_on", "side_by_side"]),
    *((f"Blender (`bpy`)", version, "a date, `.tx`", "add-on tested: positions, light on a wall, a whole eclipse, undo, landscapes;  "
       "working spaces of Blender 5", [f"add_on_in_blender_{version}"]) for version in bpys),
    ("Blender (`bpy`)", pinned["bpy"], "`.exr`, `.tx`, `.png`, `.glb`", "finds the colour space by itself",
     ["colour/blender_finds_spaces"]),
    ("Mitsuba", pinned["mitsuba"], "`scene --for mitsuba`", "rendered the same picture as POV-Ray, pixel by pixel", ["mitsuba"]),
    ("OpenImageIO's tools (Debian)", debian("openimageio-tools"), "`.exr`, `.tx`, `.png`", "read the header, every texel, mip levels",
     ["tools"]),
    ("OpenImageIO", pinned["OpenImageIO"], "`.exr`, `.tx`, `.png`", "finds the colour space by itself",
     ["colour/openimageio_finds_spaces"]),
    ("OpenColorIO", pinned["opencolorio"], "`config_aces2.ocio`", "`ociocheck` finds no errors; views agree with its own ACES views",
     ["colour/opencolorio_shows_the_same", "colour/passes_ociocheck"]),
    ("NumPy", numpy2, "`import coppermoon`", "passes all tests of the Python package",
     ["numpy2/behaviour", "numpy2/numbers"]),
    ("OpenUSD", pinned["usd-core"], "`.usda`, `.usdz`", "validators find no errors; finds the colour space by itself",
     ["validators/find_nothing", "colour/usd_finds_spaces"]),
    ("Blender (`bpy`)", pinned["bpy"], "`animate --stage`", "rendered Moon and sky of the first frame in the same position and at the same brightness as the program, in twilight and at night", ["stage/blender_renders_1840", "stage/blender_renders_2040"]),
    ("OpenUSD", pinned["usd-core"], "`animate --stage`", "read node by node: the film's textures within 2 %; light in lux; camera; validators find no errors", ["stage/is_read", "stage/validators_find_nothing"]),
    ("tinyusdz", npm["tinyusdz"], "`.usda`", "read mesh, material, positions of texels",
     ["gltf/usda_is_read", "gltf/usda_of_a_bake_is_read"]),
    ("MaterialX", pinned["MaterialX"], "`.usda`, `eclipse.mtlx`", "validator finds no errors; finds the colour space",
     ["validators/find_nothing", "colour/materialx_finds_spaces"]),
    ("MaterialX's generator, in Chromium", npm["@needle-tools/materialx"], "`eclipse.mtlx`",
     "generated and ran a shader: the shadow's light within 1 %", ["shader"]),
    ("OSL in Cycles (`bpy`)", pinned["bpy"], "`eclipse.osl`", "rendered the shadow's light within 0.5 %", ["shader"]),
    ("Khronos' glTF validator", npm["gltf-validator"], "`.glb`", "finds no errors",
     ["gltf/glb_is_read", "gltf/glb_of_a_bake_is_read"]),
    ("three.js", npm["three"], "`.glb`", "read mesh, material, positions of texels",
     ["gltf/glb_is_read", "gltf/glb_of_a_bake_is_read"]),
    ("OpenJobDescription's `openjd`", pinned["openjd-cli"], "`animate --job job.yaml`", "checked and ran the job, with a task killed during the run: same bytes as from a direct run", ["job"]),
    ("sasktran2", pinned["sasktran2"], "ozone and aerosol of five airs",
     "computed light scattered once onto the shadow's axis: same result", ["scattered_light"]),
    ("LibRaw's `dcraw_emu`", debian("libraw-bin"), "`.dng`", "read the same light", ["raw"]),
    ("darktable", debian("darktable"), "`.dng`", "read the same light", ["raw"]),
    ("Stellarium", debian("stellarium"), "`.stellarium`", "showed the texture unchanged, in the same position as our camera",
     ["stellarium"]),
]

CANNOT = [
    ("Blender's `bpy`", "`.eclipse`", "it contains an OpenImageIO of its own, which cannot load the reader built with Debian's OpenImageIO"),
    ("Blender's viewport", "`.eclipse`", "it reads images with its own code, and shows nothing; Cycles reads the file"),
    ("Mitsuba's spectral variants", "`scene --for mitsuba`", "they would make spectra of their own from RGB"),
    ("pbrt-v4", "a scene", "not written, because pbrt was not available for tests"),
    ("glTF", "floats", "the format has no floating-point textures, so `moon_lin_rec709.glb` stores cd/m² as 16-bit sRGB and a strength"),
    ("iPhone's and iPad's viewers", "`.usdz`", "not available for tests; OpenUSD's validators for such packages find no errors"),
    ("Maya, Houdini, Nuke, Unreal, Arnold, RenderMan", "`.tx`, `.usda`, `.exr`", "not available for tests; the files follow these programs' documentation"),
]

result = dict(re.findall(r"^\d+/\d+ Test: (\S+)\n.*?^Test (Passed|Failed)\.", log, re.M | re.S))
missing = [test for *_, tests in ROWS for test in tests if result.get("hand_off/" + test) != "Passed"]
if missing:
    sys.exit(f"not run, or failed: {', '.join(sorted(set(missing)))}; {page} stays as it is")

lines = ["# Other programs", "", "This page lists other programs that were tested with files from coppermoon, and the results. `tests/hand_off.sh` runs these tests, and writes this page when all of them pass.", "", "| program | version | input | result |",
         "| --- | --- | --- | --- |"]
lines += [f"| {host} | {version} | {given} | {done} |" for host, version, given, done, _ in ROWS]
lines += ["", "## What is not to be had", "", "| program | file | why |", "| --- | --- | --- |"]
lines += [f"| {host} | {given} | {why} |" for host, given, why in CANNOT]
page.write_text("\n".join(lines) + "\n")
print(f"{page}: {len(ROWS)} rows")
