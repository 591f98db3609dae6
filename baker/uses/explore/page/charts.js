// SPDX-License-Identifier: MIT
// Draws the charts beside the Moon: the light curve, the spectrum, and the ring of sunsets around the Earth.

import {darker, stopColours} from './picture.js';
import {signed} from './words.js';

/** Clears a canvas and scales it to the screen's pixels. Returns its pen and its size. */
function begun(canvas) {
  const ratio = Math.min(2, window.devicePixelRatio || 1);
  const width = canvas.clientWidth, height = canvas.clientHeight;
  canvas.width = Math.max(1, Math.round(width * ratio));
  canvas.height = Math.max(1, Math.round(height * ratio));
  const pen = canvas.getContext('2d');
  pen.scale(ratio, ratio);
  pen.font = '12px system-ui, sans-serif';
  pen.fillStyle = '#aaa';
  return {pen, width, height};
}

function line(pen, points) {
  pen.beginPath();
  points.forEach(([x, y], i) => (i ? pen.lineTo(x, y) : pen.moveTo(x, y)));
  pen.stroke();
}

/** Draws V magnitude against time, brighter towards the top, with the contacts and the current moment. */
export function drawCurve(canvas, curve, facts, nowMs) {
  const {pen, width, height} = begun(canvas);
  if (curve.length < 2) return;
  const brightest = -13, faintest = Math.max(-11, ...curve.map(({V}) => V)) + 0.5;
  const [from, to] = [curve[0].ms, curve[curve.length - 1].ms];
  const x = (ms) => width * (ms - from) / (to - from);
  const y = (V) => 6 + (height - 12) * (V - brightest) / (faintest - brightest);
  pen.strokeStyle = '#333';
  for (const {ms} of facts.contacts) line(pen, [[x(ms), 0], [x(ms), height]]);
  const step = faintest - brightest > 8 ? 4 : 2;
  for (let V = -12; V < faintest; V += step) {
    line(pen, [[0, y(V)], [width, y(V)]]);
    pen.fillText(`V ${signed(V, 0)}`, 4, y(V) + 12);
  }
  pen.strokeStyle = '#e8c070';
  pen.lineWidth = 2;
  line(pen, curve.map(({ms, V}) => [x(ms), y(Math.min(V, faintest))]));
  pen.strokeStyle = '#fff';
  pen.lineWidth = 1;
  line(pen, [[x(nowMs), 0], [x(nowMs), height]]);
}

/** Fills the legend for "stops below a full Moon". */
export function fillLegend(legend) {
  const steps = document.createElement('ol');
  stopColours.forEach((colour, i) => {
    const css = (factor) => `rgb(${colour.map((c) => Math.round(255 * c * factor)).join(' ')})`;
    const step = Object.assign(document.createElement('li'), {textContent: 2 * i});
    step.style.setProperty('--steps', `linear-gradient(90deg, ${css(1)} 50%, ${css(darker)} 50%)`);
    steps.append(step);
  });
  legend.replaceChildren('Stops below a full Moon', steps);
}

/** Approximate colour of a wavelength. */
function colourOf(nm) {
  const near = (middle, width) => Math.exp(-(((nm - middle) / width) ** 2));
  const red = near(610, 55) + 0.35 * near(430, 25) + (nm > 620 ? near(650, 90) * 0.7 : 0);
  const rgb = [red, near(545, 50), near(455, 35)].map((c) => Math.round(255 * Math.min(1, 0.15 + c)));
  return `rgb(${rgb.join(' ')})`;
}

/** Draws the ratio of light to full sunlight by wavelength, on a logarithmic scale. */
export function drawSpectrum(canvas, wavelengths, ratios) {
  const {pen, width, height} = begun(canvas);
  const top = Math.ceil(Math.log10(Math.max(1e-9, ...ratios)) + 0.01), decades = 4, floor = height - 16;
  const x = (nm) => width * (nm - 380) / 400;
  const y = (ratio) => 4 + (floor - 4) * Math.min(1, (top - Math.log10(Math.max(ratio, 1e-12))) / decades);
  pen.strokeStyle = '#333';
  for (let d = 0; d < decades; ++d) {
    line(pen, [[0, y(10 ** (top - d))], [width, y(10 ** (top - d))]]);
    pen.fillText(top - d === 0 ? 'full sunlight' : `10${superscript(top - d)}`, 4, y(10 ** (top - d)) + 12);
  }
  for (const nm of [400, 500, 600, 700]) pen.fillText(`${nm} nm`, x(nm) - 18, height - 3);
  pen.lineWidth = 3;
  for (let i = 0; i + 1 < wavelengths.length; ++i) {
    pen.strokeStyle = colourOf((wavelengths[i] + wavelengths[i + 1]) / 2);
    line(pen, [[x(wavelengths[i]), y(ratios[i])], [x(wavelengths[i + 1]), y(ratios[i + 1])]]);
  }
}

const superscript = (n) => String(n).replace('-', '⁻').replace(/\d/g, (d) => '⁰¹²³⁴⁵⁶⁷⁸⁹'[d]);

/** sRGB code of a linear value, 0 to 255. */
const code = (x) => Math.round(255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * Math.min(1, x) ** (1 / 2.4) - 0.055));

/** Level in the ring that is drawn as white: the 99th percentile of red. */
function whiteOf(ring) {
  const levels = ring.flatMap((row) => [...row].filter((_, i) => i % 3 === 0)).filter((x) => x > 0);
  levels.sort((a, b) => a - b);
  return levels.length ? levels[Math.floor(levels.length * 0.99)] : 1;
}

/**
 * Draws the Earth as seen from the Moon: a black disc in forty kilometres of air, drawn eighty times as thick.
 *
 * Given  ring  Shadow.ring;  heights  of its rays [km]
 */
export function drawRing(canvas, ring, heights) {
  const size = 240, pen = canvas.getContext('2d');
  canvas.width = canvas.height = size;
  const image = pen.createImageData(size, size), white = whiteOf(ring);
  const inner = 0.66, outer = 0.98, topKm = 40;
  for (let row = 0; row < size; ++row)
    for (let column = 0; column < size; ++column) {
      const x = (column + 0.5) / size * 2 - 1, y = 1 - (row + 0.5) / size * 2, at = 4 * (row * size + column);
      image.data[at + 3] = 255;
      const height = (Math.hypot(x, y) - inner) / (outer - inner) * topKm;
      if (height < 0 || height > topKm) continue;
      const turn = (Math.atan2(x, y) / (2 * Math.PI) + 1) % 1;
      const rays = ring[Math.floor(turn * ring.length) % ring.length];
      const j = Math.max(0, heights.findLastIndex((h) => h <= height));
      for (let c = 0; c < 3; ++c) image.data[at + c] = code(Math.max(0, rays[3 * j + c]) / white);
    }
  pen.putImageData(image, 0, 0);
  pen.strokeStyle = '#444';
  pen.beginPath();
  pen.arc(size / 2, size / 2, inner * size / 2, 0, 2 * Math.PI);
  pen.stroke();
}
