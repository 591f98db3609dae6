# SPDX-License-Identifier: MIT
"""check_views.py CONFIG: whether OpenColorIO's own configurations show the same colours as the views of ours, and know
the spaces of our files."""
import itertools
import sys

import numpy as np
import PyOpenColorIO as ocio

from expected import FILES

MOST_DELTA_E = 0.5
ACES_1 = ocio.Config.CreateFromBuiltinConfig("studio-config-v1.0.0_aces-v1.3_ocio-v2.1")
ACES_2 = ocio.Config.CreateFromBuiltinConfig("studio-config-v5.0.0_aces-v2.1_ocio-v2.6")
DISPLAYS = {"sRGB": "sRGB - Display", "Rec.1886 Rec.709": "Rec.1886 Rec.709 - Display",
            "P3-D65": "Gamma 2.6 P3-D65 - Display", "Display P3": "Display P3 - Display",
            "Rec.2100-PQ": "Rec.2100-PQ - Display"}
# Our views, whose they are, and what they are called there.
VIEWS = {"Un-tone-mapped": (ACES_2, "Un-tone-mapped"),
         "ACES 1.0 SDR Video": (ACES_1, "ACES 1.0 - SDR Video"),
         "ACES 1.1 HDR Video 1000 nit": (ACES_1, "ACES 1.1 - HDR Video (1000 nits & Rec.2020 lim)"),
         "ACES 2.0 SDR 100 nits (Rec.709)": (ACES_2, "ACES 2.0 - SDR 100 nits (Rec.709)"),
         "ACES 2.0 SDR 100 nits (P3 D65)": (ACES_2, "ACES 2.0 - SDR 100 nits (P3 D65)"),
         "ACES 2.0 HDR 1000 nits (Rec.2020)": (ACES_2, "ACES 2.0 - HDR 1000 nits (Rec.2020)")}
OUR_OWN = {"Hue-preserving", "Filmic", "Log", "Raw"}

# 17 stops of ACEScg in every mixture: the umbra's reds are among them.
LEVELS = [0, 2.0**-12, 2.0**-8, 2.0**-5, 2.0**-3, 0.18, 0.5, 1, 4, 16]
COLOURS = np.array(list(itertools.product(LEVELS, repeat=3)), dtype=np.float32)


def shown(config, source, display, view, colours):
    transform = ocio.DisplayViewTransform(src=source, display=display, view=view)
    pixels = colours.copy()
    config.getProcessor(transform).getDefaultCPUProcessor().applyRGB(pixels)
    return pixels


def light_of(display, pixels):
    """XYZ, 1 for white of 100 cd/m², by OpenColorIO's own display."""
    pixels = np.clip(pixels, 0, 1)  # as files of 8 and 16 bits hold them
    ACES_2.getProcessor(display, "CIE XYZ-D65 - Display-referred").getDefaultCPUProcessor().applyRGB(pixels)
    return pixels.astype(float)


def lab(xyz):
    t = xyz / np.array([0.9504559, 1.0, 1.0890578])
    f = np.where(t > (6 / 29) ** 3, np.cbrt(t), t / (3 * (6 / 29) ** 2) + 4 / 29)
    return np.stack([116 * f[:, 1] - 16, 500 * (f[:, 0] - f[:, 1]), 200 * (f[:, 1] - f[:, 2])], axis=1)


def difference(config, display, view):
    """Largest CIE 1976 difference; where ours is within 0.5, that of CIEDE2000 is as well."""
    theirs, name = VIEWS[view]
    # ACES 1 has no Display P3, and another look on cinemas' P3-D65: what an sRGB display can show is the same light.
    other_gamut = theirs is ACES_1 and "P3" in display
    other_display = "sRGB - Display" if other_gamut else DISPLAYS[display]
    other = shown(theirs, "lin_ap1", other_display, name, COLOURS)
    same = (0 <= other).all(axis=1) & (other <= 1).all(axis=1) if other_gamut else np.full(len(COLOURS), True)
    assert np.count_nonzero(same) > 100
    ours = shown(config, "lin_ap1_scene", display, view, COLOURS)
    between = lab(light_of(DISPLAYS[display], ours)) - lab(light_of(other_display, other))
    return np.linalg.norm(between[same], axis=1).max()


def main():
    config = ocio.Config.CreateFromFile(sys.argv[1])
    config.validate()
    wrong, compared = [], set()
    for display in config.getDisplays():
        for view in config.getViews(display):
            if view in OUR_OWN:
                continue
            compared.add(view)
            largest = difference(config, display, view)
            print(f"{display}, {view}: {largest:.4f}")
            if not largest < MOST_DELTA_E:
                wrong.append(f"{display}, {view}: {largest:.4f}, allowed less than {MOST_DELTA_E}")
    if compared != set(VIEWS):
        wrong.append(f"views {sorted(compared)}, expected {sorted(VIEWS)}")
    for space in sorted(set(FILES.values())) + ["data"]:
        known = config.getColorSpace(space)
        if known is None or known.getInteropID() != space:
            wrong.append(f"{space}: not known by its interop_id")
    for space in ("lin_rec709_scene", "lin_ciexyzd65_scene", "lin_ap0_scene", "srgb_rec709_scene"):
        pixels = COLOURS.copy()
        there = ocio.Config.GetProcessorFromConfigs(config, space, ACES_2, space).getDefaultCPUProcessor()
        there.applyRGB(pixels)
        if not np.allclose(pixels, COLOURS, rtol=1e-4, atol=1e-6):
            wrong.append(f"{space}: is not OpenColorIO's, by {np.abs(pixels - COLOURS).max():g}")
    print("\n".join(wrong))
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
