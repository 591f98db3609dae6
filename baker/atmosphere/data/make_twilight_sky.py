#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes twilight_sky.csv: the light of a clear twilight sky, scattered any number of times in a spherical atmosphere.

Usage: make_twilight_sky.py [RUNS [twilight_sky.csv]]     16 runs, the default, take one processor a quarter of an hour

The method is backward Monte Carlo. Light scattered once is integrated along the line of sight. For all further orders,
paths are traced from the eye through the air, with more directions near the horizon. At each scattering, sunlight is
added for every position of the Sun in the table, so that all positions share the noise of the same paths. The noise,
above 1 % with the Sun below -6 degrees, is smoothed in proportion to its size. The air is that of US 1976; ozone's
profile and cross-section come from tables in this folder. The aerosol has a scale height of 1.5 km, an Angstrom
exponent of 1.3, Henyey-Greenstein's g = 0.7 and a single-scattering albedo of 0.95. The Rayleigh optical depth is that
of Hansen & Travis (1974); the ground has an albedo of 0.2; polarisation and refraction are neglected.
"""
import csv
import pathlib
import sys

import numpy as np

DATA = pathlib.Path(__file__).resolve().parent
AIRS = {  # in the order of their numbers in the table
    "standard": {}, "clear": {"aerosol": 0.03}, "hazy": {"aerosol": 0.3}, "ozone": {"ozone_du": 450.}, "high": {"eye_km": 3.}}
SUNS = np.array([5, 3, 2, 1, 0, *range(-1, -17, -1)], float)  # geometric altitudes [degrees]
ALTITUDES = np.array([0.5, 1, 2, 3, 5, 7.5, 10, 15, 20, 30, 45, 60, 75, 90])
AZIMUTHS = np.array([0, 15, 30, 45, 60, 90, 120, 150, 180.])  # relative to the Sun's
NM = np.array([390, 420, 445, 470, 495, 520, 545, 570, 595, 620, 650, 700.])
REFERENCE = 5  # index in NM of the wavelength whose optical depth is used to draw places of scattering
EARTH_KM, TOP_KM = 6371., 100.
EXPONENT, FORWARD, ALBEDO, GROUND, SCALE_KM = 1.3, 0.7, 0.95, 0.2, 1.5
SUN_RADIUS = 0.00465
REC709 = np.array([[3.2404542, -1.5371385, -.4985314], [-.9692660, 1.8760108, .0415560], [.0556434, -.2040259, 1.0572252]])
ORDERS = 8


def table(path):
    with open(DATA / path, encoding="utf-8") as file:
        return np.array([row for row in csv.reader(line for line in file if not line.startswith("#"))][1:], float)


def phases(cosine):
    """Phase functions of molecules and of aerosol [1/sr]."""
    return (0.75 * (1 + cosine**2) / (4 * np.pi),
            (1 - FORWARD**2) / (1 + FORWARD**2 - 2 * FORWARD * cosine)**1.5 / (4 * np.pi))


class Air:
    """Molecules, ozone and aerosol: profiles (shares of the column per kilometre) and vertical optical depths."""

    def __init__(self, aerosol=0.1, ozone_du=300., eye_km=0.):
        z = np.concatenate([np.arange(0, 12, .25), np.arange(12, 40, .5), np.arange(40, TOP_KM + .1, 1)])
        kelvin = np.interp(z, [0, 11, 20, 32.2, 47.4, 51.4, 71.8, 86., 100.],
                           [288.15, 216.65, 216.65, 228.65, 270.65, 270.65, 214.65, 186.9, 195.])
        middle, mean = (z[1:] + z[:-1]) / 2, (kelvin[1:] + kelvin[:-1]) / 2
        fall = np.diff(z) * 34.163 * (EARTH_KM / (EARTH_KM + middle))**2 / mean
        molecules = np.exp(-np.append(0, np.cumsum(fall))) * 288.15 / kelvin
        profile = table("ozone_profile.csv")
        ozone = np.exp(np.interp(z, profile[:, 0], np.log(profile[:, 1])))
        ozone = np.where(z > 86, ozone * np.exp(-(z - 86) / 3.72), ozone)
        particles = np.exp(-np.maximum(z, eye_km) / SCALE_KM)
        columns = [(molecules, 0), (ozone, 0), (particles, eye_km)]
        logarithms = [np.log(np.maximum(n / np.trapezoid(n[z >= low - 1e-9], z[z >= low - 1e-9]), 1e-30)) for n, low in columns]
        self.step = .1
        fine = np.arange(0, TOP_KM + .11, self.step)
        self.fine = np.stack([np.interp(fine, z, n) for n in logarithms])
        um = NM / 1e3
        section = table("ozone_cross_section.csv")
        self.molecules = 0.008569 * um**-4 * (1 + 0.0113 * um**-2 + 0.00013 * um**-4)
        self.depths = np.stack([self.molecules, np.interp(NM, section[:, 0], section[:, 1]) * ozone_du * 2.687e20,
                                aerosol * (NM / 550)**-EXPONENT])
        self.aerosol = self.depths[2] * ALBEDO
        self.eye_km = eye_km
        self.make_columns()

    def at(self, km):
        x = np.clip(km, 0, TOP_KM) / self.step
        i = np.minimum(x.astype(int), self.fine.shape[1] - 2)
        return np.exp(self.fine[:, i] * (1 - (x - i)) + self.fine[:, i + 1] * (x - i))

    def make_columns(self):
        """Tabulates logarithms of air amounts along rays to space, by starting height and angle above the horizon."""
        self.heights, self.angles = 101, 181
        height, above = np.meshgrid(TOP_KM * np.linspace(0, 1, self.heights)**2, np.pi * np.linspace(0, 1, self.angles)**2, indexing="ij")
        radius = EARTH_KM + height
        cosine = np.cos(np.maximum(np.pi - np.arcsin(EARTH_KM / radius) - above, 0))
        lowest = np.maximum(-radius * cosine, 0)
        length = -radius * cosine + np.sqrt(np.maximum((radius * cosine)**2 - radius**2 + (EARTH_KM + TOP_KM)**2, 0))
        amounts = np.zeros((3, *height.shape))
        steps = 200
        for k in range(steps):
            middle, share = ((k / steps)**2 + ((k + 1) / steps)**2) / 2, (2 * k + 1) / steps**2
            for way, sign in (lowest, -1), (length - lowest, 1):
                t = lowest + sign * way * middle
                amounts += self.at(np.sqrt(radius**2 + t**2 + 2 * radius * t * cosine) - EARTH_KM) * way * share
        self.columns = np.log(np.maximum(amounts, 1e-12)).astype(np.float32)

    def sunlight(self, places, suns):
        """Transmittance [place, Sun, wavelength] of sunlight to places [km], and cosines of the Sun's zenith angles."""
        radius = np.linalg.norm(places, axis=1)
        cosine = np.clip((places / radius[:, None]) @ suns.T, -1, 1)
        height = np.clip(radius - EARTH_KM, 0, TOP_KM)
        above = np.pi - np.arcsin(np.minimum(EARTH_KM / (EARTH_KM + height), 1))[:, None] - np.arccos(cosine)
        risen = np.clip((above + SUN_RADIUS) / (2 * SUN_RADIUS), 0, 1)
        x = np.sqrt(height / TOP_KM)[:, None] * (self.heights - 1) * np.ones_like(above)
        y = np.sqrt(np.clip(above, 0, np.pi) / np.pi) * (self.angles - 1)
        lit = risen > 0
        i, j = np.minimum(x.astype(int), self.heights - 2), np.minimum(y.astype(int), self.angles - 2)
        right, up = (x - i).astype(np.float32)[lit], (y - j).astype(np.float32)[lit]
        i, j, table_ = i[lit], j[lit], self.columns
        amounts = np.exp((table_[:, i, j] * (1 - right) + table_[:, i + 1, j] * right) * (1 - up) +
                         (table_[:, i, j + 1] * (1 - right) + table_[:, i + 1, j + 1] * right) * up)
        light = np.zeros((*above.shape, len(NM)), np.float32)
        light[lit] = np.exp(-(amounts.T @ self.depths.astype(np.float32))) * risen[lit][:, None].astype(np.float32)
        return light, cosine


