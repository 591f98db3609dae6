// SPDX-License-Identifier: MIT
// Computes where light from the Earth's limb lands on a plane behind the Earth, and how much light the plane receives
// from the Sun's whole disc (shadow::by_quadrature has the equation).

// Numbers of nodes in three stretches of axis distance: the umbra, the edge where direct light begins, and farther out.
export const stretches = [150, 110, 80];
export const nodes = stretches[0] + stretches[1] + stretches[2] + 1, sectors = 96;
export const colours = 4;  // number of colours: red, green, blue and V
export const channels = 2 * colours;  // all colours on the reddest ground, then all on the bluest
// Widths of bins of axis distance, which collect light from the Sun's centre. Narrow bins begin where rays at a height
// of 25 km land and direct sunlight begins: highRaysKm nearer to the axis than an unbent ray at sea level lands.
const wideKm = 30, narrowKm = 5, highRaysKm = 360;
const limbKm = 6390, oneLimbKm = 1500;  // same values as shadow::limb_m and one_limb_m

/** Axis distance at which a line from the limb crosses a plane that is `deeper` times as deep. */
export const sheared = (distance, deeper) =>
  distance + (distance - limbKm) * (deeper - 1) * Math.min(1, distance / oneLimbKm);

/** Signed axis distance at which a ray from the Sun's centre lands, as shadow::landing_m. */
export function landing(impact, bending, sunDistance, depth) {
  const slope = Math.tan(Math.asin(impact / sunDistance) - bending);
  return impact * Math.sqrt(1 + slope * slope) + depth * slope;
}

/** Area common to two circles. */
function lensArea(apart, r, s) {
  if (apart >= r + s) return 0;
  if (apart <= Math.abs(r - s)) return Math.PI * Math.min(r, s) ** 2;
  const within = (x) => Math.min(1, Math.max(-1, x));
  const segment = (c) => Math.acos(c) - c * Math.sqrt(1 - c * c);
  return r * r * segment(within((apart * apart + r * r - s * s) / (2 * apart * r))) +
    s * s * segment(within((apart * apart + s * s - r * r) / (2 * apart * s)));
}

const gauss = [
  [-0.9602898564975363, 0.1012285362903763], [-0.7966664774136267, 0.2223810344533745],
  [-0.5255324099163290, 0.3137066458778873], [-0.1834346424956498, 0.3626837833783620],
  [0.1834346424956498, 0.3626837833783620], [0.5255324099163290, 0.3137066458778873],
  [0.7966664774136267, 0.2223810344533745], [0.9602898564975363, 0.1012285362903763]];

export class Plane {
  constructor(shadow, depth) {
    this.shadow = shadow;
    this.depth = depth;
    this.sunRadius = shadow.facts.sun.radiusKm * depth / shadow.sunDistance;
    this.factor = (1 + depth / shadow.sunDistance) ** 2 / (Math.PI * this.sunRadius ** 2);
    const straight = landing(shadow.facts.earth.equatorialKm, 0, shadow.sunDistance, depth);
    const top = landing(shadow.facts.earth.equatorialKm + shadow.facts.limb.topKm, 0, shadow.sunDistance, depth);
    this.wide = Math.floor((straight - highRaysKm) / wideKm);  // number of wide bins
    this.bins = this.wide + Math.ceil((top + narrowKm - this.wide * wideKm) / narrowKm);
    this.clear = null;  // visible parts of the Sun's disc at each node, computed when first needed
  }

  /** Axis distance at which a bin begins [km]. */
  edge(bin) { return bin < this.wide ? bin * wideKm : this.wide * wideKm + (bin - this.wide) * narrowKm; }
  /** Bin that contains an axis distance [km]. */
  binOf(distance) {
    const beyond = distance - this.wide * wideKm;
    return Math.floor((beyond < 0 ? distance / wideKm : this.wide + beyond / narrowKm) + 1e-9);
  }

  /** Axis distance of a node in this plane [km]. */
  at(node) { return sheared(this.shadow.distanceOf(node), this.depth / this.shadow.middleDepth); }

  /** ∫ f(μ) cos mψ dψ over the arc of radius r, added to arcs[term × harmonics + m]. */
  addArc(gamma, r, weight, arcs) {
    const a = this.sunRadius, {terms, harmonics} = this.shadow;
    if (Math.abs(r - gamma) >= a) return;
    const half = r + gamma <= a ? Math.PI
      : Math.acos(Math.max(-1, Math.min(1, (gamma * gamma + r * r - a * a) / (2 * gamma * r))));
    const pieces = Math.max(1, Math.ceil(half * harmonics / 9));
    for (let piece = 0; piece < pieces; ++piece)
      for (const [x, w] of gauss) {
        const t = Math.PI / 2 * (piece + (1 + x) / 2) / pieces;
        const psi = half * Math.sin(t), cosine = Math.cos(psi);
        const out = (r * r + gamma * gamma - 2 * r * gamma * cosine) / (a * a);
        const mu = Math.sqrt(Math.max(0, 1 - out));
        const share = weight * half * w * Math.PI / 2 / pieces * Math.cos(t);  // covers both halves of the arc
        for (let k = 0; k < terms.length; ++k) {
          const shed = share * terms[k].reduceRight((value, c) => value * mu + c, 0);
          let before = cosine, now = 1;
          for (let m = 0; m < harmonics; ++m) {
            arcs[k * harmonics + m] += shed * now;
            [before, now] = [now, 2 * cosine * now - before];
          }
        }
      }
  }

