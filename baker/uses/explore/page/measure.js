// SPDX-License-Identifier: MIT
// The whole Moon in numbers: exposure, magnitude, luminance.

import {viewFrom} from './motion.js';

const samples = 96;  // across the picture that is summed up
const whole = {middle: [0, 0], pixel: 2.04 / samples, width: samples, height: samples};

const luminance = (p, i) => 0.2126390059 * p[i] + 0.7151686788 * p[i + 1] + 0.0721923154 * p[i + 2];

/** V magnitude as from the Earth's centre, above the air, and mean luminance [cd/m²]. */
export function brightness(picture, facts, sky, shadowed = true) {
  const view = viewFrom(sky, null, 'north');
  const pixels = picture.read(sky, view, whole, {shadowed});
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

/** Exposure of 1 s: saturation is 1, for 1 cd/m². */
export const scaleOfOneSecond = (facts, {iso, fNumber}) => facts.exposureScale * iso / 100 / fNumber ** 2;

/** The time [s] that follows the eclipse in the air as it was: the cube of the cube roots' mean comes to a
 * quarter of saturation, as uses::ExposureTime::Rule::follow. So another air is seen brighter or dimmer. */
export function followedTime(picture, facts, sky, view, exposure) {
  const pixels = picture.read(sky, view, whole, {light: 'asItWas'});
  let roots = 0, count = 0;
  for (let i = 0; i < pixels.length; i += 4) {
    const y = luminance(pixels, i);
    if (y > 0) [roots, count] = [roots + Math.cbrt(y), count + 1];
  }
  if (count === 0) return 1;
  const time = 0.25 / (roots / count) ** 3 / scaleOfOneSecond(facts, exposure);
  return Math.min(1e5, Math.max(1e-6, time));
}