def marched(air, start, towards, steps):
    """Divides rays, down to the ground or up to the top of the air, into segments, finest at the lowest point. Returns
    edges, middles and lengths [km], densities and amounts of air, whether rays end on the ground, and rays' lengths."""
    along, square = (start * towards).sum(1), (start * start).sum(1)
    root = along**2 - square + EARTH_KM**2
    grounded = (root > 0) & (along < 0)
    length = np.where(grounded, -along - np.sqrt(np.maximum(root, 0)),
                      -along + np.sqrt(np.maximum(along**2 - square + (EARTH_KM + TOP_KM)**2, 0)))
    length = np.maximum(length, 1e-6)
    lowest = np.clip(-along, 0, length)
    half, k = steps // 2, np.arange(steps + 1)
    edges = (lowest[:, None] - lowest[:, None] * (((half - np.minimum(k, half)) / half)**2)[None] +
             (length - lowest)[:, None] * ((np.maximum(k - half, 0) / (steps - half))**2)[None])
    rising, falling = lowest <= 0, lowest >= length * 0.999999
    edges[rising] = (length[:, None] * (k / steps)[None]**2)[rising]
    edges[falling] = (length[:, None] - length[:, None] * (1 - k / steps)[None]**2)[falling]
    middle, parts = (edges[:, 1:] + edges[:, :-1]) / 2, np.diff(edges, axis=1)
    density = air.at(np.sqrt(square[:, None] + middle**2 + 2 * along[:, None] * middle) - EARTH_KM)
    return edges, middle, parts, density, density * parts[None], grounded, length


