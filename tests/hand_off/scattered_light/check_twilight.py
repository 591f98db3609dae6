# SPDX-License-Identifier: MIT
"""check_twilight.py WRITE_TWILIGHT: sasktran2 finds the light that air scatters onto the shadow's axis, in the same ozone and aerosol; its
own are the molecules and the US standard atmosphere. What our light leaves out is as large as twilight.h says."""
import json
import subprocess
import sys

import numpy as np
import sasktran2 as sk

# single-scattering albedo and asymmetry, as atmosphere::scattering has them
AEROSOLS = {"clear": (0, 0), "background": (1, 0.685), "moderate": (0.947, 0.698), "high": (0.947, 0.698),
            "extreme": (0.855, 0.747)}
MOMENTS = 64  # 0.747^64 is 1e-8


def irradiance(air, aerosol, multiple=False, refraction=False, ground=0.0):
    """Scattered light on the axis over unshaded sunlight, by wavelength: the limb's radiance, ring by ring."""
    radius, moon = air["radius_m"], air["moon_m"]
    albedo, asymmetry = aerosol
    config = sk.Config()
    config.num_singlescatter_moments = MOMENTS
    config.num_streams = 16
    config.num_sza = 9  # 17 change multiple scattering by a tenth
    config.los_refraction = refraction
    config.multiple_scatter_source = getattr(sk.MultipleScatterSource, "DiscreteOrdinates" if multiple else "NoSource")
    edges = np.concatenate([np.arange(0, 40e3, 500), np.arange(40e3, 86.1e3, 2e3)])
    heights, widths = (edges[1:] + edges[:-1]) / 2, np.diff(edges)
    # a sight from the Moon is as far off the sunlight's direction as its lowest point is off the axis
    sun = lambda height: -(radius + height) / moon
    geometry = sk.Geometry1D(sun(10e3), 0, radius, np.array(air["altitudes_m"]), sk.InterpolationMethod.LinearInterpolation,
                             sk.GeometryType.Spherical)
    geometry.refractive_index = np.array(air["refractive_index"])
    sights = sk.ViewingGeometry()
    for height in heights:  # from beyond the air it does not matter how far away
        sights.add_ray(sk.TangentAltitudeSolar(height, 0, 1e6, sun(height)))
    model = sk.Atmosphere(geometry, config, wavelengths_nm=np.array(air["wavelengths_nm"], float), calculate_derivatives=False)
    sk.climatology.us76.add_us76_standard_atmosphere(model)
    model["air"] = sk.constituent.Rayleigh()
    ozone, particles = np.array(air["ozone_per_m"]), np.array(air["aerosol_per_m"])
    model["ozone"] = sk.constituent.Manual(ozone, np.zeros_like(ozone))
    order = np.arange(MOMENTS)
    henyey_greenstein = ((2 * order + 1) * asymmetry**order)[:, None, None] * np.ones_like(particles)
    model["aerosol"] = sk.constituent.Manual(particles, np.full_like(particles, albedo), henyey_greenstein)
    model.surface.albedo[:] = ground
    radiance = sk.Engine(config, geometry, sights).calculate_radiance(model)["radiance"].values[:, :, 0]
    nearer_to_the_sun = (1 + moon / air["sun_m"]) ** 2
    return 2 * np.pi / moon**2 * radiance @ ((radius + heights) * widths) * nearer_to_the_sun


