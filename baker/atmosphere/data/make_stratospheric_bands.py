#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes stratospheric_bands.csv: the stratosphere's aerosol by month, latitude and height, 1979 to 2026.

Usage: make_stratospheric_bands.py FOLDER [stratospheric_bands.csv] [stratospheric_shapes.csv]

FOLDER holds these CSV tables. Comment lines that begin with `#` may precede the header:
  glossac_v1_saod1020_bands_monthly_1979_2016.csv  year,month,b90S-60S,...,b60N-90N,global_80S_80N: optical depth at
      1020 nm in bands of latitude (GloSSAC 1; Thomason et al. 2018, Earth Syst. Sci. Data 10, 469)
  global_monthly_glossac_1979_2024_igcc_plot.csv   year,month,saod_550nm: global mean (GloSSAC 2.23, through the
      Indicators of Global Climate Change)
  global_monthly_saod_2013_2025_igcc_plot.csv      year,month,...,omps_v11_scaled_550nm: global mean from OMPS-LP
  eva_h_shapefunctions.csv                         lat,z_km,box1,...,box8: extinction / mean optical depth of the box
  msvolso2l4_v4_explosive_1979_2024.csv            volcano,year,month,day,lat,height_km,so2_kt,vei (Carn, MSVOLSO2L4)

Optical depths of the bands were measured until 2016, the global mean until 2024. The rest comes from EVA_H (Aubry et
al. 2020, J. Geophys. Res. 125, e2019JD031303, version 2), in which eruptions put sulphur dioxide into eight boxes of
latitude and height. The model divides the aerosol above the background among heights and, from 2017 on, among bands.
The aerosol of Hunga (January 2022) is the remainder of the measured global mean, divided among the bands as published.
"""
import csv
import sys

import numpy as np

BANDS = ["90S-60S", "60S-30S", "30S-0", "0-30N", "30N-60N", "60N-90N"]
EDGES = np.array([-90, -60, -30, 0, 30, 60, 90])
AREA = np.diff(np.sin(np.radians(EDGES))) / 2
LAYERS = [(6, 7), (3, 4, 5), (0, 1, 2)]  # boxes below 16 km, from 16 to 20 km, above 20 km
FIRST, LAST = 1979, 2025
MONTHS = (LAST - FIRST + 1) * 12

# Parameters of EVA_H, version 2, in months and Tg of sulphur.
LOSS = np.array([1.94, 18.8, 1.94, 2.68, 57.7, 2.68, 4.5, 4.5])
MIXING = 9.2
DEPTH_PER_TG = 0.0229
BACKGROUND_TG = np.array([.0021, .0116, .0035, .0003, .0001, .0004, .0023, .0032])  # a month; values of version 1
BELOW = {0: 3, 1: 4, 2: 5, 3: 6, 5: 7}  # for each box, the box into which its sulphate settles
TROPOPAUSE = {"south": 10.3, "tropics": 15.9, "north": 10.7}  # km, annual means beyond and within 25 degrees

BACKGROUND = 0.0042  # global mean optical depth at 550 nm from 1999 to 2004
QUIET_EXPONENT, HUNGA_EXPONENT = 1.65, 0.3  # Angstrom, 550 to 1020 nm; Hunga's is for an effective radius of 0.4 um
OMPS_TOO_HIGH = 0.774  # GloSSAC divided by OMPS-LP, June to December 2024

# Optical depth of Hunga's aerosol in each band of latitude, divided by its global mean. The estimates are uncertain by
# a third. The aerosol lay between 35 S and 20 N until June 2022; later it spread further.
HUNGA = [(2022.04, (0, 0.1, 3.2, 0.7, 0, 0)), (2022.37, (0, 0.8, 2.5, 0.9, 0, 0)),
         (2022.85, (0.6, 2.2, 1.5, 0.7, 0.15, 0)), (2023.5, (1.4, 1.8, 1.0, 0.7, 0.5, 0.4)),
         (2024.5, (1.3, 1.3, 0.9, 0.8, 0.8, 0.8))]
HUNGA_LAYERS = [(2022.04, (0, 0.03, 0.97)), (2022.85, (0, 0.12, 0.88)), (2023.5, (0.05, 0.3, 0.65)),
                (2024.5, (0.1, 0.4, 0.5))]


def table(path):
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def monthly(rows, column):
    values = np.full(MONTHS, np.nan)
    for row in rows:
        if row[column]:
            values[(int(row["year"]) - FIRST) * 12 + int(row["month"]) - 1] = float(row[column])
    return values


def settling_and_mixing():
    c = np.zeros((8, 8))
    for box in range(8):
        c[box, box] -= 1 / LOSS[box]
        if box in BELOW:
            c[BELOW[box], box] += 1 / LOSS[box]
    for a, b in ((0, 1), (1, 2), (3, 4), (4, 5)):
        for one, other in ((a, b), (b, a)):
            c[one, other] += 1 / MIXING
            c[one, one] -= 1 / MIXING
    return c


def share(low, high, middle, width):
    """The fraction of a Gaussian exp(-((x - middle) / width)^2) that lies between low and high."""
    x = np.linspace(middle - 4 * width, middle + 4 * width, 4001)
    y = np.exp(-((x - middle) / width) ** 2)
    return y[(x >= low) & (x < high)].sum() / y.sum()


def injected(eruption):
    """Sulphur [Tg] that an eruption puts into each of the model's boxes."""
    height, latitude = float(eruption["height_km"]), float(eruption["lat"])
    south, tropics, north = (share(*edges, latitude, 7) for edges in ((-999, -25), (-25, 25), (25, 999)))
    top, middle = share(20, 999, height, 1.2), share(TROPOPAUSE["tropics"], 20, height, 1.2)
    low = [share(TROPOPAUSE[side], TROPOPAUSE["tropics"], height, 1.2) for side in ("south", "north")]
    parts = [south * top, tropics * top, north * top, south * middle, tropics * middle, north * middle,
             south * low[0], north * low[1]]
    return 0.50052e-3 * float(eruption["so2_kt"]) * np.array(parts)


