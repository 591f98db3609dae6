// SPDX-License-Identifier: MIT
// The page for one eclipse. It holds the state and updates everything that shows the state.

import {airAsItWas} from './air.js';
import {rowsOf} from './arrays.js';
import {drawCurve, drawRing, drawSpectrum, fillLegend} from './charts.js';
import {brightness, followedTime, scaleOfOneSecond} from './measure.js';
import {groundAt, groundOf, Motion, pictureOf, placeInShadow, selenographic, viewFrom} from './motion.js';
import {drawOver} from './over.js';
import {Panel, Places} from './panel.js';
import {Picture} from './picture.js';
import {Shadow} from './shadow.js';
import {Sightline} from './sightline.js';
import {skyAround} from './sky.js';
import {commandOf, linkOf, stateOf} from './state.js';
import {direction, degree, luminance, unit} from './vectors.js';
import {exposureTime, localTime, meanings, number, placeText, signed, utc} from './words.js';

const curveMoments = 72;
const playedRate = 600;  // seconds of the eclipse that pass in each second of playback

export class Page {
  /** Given  embedded  whether it is part of another page, whose address and keys it leaves alone */
  constructor(root, facts, arrays, embedded = false) {
    Object.assign(this, {root, facts, arrays, embedded});
    this.find = (name) => root.querySelector(`.${name}`);
    this.state = stateOf(location.hash.slice(1), facts);
    this.motion = new Motion(facts);
    this.features = rowsOf(arrays.features.data).map(([name, latitude, longitude, km]) => (
      {name, latitude: Number(latitude), longitude: Number(longitude), km: Number(km)}));
    const greatest = this.motion.at(facts.contacts.find(({name}) => name === 'greatest').ms);
    this.shadow = new Shadow(facts, arrays, greatest.sunDistance, this.motion.depths());
    this.picture = new Picture(this.find('moon'), facts, arrays);
    this.panel = new Panel(root, facts, new Places(arrays.cities.data), this.state, (what) => this.changed(what));
    this.find('eclipse').querySelector('h1').textContent = facts.title;
    this.setAir(airAsItWas);
    const {air, landed} = this.shadow;
    this.sightline = new Sightline(arrays, (through) => this.shadow.inAir({air, landed}, () => this.shadow.table(through)));
    this.asItWas = {above: this.above, sightline: this.sightline};
    this.airIsOld = JSON.stringify(this.state.air) !== JSON.stringify(airAsItWas);
    const unshadowed = brightness(this.picture, facts, greatest, false);
    this.fullMoon = unshadowed.luminance;
    this.listen();
    this.makeMarks();
    fillLegend(this.find('legend'));
    this.draw();
  }

  /** Shows a change to the state: 'view', 'look' or 'air'. */
  changed(what) {
    if (what === 'air') this.airIsOld = true;
    this.redraw();
  }

  /** Draws in the screen's next frame. */
  redraw() {
    if (this.waiting) return;
    this.waiting = requestAnimationFrame(() => { this.waiting = 0; this.draw(); });
  }

  setAir(air) {
    this.shadow.setAir(air);
    this.above = this.shadow.table();
    this.picture.setLight('above', this.above, this.shadow);
    const asItWas = JSON.stringify(air) === JSON.stringify(airAsItWas) && this.asItWas;
    this.sightline = asItWas ? asItWas.sightline : new Sightline(this.arrays, (through) => this.shadow.table(through));
    this.sightline.shown = null;
    this.airIsOld = false;
    this.curve = null;
  }

  /** Sets the light that the observer sees, and the light in unchanged air, which the exposure follows. */
  setSeen({trueAltitude}) {
    const {place, reddening, exposure} = this.state, key = [trueAltitude, place?.elevationKm, exposure.rule].join();
    const through = (sightline) => sightline.table(trueAltitude, place.elevationKm ?? 0);
    if (!place || !reddening) {
      this.picture.setLight('seen', this.above, this.shadow);
      this.picture.setLight('followed', this.asItWas.above, this.shadow);
    } else if (this.sightline.shown !== key) {
      this.picture.setLight('seen', through(this.sightline), this.shadow);
      if (exposure.rule === 'follow') this.picture.setLight('followed', through(this.asItWas.sightline), this.shadow);
    }
    this.sightline.shown = place && reddening ? key : null;
  }

