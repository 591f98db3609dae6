// SPDX-License-Identifier: MIT
// Interpolates the light of the clear sky around the Moon, which was computed by uses::ClearSky.

import {pressureRatio} from './sightline.js';

/** The node below a value among equally spaced nodes, and how far the value is towards the next (0 to 1). */
function between(value, [first, step], nodes) {
  const at = Math.min(Math.max((value - first) / step, 0), nodes - 1), node = Math.min(Math.floor(at), nodes - 2);
  return [node, at - node];
}

/** Three numbers from a table, interpolated along its other axes. */
function interpolated({shape, data}, [[node, part], ...others], axis = 0, row = 0) {
  const [low, high] = [node, node + 1].map((i) => {
    const at = row * shape[axis] + i;
    return others.length ? interpolated({shape, data}, others, axis + 1, at) : data.subarray(3 * at, 3 * at + 3);
  });
  return [0, 1, 2].map((c) => low[c] + part * (high[c] - low[c]));
}

/**
 * Light from the sky around the Moon [cd/m², linear Rec.709].
 *
 * Given  view         view from a place (viewFrom)
 *        elevationKm  elevation of the place
 *        moonV        magnitude of the whole Moon above the air
 */
export function skyAround({sky}, arrays, view, elevationKm, moonV) {
  const [sea, high] = sky.elevations.map(pressureRatio);
  const height = [0, (pressureRatio(elevationKm) - sea) / (high - sea)];
  const of = (name, values) => interpolated(arrays[`sky.${name}`], [height,
    ...values.map(([value, nodes], i) => between(value, nodes, arrays[`sky.${name}`].shape[i + 1]))]);
  const up = [[Math.sqrt(Math.max(0, view.trueAltitude)), sky.up]], {sunAltitude} = view;
  const dark = sunAltitude < sky.sun[0] ? of('airglow', up)
    : of('dark', [[sunAltitude, sky.sun], [view.trueAltitude + sunAltitude, sky.beside]]);
  const moonlit = of('moonlit', up), moon = 10 ** (-0.4 * (moonV - sky.moonV));
  return dark.map((log, c) => 2 ** log + moon * 2 ** moonlit[c]);
}