  /** Arcs of the Sun's disc around an axis distance: {first bin, last bin, values[bin][term × harmonics + m]}. */
  arcs(gamma) {
    const first = Math.min(this.bins, this.binOf(Math.max(0, gamma - this.sunRadius)));
    const last = Math.min(this.bins, this.binOf(gamma + this.sunRadius) + 1);
    const size = this.shadow.terms.length * this.shadow.harmonics;
    const values = new Float32Array((last - first) * size);
    const one = new Float64Array(size);
    for (let bin = first; bin < last; ++bin) {
      one.fill(0);
      const from = this.edge(bin), width = this.edge(bin + 1) - from;
      for (const place of [0.2113248654, 0.7886751346]) this.addArc(gamma, from + place * width, 0.5, one);
      values.set(one, (bin - first) * size);
    }
    return {first, last, values};
  }

  /** Arcs around every node. */
  allArcs() {
    this.kept ??= Array.from({length: nodes}, (_, i) => this.arcs(this.at(i)));
    return this.kept;
  }

  /** ∫ T b db for one part and wavelength, by the bin where light lands; the array's second half is beyond the axis. */
  landed(paths, through, cover, topKm) {
    const landed = new Float64Array(2 * this.bins);
    const {bending, impact} = paths;
    const heights = this.shadow.rays.heights;
    let from = landing(impact[0], bending[0], this.shadow.sunDistance, this.depth);
    for (let j = 0; j + 1 < impact.length; ++j) {
      const to = landing(impact[j + 1], bending[j + 1], this.shadow.sunDistance, this.depth);
      const a = through[j] * impact[j], b = through[j + 1] * impact[j + 1];
      const mean = a > 0 && b > 0 && Math.abs(a / b - 1) > 1e-4 ? (a - b) / Math.log(a / b) : (a + b) / 2;
      const clear = heights[j + 1] <= topKm + 1e-6 ? 1 - cover : 1;
      this.spread(landed, from, to, mean * clear * (impact[j + 1] - impact[j]));
      from = to;
    }
    return landed;
  }

  /** Spreads light evenly between two signed distances. */
  spread(landed, from, to, light) {
    const low = Math.min(from, to), high = Math.max(from, to, low + 1e-6), each = light / (high - low);
    if (high > 0) this.spreadOn(landed, 0, Math.max(0, low), high, each);
    if (low < 0) this.spreadOn(landed, this.bins, Math.max(0, -high), -low, each);
  }

  /** Spreads light on one side of the axis; `each` is the light per kilometre. */
  spreadOn(landed, offset, low, high, each) {
    for (let bin = this.binOf(low), from = low; bin < this.bins && from < high; ++bin) {
      const next = Math.min(high, this.edge(bin + 1));
      landed[offset + bin] += each * (next - from);
      from = next;
    }
  }

  /** For each layer of the Sun's disc, the share that the Earth and its air leave uncovered. */
  clearParts(gamma, angle) {
    const {facts, layers} = this.shadow;
    const {equatorialKm, polarKm, sunDeclination} = facts.earth;
    const tipped = Math.hypot(equatorialKm * Math.sin(sunDeclination), polarKm * Math.cos(sunDeclination));
    const radius = 1 / Math.hypot(Math.sin(angle) / equatorialKm, Math.cos(angle) / tipped);
    const earth = landing(radius + facts.limb.topKm, 0, this.shadow.sunDistance, this.depth);
    const sun = this.sunRadius;
    return layers.map((layer) =>
      Math.max(0, layer * layer - lensArea(gamma, sun * layer, earth) / (Math.PI * sun * sun)));
  }

  /** Direct light for given weights of the Sun's layers: [sector][node][channel]. */
  direct(layerWeights) {
    this.clear ??= Array.from({length: sectors * nodes}, (_, i) =>
      this.clearParts(this.at(i % nodes), 2 * Math.PI * Math.floor(i / nodes) / sectors));
    const light = new Float64Array(sectors * nodes * channels);
    this.clear.forEach((parts, i) => {
      if (parts[0] < 1e-12) return;
      for (let c = 0; c < channels; ++c)
        for (let l = 0; l < parts.length; ++l) light[i * channels + c] += layerWeights[c][l] * parts[l];
    });
    return light;
  }
}