  /** The picture's frame. At zoom 1 it shows the whole Moon with a margin. */
  frame() {
    const {canvas} = this.picture, ratio = Math.min(2, window.devicePixelRatio || 1);
    const width = Math.max(1, Math.round(canvas.clientWidth * ratio));
    const height = Math.max(1, Math.round(canvas.clientHeight * ratio));
    canvas.style.touchAction = this.state.zoom > 1 ? 'none' : 'pan-y';  // fingers drag an enlarged Moon
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, {width, height});
    const pixel = 2.3 / this.state.zoom / Math.min(width, height);
    return {middle: this.state.middle, pixel, width, height, ratio};
  }

  /** Sky, view and frame for the current moment. */
  scene() {
    const sky = this.motion.at(this.state.ms);
    return {sky, view: viewFrom(sky, this.state.place, this.state.up), frame: this.frame()};
  }

  /** Whether the observer's air shines around the Moon. It does not if the Moon has set or that air is switched off. */
  skyIsSeen(view) { return this.state.place && this.state.reddening && view.altitude >= -0.3; }

  /** Draws the Moon at once, and the slower drawings when changes pause. */
  draw() {
    if (this.picture.gl.isContextLost()) return;
    if (this.airIsOld) this.setAir(this.state.air);
    this.placeMarks();
    const {state, facts, picture} = this, scene = this.scene(), {sky, view, frame} = scene;
    this.setSeen(view);
    this.whole = brightness(picture, facts, sky);
    const around = ({V}) => (this.skyIsSeen(view)
      ? skyAround(facts, this.arrays, view, state.place.elevationKm ?? 0, V) : [0, 0, 0]);
    this.around = around(this.whole);
    picture.setLight('asItWas', this.asItWas.above, this.shadow);
    this.seconds = state.exposure.rule === 'fixed' ? state.exposure.time
      : followedTime(picture, facts, sky, view, state.exposure, around(brightness(picture, facts, sky, true, 'asItWas')));
    const exposure = this.seconds * scaleOfOneSecond(facts, state.exposure);
    picture.draw(sky, view, frame, {exposure, view: state.look, stops: state.look === 'stops', fullMoon: this.fullMoon,
      around: this.around});
    drawOver(this.find('over'), {...scene, facts, circle: state.circle, marked: this.marked});
    this.say(scene);
    clearTimeout(this.later);
    this.later = setTimeout(() => this.drawBeside(), 120);
    if (this.curve) drawCurve(this.find('curve'), this.curve, facts, state.ms);
  }

  /** Shows the moment, the place and the brightness in words. */
  say({sky, view}) {
    const {state, facts} = this, {place} = state;
    const local = localTime(state.ms, place?.timeZone, facts);
    const unbroken = (textContent) => Object.assign(document.createElement('span'), {textContent});
    this.find('when').replaceChildren(
      unbroken(utc(state.ms).replace('T', ' ').replace('Z', ' UTC')), ' · ', unbroken(local));
    this.find('legend').hidden = state.look !== 'stops';
    this.find('where').textContent = place
      ? `${place.name || placeText(place)}: altitude ${signed(view.altitude, 1)}°, azimuth ${view.azimuth.toFixed(0)}°`
      : 'from the Earth’s centre';
    const below = place && view.altitude < -0.3;
    this.find('note').textContent = below ? 'The Moon is below the horizon there.' : '';
    const {whole} = this;
    this.find('whole').textContent = `V ${signed(whole.V, 2)} · mean ${number(whole.luminance)} cd/m² · ` +
      `${exposureTime(this.seconds)} at f/${state.exposure.fNumber}, ISO ${state.exposure.iso}`;
    this.find('whole').title = meanings.V;
    this.find('moment').value = state.ms;
    this.find('moment').setAttribute('aria-valuetext', utc(state.ms));
    this.find('command').textContent = below
      ? 'none: from that place the Moon is below the horizon' : commandOf(state, facts, this.seconds);
    this.find('readout').textContent = this.marked ? this.described(this.marked) : '';
  }

  /** Makes the drawings that take a tenth of a second: the light curve and the marked place. Updates the link. */
  drawBeside() {
    const {facts, motion, picture} = this;
    if (picture.gl.isContextLost()) return;
    this.curve ??= Array.from({length: curveMoments}, (_, i) => {
      const ms = motion.fromMs + (motion.toMs - motion.fromMs) * i / (curveMoments - 1);
      return {ms, ...brightness(picture, facts, motion.at(ms))};
    });
    drawCurve(this.find('curve'), this.curve, facts, this.state.ms);
    this.drawPlace();
    if (!this.playing && !this.embedded) history.replaceState(null, '', `#${linkOf(this.state, facts)}`);
  }

  /** Draws the ring of sunsets and the spectrum at the marked place. */
  drawPlace() {
    if (!this.marked || !this.find('place-in-shadow').open) return;
    const sky = this.motion.at(this.state.ms);
    const place = placeInShadow(sky, this.facts.moonRadiusKm, groundOf(sky, this.marked));
    drawSpectrum(this.find('spectrum'), this.facts.wavelengths, this.shadow.spectrum(place));
    drawRing(this.find('ring'), this.shadow.ring(place, 180), [...this.shadow.rays.heights]);
  }

  /** Selenographic place under the pointer, or null beside the Moon. */
  under(event) {
    const {sky, view, frame} = this.scene(), box = this.picture.canvas.getBoundingClientRect();
    const x = (event.clientX - box.left) * frame.ratio - frame.width / 2;
    const y = frame.height / 2 - (event.clientY - box.top) * frame.ratio;
    const ground = groundAt(view, this.facts.moonRadiusKm, frame.middle[0] + x * frame.pixel, frame.middle[1] + y * frame.pixel);
    return ground && selenographic(sky, ground);
  }

  point(event) {
    this.marked = this.under(event);
    this.find('readout').textContent = this.marked ? this.described(this.marked) : '';
    clearTimeout(this.placeLater);
    this.placeLater = setTimeout(() => this.drawPlace(), 60);
  }

  /** Text about a place: its name, coordinates and luminance. */
  described(at) {
    const light = luminance(this.radianceAt([at])[0]);
    const near = this.features.filter((f) => distance(at, f) < f.km / 2 / (this.facts.moonRadiusKm * degree))
      .sort((a, b) => a.km - b.km)[0];
    const below = Math.log2(this.fullMoon / Math.max(light, 1e-12));
    return `${near ? `${near.name}\n` : ''}${placeText(at)}\n${number(light)} cd/m²\n` +
      `${below.toFixed(1)} stops below a full Moon`;
  }

  /** Red, green and blue [cd/m²] and V's radiance at selenographic places. */
  radianceAt(places) {
    const {sky, view} = this.scene();
    const numbers = this.picture.readAt(sky, view, places.map(({longitude, latitude}) =>
      direction(longitude * degree, latitude * degree)));
    return places.map((_, i) => [...numbers.subarray(4 * i, 4 * i + 4)]);
  }

  /** Pixel on the canvas that shows a selenographic place, or null if it is behind the limb. */
  pixelOf(at) {
    const {sky, view, frame} = this.scene();
    const place = pictureOf(view, this.facts.moonRadiusKm, unit(groundOf(sky, at)));
    return place && [frame.width / 2 + (place[0] - frame.middle[0]) / frame.pixel,
      frame.height / 2 - (place[1] - frame.middle[1]) / frame.pixel];
  }

  /** Changes the state as the controls do, and draws at once. */
  set(change) {
    Object.assign(this.state, change);
    if (change.air) this.airIsOld = true;
    this.panel.show();
    this.draw();
  }

  move(ms) {
    this.state.ms = Math.min(Math.max(ms, this.motion.fromMs), this.motion.toMs);
    this.redraw();
  }

  play(on = !this.playing) {
    this.playing = on;
    const button = this.find('play');
    button.textContent = on ? 'Stop' : 'Play';
    button.setAttribute('aria-pressed', String(on));
    if (!on) return this.redraw();
    if (this.state.ms >= this.motion.toMs - 1e3) this.state.ms = this.motion.fromMs;
    const calm = matchMedia('(prefers-reduced-motion: reduce)').matches;
    let before = performance.now();
    const step = (now) => {
      if (!this.playing) return;
      if (!calm || now - before > 1000) {
        this.move(this.state.ms + Math.min(now - before, 1000) * playedRate);
        before = now;
      }
      if (this.state.ms >= this.motion.toMs) return this.play(false);
      requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }

  /** Makes a button for each contact above the time slider. */
  makeMarks() {
    const {contacts} = this.facts, {fromMs, toMs} = this.motion;
    const marks = contacts.map(({name, ms}) => {
      const button = Object.assign(document.createElement('button'), {
        textContent: name === 'greatest' ? 'greatest' : name, title: `${meanings[name]} ${utc(ms)}`});
      button.style.left = `${100 * (ms - fromMs) / (toMs - fromMs)}%`;
      button.addEventListener('click', () => this.move(ms));
      return button;
    });
    this.find('marks').replaceChildren(...marks);
  }

  /** Puts each contact in the first row that has room for it. */
  placeMarks() {
    const marks = this.find('marks'), ends = [];
    if (marks.clientWidth === this.marksWidth) return;
    this.marksWidth = marks.clientWidth;
    const boxes = [...marks.children].map((mark) => mark.getBoundingClientRect());
    boxes.forEach(({left, right, height}, i) => {
      const free = ends.findIndex((end) => end <= left), row = free < 0 ? ends.length : free;
      ends[row] = right;
      marks.children[i].style.top = `${row * height}px`;
    });
    marks.style.height = `${ends.length * boxes[0].height}px`;
  }

  listen() {
    const moment = this.find('moment'), canvas = this.picture.canvas;
    Object.assign(moment, {min: this.motion.fromMs, max: this.motion.toMs});
    moment.addEventListener('input', () => this.move(Number(moment.value)));
    this.find('play').addEventListener('click', () => this.play());
    this.find('back').addEventListener('click', () => this.move(this.state.ms - 6e5));
    this.find('on').addEventListener('click', () => this.move(this.state.ms + 6e5));
    this.find('nearer').addEventListener('click', () => this.nearer());
    this.find('farther').addEventListener('click', () => this.zoomTo(1));
    this.find('save').addEventListener('click', () => this.save());
    this.find('copy').addEventListener('click', () => this.copy(this.find('command').textContent));
    this.find('link').addEventListener('click', () => this.copy(
      `${location.href.split('#')[0]}#${linkOf(this.state, this.facts)}`));
    this.find('place-in-shadow').addEventListener('toggle', () => this.drawPlace());
    (this.embedded ? this.root : document).addEventListener('keydown', (event) => this.key(event));
    this.pointers(canvas);
    canvas.addEventListener('webglcontextlost', (event) => event.preventDefault());
    canvas.addEventListener('webglcontextrestored', () => { this.picture.build(); this.draw(); });
    new ResizeObserver(() => this.redraw()).observe(canvas);
    if (!this.embedded) window.addEventListener('hashchange', () => {
      Object.assign(this.state, stateOf(location.hash.slice(1), this.facts));
      this.changed('air');
      this.panel.show();
    });
  }

  /** Copies a text and reports it. Pages without https: copy by way of a selection. If the browser forbids copying,
   * the text stays visible and selected. */
  async copy(text) {
    const field = this.find('to-copy'), before = this.root.activeElement;
    let copied = await navigator.clipboard?.writeText(text).then(() => true, () => false);
    if (!copied) {
      Object.assign(field, {value: text, hidden: false});
      field.select();
      copied = document.execCommand('copy');
    }
    field.hidden = copied;
    if (copied) before?.focus();
    this.find('copied').textContent = copied ? 'Copied.'
      : 'The browser does not let this page copy. The text is selected: copy it yourself.';
  }

  /** Saves the current picture as a PNG file. */
  save() {
    this.draw();
    this.picture.canvas.toBlob((blob) => {
      const href = URL.createObjectURL(blob);
      const download = `moon_${utc(this.state.ms).replaceAll(':', '')}.png`;
      Object.assign(document.createElement('a'), {href, download}).click();
      setTimeout(() => URL.revokeObjectURL(href), 1e3);
    }, 'image/png');
  }

  /** Doubles the zoom around the marked place. */
  nearer() {
    const {sky, view} = this.scene();
    const place = this.marked && pictureOf(view, this.facts.moonRadiusKm, groundOf(sky, this.marked));
    if (place) this.state.middle = place;
    this.zoomTo(this.state.zoom * 2);
  }

  zoomTo(zoom) {
    this.state.zoom = Math.min(32, Math.max(1, zoom));
    if (this.state.zoom === 1) this.state.middle = [0, 0];
    this.redraw();
  }

  /** Lets a finger or the mouse move an enlarged Moon, and lets two fingers zoom around the place between them. */
  pointers(canvas) {
    const held = new Map();  // window position [x, y] of each pressed pointer, by its id
    let from = null;  // zoom, finger distance and mean place when the number of pointers last changed
    const mean = (i) => [...held.values()].reduce((sum, at) => sum + at[i], 0) / held.size;
    const apart = () => {
      const [a, b] = [...held.values()];
      return b ? Math.max(1, Math.hypot(a[0] - b[0], a[1] - b[1])) : 1;
    };
    const besideMiddle = () => {  // mean position of the pointers relative to the picture's centre
      const box = canvas.getBoundingClientRect(), {pixel, ratio} = this.frame();
      return [(mean(0) - box.left - box.width / 2) * ratio * pixel, (box.top + box.height / 2 - mean(1)) * ratio * pixel];
    };
    const begin = () => {
      from = held.size ? {zoom: this.state.zoom, apart: apart()} : null;
      if (!from) return;
      const beside = besideMiddle();
      from.place = this.state.middle.map((middle, i) => middle + beside[i]);
    };
    canvas.addEventListener('pointerdown', (event) => {
      held.set(event.pointerId, [event.clientX, event.clientY]);
      if (event.isTrusted) canvas.setPointerCapture(event.pointerId);
      begin();
      this.point(event);
    });
    canvas.addEventListener('pointermove', (event) => {
      if (!held.has(event.pointerId)) return this.point(event);
      held.set(event.pointerId, [event.clientX, event.clientY]);
      if (held.size > 1) this.zoomTo(from.zoom * apart() / from.apart);
      else if (this.state.zoom === 1) return this.point(event);
      if (this.state.zoom === 1) return;
      const beside = besideMiddle();
      this.state.middle = from.place.map((place, i) => place - beside[i]);
      this.redraw();
    });
    for (const name of ['pointerup', 'pointercancel']) canvas.addEventListener(name, (event) => {
      held.delete(event.pointerId);
      begin();
    });
    canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      this.zoomTo(this.state.zoom * Math.exp(-event.deltaY / 400));
    }, {passive: false});
  }

  key(event) {
    const target = event.composedPath()[0];
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (target.matches?.('input, select, textarea, pre') || (target.matches?.('button, summary') && event.key === ' ')) return;
    const {state} = this, step = event.shiftKey ? 6e5 : 6e4;
    const brighter = (stops) => {
      Object.assign(state.exposure, {rule: 'fixed', time: Math.min(1e5, Math.max(1e-6, this.seconds * 2 ** stops))});
      this.panel.show();
    };
    const keys = {
      ' ': () => this.play(),
      ArrowLeft: () => this.move(state.ms - step),
      ArrowRight: () => this.move(state.ms + step),
      Home: () => this.move(this.facts.contacts[0].ms),
      End: () => this.move(this.facts.contacts.at(-1).ms),
      '+': () => brighter(0.5), '-': () => brighter(-0.5),
      f: () => { state.exposure.rule = 'follow'; this.panel.show(); },
      0: () => this.zoomTo(1),
    };
    const act = keys[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!act) return;
    event.preventDefault();
    act();
    this.redraw();
  }
}

/** Angle between two selenographic places [degrees]. */
function distance(a, b) {
  const [p, q] = [a, b].map(({longitude, latitude}) => direction(longitude * degree, latitude * degree));
  return Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) / degree;
}
