# SPDX-License-Identifier: MIT
"""Files of make_files.sh and the colour space that each is in, as the Color Interop Forum names it."""
FILES = {
    "acescg/a.exr": "lin_ap1_scene",
    "acescg/b.tx": "lin_ap1_scene",
    "lin_rec709/a.exr": "lin_rec709_scene",
    "lin_rec709/b.tx": "lin_rec709_scene",
    "lin_ciexyzd65_scene/a.exr": "lin_ciexyzd65_scene",
    "lin_ciexyzd65_scene/b.tx": "lin_ciexyzd65_scene",
    "frame.exr": "lin_rec709_scene",
    "ring.exr": "lin_rec709_scene",
    "frame.png": "srgb_rec709_scene",
    "moon.glb": "srgb_rec709_scene",
    "moon.usda": "lin_ap1_scene",
}
assert len(FILES) == 11
