# SPDX-License-Identifier: MIT
"""The Earth's shadow in its own colours, and how deep it is: Vollmer & Gedzelman's 1/2400.

    python3 examples/python/umbra.py umbra.png

Above: the shadow at the Moon's distance on 21 February 2008 as a white screen would show it, each third exposed for itself.
Below: light across it. Clear air of molecules alone leaves 1/2400 of sunlight in its middle (Vollmer & Gedzelman 2008,
Applied Optics 47, H52); ozone, aerosol and cloud leave less.
"""
import sys

import coppermoon
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

when = "2008-02-21T03:26:05Z"  # 383 700 km away, as the Moon is in the mean
published = 1 / 2400

# %% Light across the shadow: the mean over the visible range, as they took it, in air of more and more terms.
wavelengths_nm = np.arange(400, 701, 10)
distances_km = np.arange(0, 9001, 50)
airs = {
    "molecules alone": coppermoon.Air(atmosphere="molecular", earth="sphere"),
    "with ozone": coppermoon.Air(atmosphere="clear", earth="sphere"),
    "the air of that month": coppermoon.Air(),
}
profiles = {name: coppermoon.shadow_profile(when, wavelengths_nm, distances_km, air=air) for name, air in airs.items()}


def visible(profile):
    """Mean of the ratio from 400 to 700 nm."""
    return np.trapz(profile.irradiance_ratio, profile.wavelengths_nm, axis=1) / 300


middle = visible(profiles["molecules alone"])[0]
print(f"middle of the umbra, molecules alone: 1/{1 / middle:.0f} of sunlight; published: about 1/{1 / published:.0f}")

# %% Its colour: three wavelengths stand for red, green and blue.
colours = coppermoon.shadow_profile(when, (610, 550, 465), distances_km).irradiance_ratio
x, y = np.meshgrid(np.linspace(-9000, 9000, 1200), np.linspace(-3000, 3000, 400))
from_axis_km = np.hypot(x, y)
screen = np.stack([np.interp(from_axis_km, distances_km, colour) for colour in colours.T], axis=-1)
exposures = {"sunlight": 1, "× 100": 100, "× 5000": 5000}


def shown(linear):
    """Linear light as sRGB; what is brighter than white keeps its colour."""
    linear = linear / np.maximum(1, linear.max(axis=-1, keepdims=True))
    return np.where(linear < 0.0031308, 12.92 * linear, 1.055 * np.power(linear, 1 / 2.4) - 0.055)


# %% The picture.
figure, (above, below) = plt.subplots(2, figsize=(9, 8.5), sharex=True, height_ratios=[1.1, 2], layout="constrained")
third = screen.shape[0] // 3
for k, (name, factor) in enumerate(exposures.items()):
    rows = slice(k * third, (k + 1) * third)
    screen[rows] *= factor
    above.text(-8800, -3000 + 2000 * (k + 0.5), name, color="black" if factor == 1 else "white", va="center",
               bbox={"color": "white" if factor == 1 else "black", "alpha": 0.5})
above.imshow(shown(screen[: 3 * third]), extent=(-9000, 9000, -3000, 3000), origin="lower", aspect="auto",
             interpolation="bilinear")
above.set_ylabel("distance [km]")
above.set_title("The Earth's shadow on 21 February 2008, in three exposures")

for (name, profile), style in zip(profiles.items(), ("-", "--", "-")):
    light = visible(profile)
    below.semilogy(np.concatenate([-distances_km[::-1], distances_km]), np.concatenate([light[::-1], light]), style,
                   color={"molecules alone": "tab:blue", "with ozone": "tab:purple"}.get(name, "tab:red"), label=name)
below.axhline(published, color="black", linewidth=0.8, linestyle=":")
below.text(-8800, 0.85 * published, "1/2400 of sunlight\n(Vollmer & Gedzelman 2008)", fontsize=9, va="top")
below.set_ylim(1e-6, 2)
below.set_xlabel("distance from the axis of the shadow [km]")
below.set_ylabel("light over sunlight, mean of 400 to 700 nm")
below.legend(loc="lower right")
below.grid(alpha=0.3)
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "umbra.png", dpi=110)
