// SPDX-License-Identifier: MIT
// Sums the light in the Earth's shadow from rays at the limb, as a function of axis distance, position angle and depth.

import {aerosolDepth, cloudCover, LimbRays, meanOver} from './air.js';
import {channels, colours, landing, nodes, Plane, sectors, sheared, stretches} from './plane.js';
import {luminance} from './vectors.js';

export class Shadow {
  /** Given  sunDistance  [km];  depths  of the planes, nearest first [km] */
  constructor(facts, arrays, sunDistance, depths) {
    this.facts = facts;
    this.rays = new LimbRays(facts, arrays);
    this.sunDistance = sunDistance;
    this.depths = depths;
    this.middleDepth = (depths[0] + depths[1]) / 2;
    this.waves = facts.wavelengths.length;
    const table = (name, width) => Array.from(
      {length: arrays[name].data.length / width}, (_, i) => arrays[name].data.subarray(i * width, (i + 1) * width));
    this.terms = table('sun.terms', 6);
    this.termBrightness = table('sun.brightness', this.waves);
    this.layers = [...arrays['sun.layers'].data];
    this.layerBrightness = table('sun.layerBrightness', this.waves);
    this.weights = table('weights', this.waves);
    this.meanWeights = this.weights.slice(0, colours).map((row, c) =>
      row.map((weight, w) => (weight + this.weights[c + colours][w]) / 2));
    this.meanGreen = this.meanWeights[1].reduce((a, b) => a + b, 0);
    this.least = this.weights.map((row) => 1e-12 * row.reduce((a, b) => a + b, 0));
    const {shape, data} = arrays['limb.series'];
    this.scattered = arrays.scattered;
    this.harmonics = shape[2];
    this.series = table('limb.series', this.harmonics);  // for each part, a row of cosines and a row of sines
    this.turning = data.some((value, i) => value !== 0 && Math.floor(i / this.harmonics) % 2 === 1);
    const top = facts.earth.equatorialKm + facts.limb.topKm;
    this.endKm = landing(top, 0, sunDistance, depths[1]) + facts.sun.radiusKm * depths[1] / sunDistance;
    const begins = landing(top, 0, sunDistance, this.middleDepth) -
      facts.sun.radiusKm * this.middleDepth / sunDistance;  // axis distance at which direct sunlight begins
    this.ends = [begins - 160, begins + 440, this.endKm];  // axis distances at which ranges of equal node spacing end
    this.planes = depths.map((depth) => new Plane(this, depth));
  }

  /** Axis distance of a node [km]. */
  distanceOf(node) {
    let from = 0, left = node;
    for (let s = 0; s < 3; ++s) {
      if (left <= stretches[s] || s === 2) return from + (this.ends[s] - from) * left / stretches[s];
      [from, left] = [this.ends[s], left - stretches[s]];
    }
    return from;
  }

  /** Changes the air, and with it the light that lands on each plane: [plane][part][wavelength][bin]. */
  setAir(air) {
    this.air = air;
    this.landed = this.planes.map(() => []);
    this.spectral = [];  // light at each wavelength, as a series in position angle; computed when first needed
    for (let p = 0; p < this.rays.parts.length; ++p)
      for (let w = 0; w < this.waves; ++w) {
        const {paths, amounts} = this.followed(air, p, w);
        const through = this.rays.transmittance(air, p, w, amounts);
        const part = this.rays.parts[p];
        this.planes.forEach((plane, k) =>
          (this.landed[k][p] ??= []).push(plane.landed(paths, through, cloudCover(air, part), part.cloudTopKm)));
      }
  }

  /** Paths and amounts for a part's rays at a wavelength, kept until refraction changes. */
  followed(air, part, wave) {
    if (this.pathsAre !== air.refraction) [this.pathsAre, this.paths] = [air.refraction, []];
    return this.paths[part * this.waves + wave] ??= {
      paths: this.rays.paths(air, part, wave), amounts: this.rays.amountsOf(air, part, wave)};
  }

  /**
   * Light that lands on a plane from a point on the Sun, as a series in position angle, for each term of the Sun's disc
   * and each weighted sum over wavelengths. Light from both sides of the axis is added up.
   *
   * Returned [harmonic, cosine before sine][bin][term × weights]
   */
  shed(k, weights) {
    const {bins} = this.planes[k], {harmonics, terms} = this;
    const width = terms.length * weights.length;
    const sides = this.turning ? 2 : 1;
    const shed = Array.from({length: harmonics * sides}, () => new Float32Array(bins * width));
    this.landed[k].forEach((byWave, p) => {
      const inWeights = new Float64Array(2 * bins * width);
      byWave.forEach((landed, w) => {
        const factor = new Float64Array(width);
        for (let t = 0; t < terms.length; ++t)
          for (let c = 0; c < weights.length; ++c)
            factor[t * weights.length + c] = this.termBrightness[t][w] * weights[c][w];
        for (let b = 0; b < 2 * bins; ++b) {
          if (landed[b] === 0) continue;
          for (let i = 0; i < width; ++i) inWeights[b * width + i] += landed[b] * factor[i];
        }
      });
      for (let side = 0; side < sides; ++side)
        for (let m = 0; m < harmonics; ++m) {
          const share = this.series[2 * p + side][m];
          if (share === 0) continue;
          const across = m % 2 === 0 ? share : -share;  // light that crosses the axis lands at the opposite angle
          const to = shed[side * harmonics + m], half = bins * width;
          for (let i = 0; i < half; ++i) to[i] += share * inWeights[i] + across * inWeights[half + i];
        }
    });
    return shed;
  }