def sulphate(eruptions):
    """Monthly means of the mass of sulphate from eruptions [Tg of sulphur], indexed by [month][box]."""
    steps = 50
    c, mass, months = settling_and_mixing(), np.zeros(8), np.zeros((MONTHS, 8))
    plumes = []
    for one in eruptions:
        tg = injected(one)
        if tg.sum() > 0:
            time = (int(one["year"]) - FIRST) * 12 + int(one["month"]) - 1 + (int(one["day"]) - 1) / 30.4
            plumes.append((time, tg, max(0.0115 * (1 + 9.81 * float(one["height_km"])) * tg.sum() ** 0.311, 0.1)))
    for step in range(MONTHS * steps):
        now = (step + 0.5) / steps
        made = sum((tg / tau * np.exp(-(now - time) / tau) for time, tg, tau in plumes if 0 <= now - time < 20 * tau),
                   np.zeros(8))
        mass = mass + (c @ mass + made) / steps
        months[step // steps] += mass / steps
    return months


def by_band(shapes):
    """Optical depths [band][box], extinctions [band][box][height] in 1/km, heights in km, for boxes of mean depth 1."""
    latitudes, heights = (sorted({float(row[key]) for row in shapes}) for key in ("lat", "z_km"))
    extinction = np.zeros((len(BANDS), 8, len(heights)))
    weights = np.zeros(len(BANDS))
    for row in shapes:
        latitude = float(row["lat"])
        band = np.searchsorted(EDGES, latitude) - 1
        weight = np.cos(np.radians(latitude))
        extinction[band, :, heights.index(float(row["z_km"]))] += weight * np.array(
            [float(row[f"box{i}"]) for i in range(1, 9)])
    for latitude in latitudes:
        weights[np.searchsorted(EDGES, latitude) - 1] += np.cos(np.radians(latitude))
    extinction /= weights[:, None, None]
    return extinction.sum(axis=2) * 0.5, extinction, np.array(heights)


def in_layers(depth_of_boxes, mass):
    """Optical depths, indexed by [band of latitude][layer], that result from the mass of sulphate in each box."""
    return np.stack([sum(depth_of_boxes[:, box] * mass[box] for box in layer) for layer in LAYERS], axis=1)


def between(knots, year):
    years, values = [k[0] for k in knots], np.array([k[1] for k in knots])
    return np.array([np.interp(year, years, column) for column in values.T])


def main():
    folder = sys.argv[1]
    out = sys.argv[2] if len(sys.argv) > 2 else "stratospheric_bands.csv"
    out_shapes = sys.argv[3] if len(sys.argv) > 3 else "stratospheric_shapes.csv"
    bands = table(f"{folder}/glossac_v1_saod1020_bands_monthly_1979_2016.csv")
    band_1020 = np.stack([monthly(bands, "b" + name) for name in BANDS], axis=1)
    global_1020 = monthly(bands, "global_80S_80N")
    global_550 = monthly(table(f"{folder}/global_monthly_glossac_1979_2024_igcc_plot.csv"), "saod_550nm")
    omps = monthly(table(f"{folder}/global_monthly_saod_2013_2025_igcc_plot.csv"), "omps_v11_scaled_550nm")
    global_550 = np.where(np.isnan(global_550), OMPS_TOO_HIGH * omps, global_550)
    depth_of_boxes, profiles, heights = by_band(table(f"{folder}/eva_h_shapefunctions.csv"))
    eruptions = table(f"{folder}/msvolso2l4_v4_explosive_1979_2024.csv")
    hunga = [e for e in eruptions if "Hunga" in e["volcano"] and e["year"] == "2022"]
    erupted = DEPTH_PER_TG * sulphate([e for e in eruptions if e not in hunga])

    quiet = np.linalg.solve(-settling_and_mixing(), BACKGROUND_TG)
    quiet_layers = in_layers(depth_of_boxes, quiet)
    quiet_layers /= quiet_layers.sum(axis=1, keepdims=True)
    ratio = global_550 / global_1020
    quiet_months = [i for i in range(MONTHS) if 1999 <= FIRST + i // 12 <= 2004]
    background = np.stack([np.mean([band_1020[i] * ratio[i] for i in quiet_months if i % 12 == month], axis=0)
                           for month in range(12)])
    background *= BACKGROUND / (background @ AREA).mean()

    rows = []
    for i in range(MONTHS):
        year = FIRST + (i + 0.5) / 12
        below = background[i % 12]
        of_eruptions = in_layers(depth_of_boxes, erupted[i])
        exponents = np.full(len(BANDS), QUIET_EXPONENT)
        if not np.isnan(global_1020[i]):
            depth = band_1020[i] * ratio[i]
            calm = np.minimum(depth, below)
            sums = of_eruptions.sum(axis=1, keepdims=True)
            pattern = np.where(sums > 1e-5, of_eruptions / np.maximum(sums, 1e-5), quiet_layers)
            layers = calm[:, None] * quiet_layers + (depth - calm)[:, None] * pattern
            exponents[:] = np.clip(np.log(ratio[i]) / np.log(1020 / 550), 0, 2.2)
        else:
            excess = global_550[i] - below @ AREA
            layers = (below * min(1, global_550[i] / (below @ AREA)))[:, None] * quiet_layers
            mean = of_eruptions.sum(axis=1) @ AREA
            of_hunga = 0 if year < 2022.04 else max(0, excess - mean)
            layers = layers + max(0, excess - of_hunga) / mean * of_eruptions
            if of_hunga:
                there = of_hunga * between(HUNGA, year) / (between(HUNGA, year) @ AREA)
                exponents += (HUNGA_EXPONENT - QUIET_EXPONENT) * there / (layers.sum(axis=1) + there)
                layers = layers + there[:, None] * between(HUNGA_LAYERS, year)
        rows.append([year, *layers.ravel(), *exponents])
    quiet_again = np.mean([row[1:] for row in rows if 2014 <= row[0] < 2019], axis=0)
    rows.append([2027.0, *quiet_again])

    names = [f"{layer}_{name}" for name in BANDS for layer in ("low", "middle", "high")]
    with open(out, "w", encoding="utf-8") as file:
        file.write("# source: make_stratospheric_bands.py has sources and model; measured by band to 2016, as global mean to 2024;\n"
                   "# source: 2025 OMPS-LP; from 2027 on the mean of 2014 to 2018\n"
                   "# units: years, vertical optical depths at 550 nm of the layers below 16 km, 16 to 20 km and above by band of\n"
                   "# units: latitude; Angstrom's exponents between 550 and 1020 nm\n")
        file.write(",".join(["year", *names, *(f"exponent_{name}" for name in BANDS)]) + "\n")
        for row in rows:
            file.write(",".join([f"{row[0]:.3f}", *(f"{x:.5f}".rstrip("0").rstrip(".") or "0" for x in row[1:19]),
                                 *(f"{x:.2f}" for x in row[19:])]) + "\n")

    mean_mass = erupted.mean(axis=0)
    with open(out_shapes, "w", encoding="utf-8") as file:
        file.write("# source: shape functions of EVA_H (Aubry et al. 2020, J. Geophys. Res. 125, e2019JD031303; CC0), means of bands of\n"
                   "# source: latitude, boxes of one height weighed by what eruptions of 1979 to 2024 left in them\n"
                   "# units: km, extinction over the layer's vertical optical depth [1/km]\n")
        file.write(",".join(["altitude_km", *names]) + "\n")
        columns = []
        for band in range(len(BANDS)):
            for layer in LAYERS:
                shape = sum(profiles[band, box] * mean_mass[box] for box in layer)
                columns.append(shape / (shape.sum() * 0.5))
        for k, height in enumerate(heights):
            file.write(",".join([f"{height:g}", *(f"{column[k]:.4f}".rstrip("0").rstrip(".") or "0"
                                                   for column in columns)]) + "\n")


if __name__ == "__main__":
    main()
