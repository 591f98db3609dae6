// SPDX-License-Identifier: MIT
// Measures the whole Moon's magnitude and luminance, and the exposure for it.

import {viewFrom} from './motion.js';
import {luminance} from './vectors.js';

const samples = 96;  // width and height of the measured picture [pixels]
const whole = {middle: [0, 0], pixel: 2.04 / samples, width: samples, height: samples};

/** V magnitude and mean luminance [cd/m²] as seen from the Earth's centre, without the observer's air. */
export function brightness(picture, facts, sky, shadowed = true, table = 'above') {
  const view = viewFrom(sky, null, 'north');
  const pixels = picture.read(sky, view, whole, {shadowed, light: table});
  let radiance = 0, light = 0, count = 0;
  for (let i = 0; i < pixels.length; i += 4) {
    if (pixels[i + 1] > 0) ++count;
    radiance += pixels[i + 3];
    light += luminance(pixels, i);
  }
  const solidAngle = (whole.pixel * facts.moonRadiusKm / view.distance) ** 2;
  const V = facts.sun.V - 2.5 * Math.log10(radiance * solidAngle / facts.sun.VAt1au);
  return {V, luminance: count ? light / count : 0};
}

/** Exposure from 1 cd/m² in 1 s, relative to saturation. */
export const scaleOfOneSecond = (facts, {iso, fNumber}) => facts.exposureScale * iso / 100 / fNumber ** 2;

/**
 * Exposure time [s] that follows the eclipse, as with uses::ExposureTime::Rule::follow: in the air as it was, the cube
 * of the mean cube root of the brightest channels comes to a quarter of saturation, skylight included. Changes to the
 * air thus make the picture brighter or dimmer.
 */
export function followedTime(picture, facts, sky, view, exposure, around = [0, 0, 0]) {
  const pixels = picture.read(sky, view, whole, {light: 'followed'});
  let roots = 0, count = 0;
  for (let i = 0; i < pixels.length; i += 4) {
    const [r, g, b] = [0, 1, 2].map((k) => pixels[i + k]);
    if (Math.max(r, g, b) > 0)
      [roots, count] = [roots + Math.cbrt(Math.max(r + around[0], g + around[1], b + around[2])), count + 1];
  }
  if (count === 0) return 1;
  const time = 0.25 / (roots / count) ** 3 / scaleOfOneSecond(facts, exposure);
  return Math.min(1e5, Math.max(1e-6, time));
}