  /** Light from the Sun's disc at an axis distance, as a series: [harmonic, cosine before sine][weight]. */
  gathered(k, arcs, shed, count) {
    const {first, last, values} = arcs, {harmonics, terms} = this;
    const size = terms.length * harmonics, width = terms.length * count;
    const series = new Float64Array(shed.length * count);
    for (let h = 0; h < shed.length; ++h) {
      const m = h % harmonics, from = shed[h];
      for (let t = 0; t < terms.length; ++t)
        for (let bin = first; bin < last; ++bin) {
          const arc = values[(bin - first) * size + t * harmonics + m];
          const at = bin * width + t * count;
          for (let c = 0; c < count; ++c) series[h * count + c] += arc * from[at + c];
        }
    }
    for (let i = 0; i < series.length; ++i) series[i] *= this.planes[k].factor;
    return series;
  }

  /** Sum of a series at a position angle. */
  summed(series, angle, count) {
    const sums = new Float64Array(count);
    for (let h = 0; h * count < series.length; ++h) {
      const m = h % this.harmonics;
      const turn = h < this.harmonics ? Math.cos(m * angle) : Math.sin(m * angle);
      for (let c = 0; c < count; ++c) sums[c] += turn * series[h * count + c];
    }
    return sums;
  }

  /**
   * Table for lighting the picture: log2 of the radiance of white ground that faces the Sun at 1 au.
   *
   * Given    through  transmittance of the observer's air by wavelength; if absent, there is no such air
   * Returned {values: [plane][sector, the first again at the end][node][channel], nodes, rows}
   */
  table(through = null) {
    const weights = through ? this.weights.map((row) => row.map((weight, w) => weight * through[w])) : this.weights;
    const layerWeights = weights.map((row) => this.layerBrightness.map((layer) => summedUp(row, layer)));
    const values = new Float32Array(this.planes.length * (sectors + 1) * nodes * channels);
    this.planes.forEach((plane, k) => {
      const shed = this.shed(k, weights), direct = plane.direct(layerWeights);
      plane.allArcs().forEach((arcs, i) => {
        const ratios = this.scatteredAt(this.distanceOf(i)), scattered = weights.map((row) => summedUp(row, ratios));
        const series = this.gathered(k, arcs, shed, channels);
        for (let s = 0; s < sectors; ++s) {
          const light = this.summed(series, 2 * Math.PI * s / sectors, channels);
          for (let c = 0; c < channels; ++c) light[c] += scattered[c] + direct[(s * nodes + i) * channels + c];
          store(light, values, ((k * (sectors + 1) + s) * nodes + i) * channels, this.least);
        }
      });
      const row = nodes * channels, start = k * (sectors + 1) * row;
      values.copyWithin(start + sectors * row, start, start + row);
    });
    return {values, nodes, stretches, rows: this.planes.length * (sectors + 1), sectors};
  }

  /** Calls a function with `air` and `landed` temporarily replaced by those of another Shadow. */
  inAir(other, act) {
    const {air, landed} = this;
    Object.assign(this, other);
    const made = act();
    Object.assign(this, {air, landed});
    return made;
  }

  /**
   * Ratio of the light that the air scatters into the shadow to sunlight, by wavelength, interpolated in logarithms
   * between optical depths of stratospheric aerosol. Apart from the switch for scattering, no other change to the air
   * matters. On Danjon's scale it is 0, since that air already accounts for all light that was seen.
   */
  scatteredAt(distance) {
    const [, distances, waves] = this.scattered.shape, {data} = this.scattered;
    if (!this.facts.scatters || !this.air.scattering || this.air.clearness !== 0) return new Float64Array(waves);
    const [low, high, part] = this.scatteringAmounts();
    const place = Math.min(distance / 2000, distances - 1.001), d = Math.floor(place), along = place - d;
    const value = (amount, w) => {
      const at = (amount * distances + d) * waves + w;
      return data[at] + along * (data[at + waves] - data[at]);
    };
    return Float64Array.from({length: waves}, (_, w) => {
      const a = value(low, w), b = value(high, w);
      return a > 0 && b > 0 ? a * (b / a) ** part : a;
    });
  }

