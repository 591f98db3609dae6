// SPDX-License-Identifier: MIT
// Dims and reddens moonlight by the air above the observer (atmosphere::transmittance_above).

import {refraction} from './motion.js';
import {colours} from './plane.js';
import {degree} from './vectors.js';

const lowest = -0.5739;  // altitude without refraction of an object that is seen on the horizon [degrees]
// Light is computed at altitudes in equal steps of log(altitude + shift) and interpolated between them.
const shift = 3.5, step = Math.log(1.12);

const altitudeOf = (node) => Math.min(90, (lowest + shift) * Math.exp(step * node) - shift);

/** Air masses at a true altitude [degrees]: Young (1994), ozone in a layer 22 km high, aerosol by Schaefer (1993). */
function airMasses(altitude) {
  const sine = Math.sin(altitude * degree);
  const apparent = Math.min(90, Math.max(0, altitude + refraction(altitude))) * degree;
  const seen = Math.sin(apparent), level = 6378 / 6400 * Math.cos(apparent);
  return [
    (1.002432 * sine ** 2 + 0.148386 * sine + 0.0096467) /
      (sine ** 3 + 0.149864 * sine ** 2 + 0.0102963 * sine + 0.000303978),
    1 / Math.sqrt(1 - level * level),
    1 / (seen + 0.0123 * Math.exp(-24.5 * seen))];
}

/** Ratio of pressure at an elevation to that at sea level, as in atmosphere::pressure_ratio_us_1976. */
export const pressureRatio = (km) =>
  (1 - 6.5 * Math.min(km, 11) / 288.15) ** 5.2559 * Math.exp(-Math.max(km - 11, 0) / 6.3416);

/** Light in one state of the Earth's air, as seen with the Moon at any altitude. */
export class Sightline {
  /** Given  tableOf  makes a table (Shadow.table) of the light times a transmittance by wavelength */
  constructor(arrays, tableOf) {
    const {shape, data} = arrays['observer.depths'];
    this.depths = [0, 1, 2].map((i) => data.subarray(i * shape[1], (i + 1) * shape[1]));
    this.tableOf = tableOf;
    this.tables = {};  // tables of light, by altitude and elevation
  }

  /** Optical depth of the observer's air by wavelength. */
  depth(altitude, elevationKm) {
    const masses = airMasses(altitude), [air, ozone, aerosol] = this.depths, pressure = pressureRatio(elevationKm);
    return air.map((depth, w) => masses[0] * pressure * depth + masses[1] * ozone[w] + masses[2] * aerosol[w]);
  }

  /** Table of the light through the air at a true altitude. */
  made(altitude, elevationKm) {
    return this.tableOf(this.depth(altitude, elevationKm).map((depth) => Math.exp(-depth)));
  }

  /** Table of light at a true altitude [degrees], at least the horizon's. The first is made for its exact altitude. */
  table(altitude, elevationKm) {
    const seen = Math.max(altitude, lowest), asked = `${seen} ${elevationKm}`;
    this.first ??= {asked, table: this.made(seen, elevationKm)};
    if (this.first.asked === asked) return this.first.table;
    const node = Math.floor(Math.log((seen + shift) / (lowest + shift)) / step + 1e-9);
    const [low, high] = [node, node + 1].map((i) =>
      (this.tables[`${i} ${elevationKm}`] ??= this.made(altitudeOf(i), elevationKm)));
    const middle = this.depths[0].length >> 1;  // index of the wavelength 585 nm
    const [depth, from, to] = [seen, altitudeOf(node), altitudeOf(node + 1)].map((at) => this.depth(at, elevationKm)[middle]);
    const part = (depth - from) / (to - from || 1);
    return {...low, values: between(low.values, high.values, part)};
  }
}

const weak = -7;  // level below which a channel is weak [log2, relative to the strongest channel]

/** Logarithms interpolated between two tables. For weak channels, the ratio to the strongest is interpolated. */
function between(low, high, part) {
  const values = new Float32Array(low.length);
  for (let i = 0; i < low.length; i += colours) {
    const least = Math.max(low[i], low[i + 1], low[i + 2]), most = Math.max(high[i], high[i + 1], high[i + 2]);
    for (let c = i; c < i + colours; ++c) {
      const from = low[c] - least, to = high[c] - most;
      values[c] = least + part * (most - least) +
        (Math.min(from, to) < weak ? Math.log2((1 - part) * 2 ** from + part * 2 ** to) : from + part * (to - from));
    }
  }
  return values;
}
