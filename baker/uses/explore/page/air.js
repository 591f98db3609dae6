// SPDX-License-Identifier: MIT
// Applies the user's changes to the Earth's air, and computes the transmittance along rays at the limb.

/** The air on the day of the eclipse, without changes. */
export const airAsItWas = {
  refraction: true, scattering: true, ozone: true, gases: true, aerosol: true, clouds: true,
  cloud: 1,  // multiplies the chance of cloud and the amount of cirrus
  haze: 1,  // multiplies the aerosol below the stratosphere
  dust: null,  // optical depth of stratospheric aerosol at 550 nm; null keeps that of the day
  ozoneDu: null,  // ozone column, the same everywhere [Dobson units]; null keeps that of the day
  clearness: 0,  // fraction of cloud and aerosol removed; if negative, optical depth added to the stratosphere
};

/** Share of cloud and aerosol that the clearness leaves. */
export const remaining = (air) => 1 - Math.max(0, air.clearness);

/** Mean of a value over the parts of the limb. */
export const meanOver = (parts, value) => parts.reduce((total, part) => total + value(part), 0) / parts.length;

/** The air with its clearness converted to cloud, haze and uniform dust, which the sliders can show. */
export function withoutClearness(air, meanDepth) {
  if (air.clearness === 0) return air;
  return {...air, cloud: air.cloud * remaining(air), haze: air.haze * remaining(air),
    dust: Math.min(2, aerosolDepth({...air, aerosol: true}, {aerosolDepth: meanDepth})), clearness: 0};
}

/** Optical depth of the stratospheric aerosol over one part of the limb. */
export function aerosolDepth(air, part) {
  if (!air.aerosol) return 0;
  const asIs = air.dust ?? part.aerosolDepth;
  return asIs * remaining(air) - Math.min(0, air.clearness);
}

/** Factors for the absorbers' amounts in one part of the limb, by group. The stratosphere has 0: see aerosolAlong. */
export function factors(air, part, groups) {
  const on = (term) => (term ? 1 : 0);
  const all = {
    air: on(air.scattering),
    ozone: on(air.ozone) * (air.ozoneDu === null || !part.ozoneDu ? 1 : air.ozoneDu / part.ozoneDu),
    dust: on(air.aerosol),
    aerosol: on(air.aerosol) * remaining(air) * air.haze,
    stratosphere: 0,
    cloud: on(air.clouds) * remaining(air) * air.cloud,
    gas: on(air.gases),
  };
  return groups.map((group) => all[group]);
}

/** Share of a part of the limb that lies under a cloud deck. */
export const cloudCover = (air, part) =>
  air.clouds ? Math.min(1, part.cloudCover * air.cloud * remaining(air)) : 0;

/** Paths and transmittances of the limb's rays, by wavelength. */
export class LimbRays {
  constructor(facts, arrays) {
    this.limb = facts.limb;
    this.parts = facts.limb.parts;
    this.waves = facts.wavelengths.length;
    this.heights = arrays['limb.heights'].data;
    this.rays = this.heights.length;
    this.refractivities = arrays['limb.bending'].shape[1];  // number of refractivities, the last of which is 0
    for (const name of ['bending', 'excess', 'amounts', 'spectra', 'aerosol', 'aerosolSpectra', 'recordedSpectra', 'blend'])
      this[name] = arrays[`limb.${name}`].data;
    this.absorbers = facts.limb.absorbers.length;
  }

  /** Weights with which the refractivities are blended into the ray at a wavelength. */
  shares(air, wave) {
    const bent = this.refractivities - 1;
    if (!air.refraction) return [...Array(bent).fill(0), 1];
    return [...this.blend.subarray(wave * bent, (wave + 1) * bent), 0];
  }

  /** Bending [rad] and impact parameter [km] of a part's rays at one wavelength. */
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

  /** Amounts of the absorbers along a part's rays at one wavelength: [ray][absorber]. */
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

  /** Value at an optical depth of aerosol, interpolated between steps in logarithms. */
  betweenSteps(depth, at) {
    const steps = this.limb.aerosolSteps;
    const s = Math.max(0, Math.min(steps.findLastIndex((step) => step <= depth), steps.length - 2));
    const between = Math.log(depth / steps[s]) / Math.log(steps[s + 1] / steps[s]);
    const low = at(s), high = at(s + 1);
    return low > 0 && high > 0 ? low * (high / low) ** between : 0;
  }

  /** Optical depth of stratospheric aerosol along a ray. */
  aerosolAlong(part, wave, ray, depth) {
    if (depth <= 0) return 0;
    const steps = this.limb.aerosolSteps;
    const along = (s) => this.aerosol[(part * steps.length + s) * this.rays + ray] *
      this.aerosolSpectra[s * this.waves + wave];
    return depth <= steps[0] ? along(0) * depth / steps[0] : this.betweenSteps(depth, along);
  }

  /** Spectrum of the aerosol recorded in the month, for another optical depth. */
  recordedSpectrum(part, wave, depth) {
    const steps = this.limb.aerosolSteps;
    return this.betweenSteps(Math.max(depth, steps[0]),
      (s) => this.recordedSpectra[(part * steps.length + s) * this.waves + wave]);
  }

  /** Transmittance of each ray. */
  transmittance(air, part, wave, amounts) {
    const kind = this.parts[part];
    const depth = aerosolDepth(air, kind);
    const asItWas = depth > 0 && depth === kind.aerosolDepth;
    // steps on Danjon's scale multiply the recorded aerosol, as coppermoon does; the dust slider has a standard profile
    const scaled = !asItWas && depth > 0 && air.dust === null && kind.aerosolRecorded && kind.aerosolDepth > 0;
    const weights = factors(air, kind, this.limb.absorbers), stratosphere = this.limb.absorbers.indexOf('stratosphere');
    if (asItWas) weights[stratosphere] = 1;
    const from = (part * this.waves + wave) * this.absorbers;
    for (let a = 0; a < this.absorbers; ++a) weights[a] *= this.spectra[from + a];
    if (scaled) weights[stratosphere] = depth / kind.aerosolDepth * this.recordedSpectrum(part, wave, depth);
    const through = new Float64Array(this.rays);
    for (let j = 0; j < this.rays; ++j) {
      let optical = asItWas || scaled ? 0 : this.aerosolAlong(part, wave, j, depth);
      for (let a = 0; a < this.absorbers; ++a) optical += weights[a] * amounts[j * this.absorbers + a];
      through[j] = Math.exp(-optical);
    }
    return through;
  }
}