  /** The two rows of the table on either side of the aerosol's mean depth, and its place between them. */
  scatteringAmounts() {
    const {parts} = this.rays;
    const depth = meanOver(parts, (part) => aerosolDepth(this.air, part));
    if (depth === meanOver(parts, (part) => part.aerosolDepth)) return [0, 0, 0];
    const steps = this.facts.limb.aerosolSteps, step = steps.findLastIndex((one) => one <= depth);
    if (step < 0) return [1, 2, depth / steps[0]];
    if (step + 1 === steps.length) return [step + 2, step + 2, 0];
    return [step + 2, step + 3, Math.log(depth / steps[step]) / Math.log(steps[step + 1] / steps[step])];
  }

  /** A series for each single wavelength. */
  spectralShed(k) {
    const each = () => Array.from({length: this.waves}, (_, w) =>
      Float64Array.from({length: this.waves}, (_, i) => (i === w ? 1 : 0)));
    return this.spectral[k] ??= this.shed(k, each());
  }

  /** Ratio of light to sunlight by wavelength, at a place in the shadow (placeInShadow). */
  spectrum(place) {
    const k = Math.abs(place.depth - this.depths[0]) < Math.abs(place.depth - this.depths[1]) ? 0 : 1;
    const plane = this.planes[k];
    const gamma = sheared(place.axisDistance, plane.depth / place.depth);
    const series = this.gathered(k, plane.arcs(gamma), this.spectralShed(k), this.waves);
    const light = this.summed(series, place.angle, this.waves);
    this.scatteredAt(place.axisDistance).forEach((ratio, w) => { light[w] += ratio; });
    plane.clearParts(gamma, place.angle).forEach((clear, l) => {
      for (let w = 0; w < this.waves; ++w) light[w] += clear * this.layerBrightness[l][w];
    });
    return light.map((ratio) => Math.max(0, ratio));
  }

  /**
   * Ring of sunsets seen from a place in the shadow: the luminance of the Sun's image relative to that of its disc, in
   * red, green and blue.
   *
   * Given    angles  number of position angles
   * Returned [angle][ray × 3], rays from the ground up
   */
  ring(place, angles) {
    const {rays} = this.rays, x = place.axisDistance * Math.sin(place.angle), y = place.axisDistance * Math.cos(place.angle);
    const radius = this.facts.sun.radiusKm * place.depth / this.sunDistance;
    const seen = this.rays.parts.map((part, p) => Array.from({length: this.waves}, (_, w) => {
      const {paths, amounts} = this.followed(this.air, p, w);
      const through = this.rays.transmittance(this.air, p, w, amounts);
      const lands = paths.bending.map((bending, j) => landing(paths.impact[j], bending, this.sunDistance, place.depth));
      return {through, lands, cover: cloudCover(this.air, part), topKm: part.cloudTopKm};
    }));
    return Array.from({length: angles}, (_, i) => {
      const psi = 2 * Math.PI * i / angles, light = new Float64Array(rays * 3);
      const shares = this.rays.parts.map((_, p) => this.share(p, psi));
      seen.forEach((byWave, p) => {
        if (Math.abs(shares[p]) < 0.01) return;
        byWave.forEach(({through, lands, cover, topKm}, w) => {
          for (let j = 0; j < rays; ++j) {
            const out = ((x - lands[j] * Math.sin(psi)) ** 2 + (y - lands[j] * Math.cos(psi)) ** 2) / radius ** 2;
            if (out > 1) continue;
            const clear = this.rays.heights[j] <= topKm ? 1 - cover : 1;
            const mu = Math.sqrt(1 - out);
            let bright = 0;
            this.terms.forEach((term, t) => {
              bright += this.termBrightness[t][w] * term.reduceRight((value, c) => value * mu + c, 0);
            });
            for (let c = 0; c < 3; ++c)
              light[3 * j + c] += shares[p] * clear * through[j] * bright * this.meanWeights[c][w] / this.meanGreen;
          }
        });
      });
      return light;
    });
  }

  /** Share of one part in the limb at a position angle. */
  share(part, psi) {
    return this.summed(Float64Array.from(
      [...this.series[2 * part], ...(this.turning ? this.series[2 * part + 1] : [])]), psi, 1)[0];
  }
}

const summedUp = (weights, light) => weights.reduce((total, weight, w) => total + weight * light[w], 0);

function store(light, values, at, least) {
  for (let ground = 0; ground < channels; ground += colours) intoGamut(light.subarray(ground, ground + colours));
  for (let c = 0; c < channels; ++c) values[at + c] = Math.log2(Math.max(light[c], least[c]));
}

/** Moves a colour of linear Rec.709 with a negative channel towards the grey of its luminance, as colour::into_gamut
 * does; without luminance it becomes black. */
export function intoGamut(light) {
  const least = Math.min(light[0], light[1], light[2]);
  if (least >= 0) return;
  const grey = luminance(light);
  const share = grey > 0 ? -least / (grey - least) : 1;
  for (let c = 0; c < 3; ++c) light[c] = grey > 0 ? Math.max(0, light[c] + share * (grey - light[c])) : 0;
}
