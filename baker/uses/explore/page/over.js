// SPDX-License-Identifier: MIT
// Draws lines and labels over the Moon: the shadow's edges, the marked place, and arrows to north and east.

import {groundOf, pictureOf} from './motion.js';
import {difference, dot, times} from './vectors.js';

/** Radii of umbra and penumbra at the Moon's distance, for an Earth without air [km]. */
export function edges(facts, sky) {
  const depth = sky.centre[2], {equatorialKm} = facts.earth, {radiusKm} = facts.sun;
  const sun = radiusKm * depth / sky.sunDistance, earth = equatorialKm * (1 + depth / sky.sunDistance);
  return {umbra: earth - sun, penumbra: earth + sun};
}

/** Position in the picture [lunar radii] of a point in the plane across the shadow's axis at the Moon's centre. */
function seenAt(facts, sky, view, east, north) {
  const point = difference([east, north, sky.centre[2]], view.position);
  const scale = view.distance / dot(point, view.forward) / facts.moonRadiusKm;
  return [dot(point, view.right) * scale, dot(point, view.up) * scale];
}

export function drawOver(canvas, {facts, sky, view, frame, circle, marked}) {
  const pen = canvas.getContext('2d');
  Object.assign(canvas, {width: frame.width, height: frame.height});
  const pixel = ([x, y]) => [
    frame.width / 2 + (x - frame.middle[0]) / frame.pixel, frame.height / 2 - (y - frame.middle[1]) / frame.pixel];
  pen.lineWidth = frame.ratio;
  pen.font = `${12 * frame.ratio}px system-ui, sans-serif`;
  if (circle)
    for (const [name, radius] of Object.entries(edges(facts, sky))) {
      pen.strokeStyle = pen.fillStyle = name === 'umbra' ? '#c96a3a' : '#888';
      pen.beginPath();
      for (let i = 0; i <= 180; ++i) {
        const turn = Math.PI * i / 90;
        pen.lineTo(...pixel(seenAt(facts, sky, view, radius * Math.sin(turn), radius * Math.cos(turn))));
      }
      pen.stroke();
    }
  drawNorth(pen, {sky, view, frame});
  const place = marked && pictureOf(view, facts.moonRadiusKm, groundOf(sky, marked));
  if (!place) return;
  pen.strokeStyle = '#fff';
  pen.beginPath();
  pen.arc(...pixel(place), 5 * frame.ratio, 0, 2 * Math.PI);
  pen.stroke();
}

/** Draws arrows to celestial north and east. */
function drawNorth(pen, {sky, view, frame}) {
  const pole = times(sky.equatorFrame, [0, 0, 1]);
  const north = [dot(pole, view.right), dot(pole, view.up)], size = Math.hypot(...north) || 1;
  const [x, y] = [north[0] / size, north[1] / size], reach = 16 * frame.ratio;
  const narrow = frame.width < 640 * frame.ratio;  // on narrow screens the title is at the top
  const from = narrow ? [40 * frame.ratio, frame.height - 34 * frame.ratio] : [frame.width - 34 * frame.ratio, 40 * frame.ratio];
  pen.strokeStyle = pen.fillStyle = '#888';
  pen.textAlign = 'center';
  pen.textBaseline = 'middle';
  for (const [name, dx, dy] of [['N', x, y], ['E', -y, x]]) {  // in the sky, east is to the left of north
    pen.beginPath();
    pen.moveTo(...from);
    pen.lineTo(from[0] + reach * dx, from[1] - reach * dy);
    pen.stroke();
    pen.fillText(name, from[0] + 1.6 * reach * dx, from[1] - 1.6 * reach * dy);
  }
}