def across(axis):
    """For each axis, two unit vectors that are perpendicular to it and to each other."""
    other = np.where(abs(axis[:, :1]) < 0.9, np.array([[1., 0, 0]]), np.array([[0, 1., 0]]))
    east = np.cross(axis, other)
    east /= np.linalg.norm(east, axis=1)[:, None]
    return east, np.cross(axis, east)


def turned(axis, cosine, around):
    east, north = across(axis)
    sine = np.sqrt(np.maximum(1 - cosine**2, 0))
    return cosine[:, None] * axis + sine[:, None] * (np.cos(around)[:, None] * east + np.sin(around)[:, None] * north)


def next_directions(random, up, towards, grounded):
    """Draws directions (uniform, near the horizon, or as aerosol scatters), with their probability densities [1/sr]."""
    chosen, around, x = random.random(len(up)), 2 * np.pi * random.random(len(up)), random.random(len(up))
    width = 0.12  # of a Cauchy distribution of the sine of altitude
    most = np.arctan(1 / width)
    low = width * np.tan((2 * x - 1) * most)
    sine = np.where(chosen < 0.4, 2 * x - 1, low)
    sine = np.where(grounded, np.where(chosen < 0.4, x, abs(low)), sine)
    forward = (1 + FORWARD**2 - ((1 - FORWARD**2) / (1 - FORWARD + 2 * FORWARD * x))**2) / (2 * FORWARD)
    onwards = ((chosen >= 0.75) & ~grounded)[:, None]
    direction = np.where(onwards, turned(towards, forward, around), turned(up, sine, around))
    sine, cosine = np.clip((direction * up).sum(1), -1, 1), np.clip((direction * towards).sum(1), -1, 1)
    even, dense = 1 / (4 * np.pi), width / ((width**2 + sine**2) * 2 * most) / (2 * np.pi)
    density = np.where(grounded, 2 * (0.4 * even + 0.6 * dense), 0.4 * even + 0.35 * dense + 0.25 * phases(cosine)[1])
    return direction, density, sine, cosine


