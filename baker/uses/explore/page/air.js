// SPDX-License-Identifier: MIT
// What the reader does to the Earth's air, and what then stands along each ray of the limb.

/** The air as it was. */
export const airAsItWas = {
  refraction: true, scattering: true, ozone: true, gases: true, aerosol: true, clouds: true,
  cloud: 1,  // factor on the chance of cloud and on cirrus
  haze: 1,  // factor on the aerosol below the stratosphere
  dust: null,  // optical depth of the stratosphere's aerosol at 550 nm; null: as it was
  ozoneDu: null,  // column of ozone everywhere; null: as it was
  clearness: 0,  // 1: no cloud, no aerosol; below 0: as much is added to the stratosphere's depth
};

/** The same air, its clearness in cloud, haze and dust: what sliders show. The dust is even then. */
export function withoutClearness(air, meanDepth) {
  if (air.clearness === 0) return air;
  const left = 1 - Math.max(0, air.clearness);
  return {...air, cloud: air.cloud * left, haze: air.haze * left,
    dust: Math.min(2, aerosolDepth({...air, aerosol: true}, {aerosolDepth: meanDepth})), clearness: 0};
}

/** Optical depth of the stratosphere's aerosol over one part of the limb. */
export function aerosolDepth(air, part) {
  if (!air.aerosol) return 0;
  const asIs = air.dust ?? part.aerosolDepth;
  return asIs * (1 - Math.max(0, air.clearness)) - Math.min(0, air.clearness);
}

/** Factors on what each absorber has in one part of the limb; the stratosphere's aerosol apart. */
export function factors(air, part, absorbers) {
  const left = 1 - Math.max(0, air.clearness);
  const on = (term) => (term ? 1 : 0);
  const aerosol = on(air.aerosol) * left;
  const all = {
    air: on(air.scattering),
    ozone: on(air.ozone) * (air.ozoneDu === null || !part.ozoneDu ? 1 : air.ozoneDu / part.ozoneDu),
    dust: on(air.aerosol),
    troposphere: aerosol * air.haze,
    freeTroposphere: aerosol * air.haze,
    stratosphere: 0,
    cloud: on(air.clouds) * air.cloud * left,
    cirrus: on(air.clouds) * air.cloud * left,
    oxygenPairs: on(air.gases),
    nitrogenDioxide: on(air.gases),
  };
  return absorbers.map((name) => all[name]);
}

/** Part of the limb under a deck of cloud. */
export const cloudCover = (air, part) =>
  air.clouds ? Math.min(1, part.cloudCover * air.cloud * (1 - Math.max(0, air.clearness))) : 0;

/** Rays of the limb by wavelength, and how much of their light the air lets through. */
export class LimbRays {
  constructor(facts, arrays) {
    this.limb = facts.limb;
    this.parts = facts.limb.parts;
    this.waves = facts.wavelengths.length;
    this.heights = arrays['limb.heights'].data;
    this.rays = this.heights.length;
    this.refractivities = arrays['limb.bending'].shape[1];  // the last is that of straight rays
    for (const name of ['bending', 'excess', 'amounts', 'spectra', 'aerosol', 'aerosolSpectra', 'blend'])
      this[name] = arrays[`limb.${name}`].data;
    this.absorbers = facts.limb.absorbers.length;
  }

  /** Weights of the refractivities that make a wavelength's ray. */
  shares(air, wave) {
    const bent = this.refractivities - 1;
    if (!air.refraction) return [...Array(bent).fill(0), 1];
    return [...this.blend.subarray(wave * bent, (wave + 1) * bent), 0];
  }

  /** Bending [rad] and impact parameter [km] of the rays of one wavelength over one part. */
  paths(air, part, wave) {
    const shares = this.shares(air, wave);
    const bending = new Float64Array(this.rays), impact = new Float64Array(this.rays);
    const refractivity = air.refraction ? this.limb.refractivities[wave] : 0;
    for (let j = 0; j < this.rays; ++j) {
      for (let k = 0; k < shares.length; ++k)
        bending[j] += shares[k] * this.bending[(part * this.refractivities + k) * this.rays + j];
      impact[j] = this.parts[part].radiusKm + this.heights[j] + refractivity * this.excess[part * this.rays + j];
    }
    return {bending, impact};
  }

  /** Amounts of the absorbers along the same rays: [ray][absorber]. */
  amountsOf(air, part, wave) {
    const shares = this.shares(air, wave);
    const amounts = new Float64Array(this.rays * this.absorbers);
    const size = amounts.length;
    for (let k = 0; k < shares.length; ++k) {
      if (shares[k] === 0) continue;
      const from = (part * this.refractivities + k) * size;
      for (let i = 0; i < size; ++i) amounts[i] += shares[k] * this.amounts[from + i];
    }
    return amounts;
  }

  /** Optical depth of the stratosphere's aerosol along a ray: between steps, in logarithms. */
  aerosolAlong(part, wave, ray, depth) {
    if (depth <= 0) return 0;
    const steps = this.limb.aerosolSteps;
    const along = (s) => this.aerosol[(part * steps.length + s) * this.rays + ray] *
      this.aerosolSpectra[s * this.waves + wave];
    if (depth <= steps[0]) return along(0) * depth / steps[0];
    const s = Math.min(steps.findLastIndex((step) => step <= depth), steps.length - 2);
    const between = Math.log(depth / steps[s]) / Math.log(steps[s + 1] / steps[s]);
    const low = along(s), high = along(s + 1);
    return low > 0 && high > 0 ? low * (high / low) ** between : 0;
  }

  /** Transmittance of each ray. */
  transmittance(air, part, wave, amounts) {
    const kind = this.parts[part];
    const depth = aerosolDepth(air, kind);
    const asItWas = depth > 0 && depth === kind.aerosolDepth;
    const weights = factors(air, kind, this.limb.absorbers);
    if (asItWas) weights[this.limb.absorbers.indexOf('stratosphere')] = 1;
    const from = (part * this.waves + wave) * this.absorbers;
    for (let a = 0; a < this.absorbers; ++a) weights[a] *= this.spectra[from + a];
    const through = new Float64Array(this.rays);
    for (let j = 0; j < this.rays; ++j) {
      let optical = asItWas ? 0 : this.aerosolAlong(part, wave, j, depth);
      for (let a = 0; a < this.absorbers; ++a) optical += weights[a] * amounts[j * this.absorbers + a];
      through[j] = Math.exp(-optical);
    }
    return through;
  }
}