def tube_by_tube(air, aerosol, bent):
    """The same, scattered once out of tubes of sunlight, each bent on its way with all its light; sights are straight."""
    radius, moon = air["radius_m"], air["moon_m"]
    albedo, g = aerosol
    altitudes = np.array(air["altitudes_m"])
    molecules, particles = np.array(air["air_per_m"]), np.array(air["aerosol_per_m"])
    table = np.hstack([molecules + np.array(air["ozone_per_m"]) + particles, molecules, particles])
    slope = np.append(np.diff(air["refractive_index"]) / np.diff(altitudes), 0)
    middles = altitudes + (altitudes[1] - altitudes[0]) / 2
    waves, reach, step, tube = molecules.shape[1], 1.06e6, 10e3, 250

    def at(height):  # of extinction, molecules' and particles'; none above the last altitude
        place = np.clip(height / altitudes[1], 0, len(altitudes) - 1.001)
        low, part = place.astype(int), (place % 1)[..., None]
        return np.where((height < altitudes[-1])[..., None], table[low] * (1 - part) + table[low + 1] * part, 0)

    # optical depth from the lowest point of a straight line outwards: (lowest altitude, distance from there)
    out = np.arange(0, reach, step / 2)
    slants = at(np.hypot(radius + altitudes[:, None], out) - radius)[..., :waves]
    slants = np.insert(np.cumsum((slants[:, 1:] + slants[:, :-1]) / 2 * step / 2, 1), 0, 0, 1)

    def slant(lowest, along):
        v, u = np.clip(lowest / altitudes[1], 0, len(slants) - 1.001), np.clip(along / out[1], 0, len(out) - 1.001)
        i, j, v, u = v.astype(int), u.astype(int), (v % 1)[:, None], (u % 1)[:, None]
        return ((slants[i, j] * (1 - u) + slants[i, j + 1] * u) * (1 - v) +
                (slants[i + 1, j] * (1 - u) + slants[i + 1, j + 1] * u) * v)

    impact = np.arange(radius - 4e3, radius + 85.9e3, tube) + tube / 2
    place = np.stack([np.full_like(impact, -reach), impact], 1)  # along the axis, off it
    way = np.stack([np.ones_like(impact), np.zeros_like(impact)], 1)
    depth, lit, light = np.zeros((len(impact), waves)), np.full(len(impact), True), np.zeros(waves)

    def turn(place, way):
        r = np.linalg.norm(place, axis=1)
        pull = (np.interp(r - radius, middles, slope, right=0) * bent / r)[:, None] * place
        return pull - np.sum(pull * way, 1)[:, None] * way

    for _ in range(int(2 * reach / step)):
        middle, along = place + way * step / 2, way + turn(place, way) * step / 2
        height = np.linalg.norm(middle, axis=1) - radius
        lit &= height >= 0
        extinction, molecular, particular = np.split(at(np.maximum(height, 0)), 3, 1)
        sight = np.array([moon, 0]) - middle
        distance = np.linalg.norm(sight, axis=1)
        sight /= distance[:, None]
        beyond = np.sum(middle * sight, 1)  # of the sight's lowest point
        lowest = np.abs(middle[:, 0] * sight[:, 1] - middle[:, 1] * sight[:, 0]) - radius
        seen = lit & ((beyond > 0) | (lowest > 0))
        onward = slant(lowest, np.full_like(lowest, reach)) - np.sign(beyond)[:, None] * slant(lowest, np.abs(beyond))
        cosine = np.sum(along * sight, 1)[:, None]
        scattered = (molecular * 0.75 * (1 + cosine**2) +
                     particular * albedo * (1 - g**2) / (1 + g**2 - 2 * g * cosine) ** 1.5) / (4 * np.pi)
        share = np.where(seen, 2 * np.pi * impact * tube * step / distance**2, 0)
        light += share @ (scattered * np.exp(-depth - extinction * step / 2 - onward))
        depth += extinction * step
        way = way + turn(middle, along) * step
        place = place + along * step
    return light * (1 + moon / air["sun_m"]) ** 2


failed = False


def expect(what, values, low, high, why):
    global failed
    right = np.all((low <= values) & (values <= high))
    failed |= not right
    print("" if right else "WRONG ", what, np.round(values, 4), f"allowed {low} to {high}: {why}")


airs = json.loads(subprocess.run(sys.argv[1:2], capture_output=True, check=True).stdout)
for name, air in airs.items():
    once = irradiance(air, AEROSOLS[name])
    expect(f"{name}: ours over sasktran2's", np.array(air["twilight"]) / once, 0.985, 1.015,
           "the accuracy that twilight.h states; 1 % is depolarisation")
    expect(f"{name}: refraction of sights", irradiance(air, AEROSOLS[name], refraction=True) / once - 1, -0.015, 0.015,
           "1 %, as twilight.h has it")
    straight, bent = (tube_by_tube(air, AEROSOLS[name], bent) for bent in (0, 1))
    expect(f"{name}: ours over the sum over tubes of sunlight", np.array(air["twilight"]) / straight, 0.99, 1.01, "steps of 10 km")
    expect(f"{name}: refraction of sunlight", bent / straight - 1, -0.015, 0.015, "1 %, as twilight.h has it")
    more = irradiance(air, AEROSOLS[name], multiple=True) / once - 1
    if name == "clear":
        expect("clear: multiple scattering", more, 0.045, 0.095, "5 to 9 %, as twilight.h has it")
        over_ground = irradiance(air, AEROSOLS[name], multiple=True, ground=0.3) / once - 1
        expect("clear: what ground of albedo 0.3 adds", over_ground - more, 0, 0.015, "1 %, as twilight.h has it")
    else:
        expect(f"{name}: multiple scattering", more, 0.015, 0.115, "2 to 11 %, as twilight.h has it")
sys.exit(failed)