def radiance(air, altitude_deg, seed, paths=16000):
    """Radiance of the sky divided by the Sun's irradiance [1/sr], indexed by [Sun's altitude, azimuth, wavelength]."""
    random = np.random.default_rng(seed)
    s, b, a = np.radians(SUNS)[:, None], np.radians(AZIMUTHS)[None], np.radians(altitude_deg)
    suns = np.stack([np.cos(s) * np.cos(b), np.cos(s) * np.sin(b), np.sin(s) * np.ones_like(b)], -1).reshape(-1, 3)
    start, towards = np.array([[0, 0, EARTH_KM + air.eye_km + 1e-3]]), np.array([[np.cos(a), 0, np.sin(a)]])
    _, middle, parts, density, amounts, _, _ = marched(air, start, towards, 600)
    before = np.cumsum(amounts, 2) - amounts / 2
    light, _ = air.sunlight(start + middle[0][:, None] * towards, suns)
    seen = np.exp(-np.einsum("kn,kw->nw", before[:, 0], air.depths)) * parts[0][:, None]
    by_molecules, by_aerosol = phases((towards @ suns.T)[0])
    total = (np.einsum("nmw,nw->mw", light, seen * density[0, 0][:, None] * air.molecules) * by_molecules[:, None] +
             np.einsum("nmw,nw->mw", light, seen * density[2, 0][:, None] * air.aerosol) * by_aerosol[:, None])

    start, towards = np.repeat(start, paths, 0), np.repeat(towards, paths, 0)
    weight = np.ones((paths, len(NM)))
    drawn = (random.permutation(paths) + random.random(paths)) / paths
    steps = 96
    for order in range(1, ORDERS + 1):
        edges, _, parts, _, amounts, grounded, length = marched(air, start, towards, steps)
        depth = np.einsum("kpn,k->pn", amounts, air.depths[:, REFERENCE])
        share = np.exp(depth - np.cumsum(depth, 1)) * (1 - np.exp(-depth))
        share /= np.maximum(share.sum(1, keepdims=True), 1e-30)
        to_ground = np.where(grounded, 0.3, 0.)
        share = (0.55 * share + 0.25 / steps + 0.2 * parts / length[:, None]) * (1 - to_ground)[:, None]
        if order > 1:
            drawn = random.random(len(start))
        landed = drawn >= 1 - to_ground
        below = np.cumsum(share, 1)
        k = np.minimum((below < np.minimum(drawn, below[:, -1] - 1e-12)[:, None]).sum(1), steps - 1)
        i, within = np.arange(len(start)), random.random(len(start))
        way = np.where(landed, length, edges[i, k] + within * parts[i, k])
        chance = np.where(landed, to_ground, share[i, k] / parts[i, k])
        passed = np.cumsum(amounts, 2)
        passed = np.where(landed, passed[:, i, -1], passed[:, i, k] - amounts[:, i, k] * (1 - within))
        place = start + way[:, None] * towards
        radius = np.linalg.norm(place, axis=1)
        place = np.where(landed[:, None], place * ((EARTH_KM + 1e-4) / radius)[:, None], place)
        density = air.at(np.maximum(radius - EARTH_KM, 0))
        molecules, aerosol = density[0][:, None] * air.molecules, density[2][:, None] * air.aerosol
        weight = weight * np.exp(-passed.T @ air.depths) / chance[:, None]
        for first in range(0, len(place) if order > 1 else 0, 500):
            some = slice(first, first + 500)
            light, cosine = air.sunlight(place[some], suns)
            ground = landed[some]
            in_air = np.where(ground[:, None], 0, weight[some])
            for part, phase in zip((molecules, aerosol), phases(towards[some] @ suns.T)):
                total += np.einsum("pmw,pw,pm->mw", light, (in_air * part[some]).astype(np.float32), phase.astype(np.float32),
                                   optimize=True) / paths
            if ground.any():
                total += np.einsum("pmw,pw,pm->mw", light[ground], weight[some][ground],
                                   np.maximum(cosine[ground], 0) * GROUND / np.pi, optimize=True) / paths
        if order == ORDERS:
            break
        up = place / np.linalg.norm(place, axis=1)[:, None]
        direction, chance, sine, cosine = next_directions(random, up, towards, landed)
        by_molecules, by_aerosol = phases(cosine)
        scattered = np.where(landed[:, None], GROUND / np.pi * np.maximum(sine, 0)[:, None] * np.ones(len(NM)),
                             molecules * by_molecules[:, None] + aerosol * by_aerosol[:, None])
        weight, start, towards = weight * scattered / chance[:, None], place, direction
        if order > 1:  # Russian roulette
            mean = weight.mean(1)
            kept = np.clip(mean / (mean.mean() * 0.5 + 1e-300), 0.05, 1)
            alive = random.random(len(start)) < kept
            weight, start, towards = (weight / kept[:, None])[alive], start[alive], towards[alive]
    return total.reshape(len(SUNS), len(AZIMUTHS), -1)


def channels(light):
    """Linear Rec.709 [cd/m2] from radiances divided by the Sun's irradiance. Each channel is kept above 0."""
    observer, sun = table("../../../colour/data/cie_1931_observer.csv"), table("../../photons/data/solar_irradiance_e490.csv")
    nm = np.arange(380, 781, 1.)
    weights = np.stack([np.interp(nm, observer[:, 0], observer[:, k]) for k in (1, 2, 3)], 1)
    weights *= np.interp(nm, sun[:, 0], sun[:, 1])[:, None] * 683.002
    logarithms = np.log(np.maximum(light.reshape(-1, len(NM)), 1e-30))
    x = np.clip(nm, NM[0], NM[-1])
    j = np.clip(np.searchsorted(NM, x, side="right") - 1, 0, len(NM) - 2)
    t = (x - NM[j]) / (NM[j + 1] - NM[j])
    rgb = (np.exp(logarithms[:, j] * (1 - t) + logarithms[:, j + 1] * t) @ weights) @ REC709.T
    return np.maximum(rgb, 1e-3 * rgb.max(1, keepdims=True)).reshape(*light.shape[:-1], 3)


def bends(x):
    """Matrix that gives the second differences of values at unequally spaced x."""
    matrix = np.zeros((len(x) - 2, len(x)))
    for i in range(len(x) - 2):
        a, b = x[i + 1] - x[i], x[i + 2] - x[i + 1]
        matrix[i, i:i + 3] = 2 / (a * (a + b)), -2 / (a * b), 2 / (b * (a + b))
    return matrix


def smoothed(values, noise):
    """Smooths log10 of light [altitude, Sun] with errors `noise`, assuming second differences about 0.04 and 0.02."""
    x = np.cumsum(np.append(0, np.diff(np.log(ALTITUDES + 1.5))))
    down, along = bends(x / np.diff(x).mean()), bends(SUNS)
    stiff = (np.kron(down.T @ down, np.eye(len(SUNS))) / 0.04**2 + np.kron(np.eye(len(ALTITUDES)), along.T @ along) / 0.02**2)
    return np.linalg.solve(np.diag((1 / noise**2).ravel()) + stiff, (values / noise**2).ravel()).reshape(values.shape)


def without_noise(light, least):
    """Smoothed log10 of the runs' mean light [altitude, Sun, azimuth, channel]; at the zenith, all azimuths agree."""
    mean = light.mean(0)
    noise = light.std(0, ddof=1) / mean / np.sqrt(len(light)) / np.log(10)
    noise = np.maximum(np.sqrt((noise**2).mean((2, 3))), least)
    logarithms = np.log10(mean)
    logarithms[-1] = logarithms[-1].mean(1, keepdims=True)
    for a, c in np.ndindex(len(AZIMUTHS), 3):
        logarithms[:, :, a, c] = smoothed(logarithms[:, :, a, c], noise)
    logarithms[-1] = logarithms[-1].mean(1, keepdims=True)
    return logarithms


def main():
    runs = int(sys.argv[1]) if len(sys.argv) > 1 else 16
    made = {}
    for name, air in AIRS.items():
        made[name] = np.stack([[channels(radiance(Air(**air), altitude, seed)) for altitude in ALTITUDES]
                               for seed in range(runs if name == "standard" else max(runs // 4, 2))])
        print(name, flush=True)
    # Other atmospheres are smoothed as ratios to the standard one, because runs with the same seed share their noise.
    standard = without_noise(made["standard"], 0.0015)
    lines = ["# source: make_twilight_sky.py: backward Monte Carlo in round air, all orders of scattering",
             "# units: degrees (the Sun's geometric altitude; altitude), 1000 log10 of linear Rec.709 [cd/m2] for azimuths from the Sun's of",
             "# " + ", ".join(f"{a:g}" for a in AZIMUTHS) + " degrees",
             "air,sun_deg,altitude_deg," + ",".join(f"{c}_{a:g}" for a in AZIMUTHS for c in "rgb")]
    for number, name in enumerate(AIRS):
        light = standard.copy()
        if name != "standard":
            light += without_noise(made[name] / made["standard"][:len(made[name])], 0.003)
        for s, r in np.ndindex(len(SUNS), len(ALTITUDES)):
            numbers = np.rint(1000 * light[r, s]).astype(int).ravel()
            lines.append(f"{number},{SUNS[s]:g},{ALTITUDES[r]:g}," + ",".join(map(str, numbers)))
    path = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else DATA / "twilight_sky.csv"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
