// SPDX-License-Identifier: MIT
// The page's controls. Each control shows part of the page's state and lets the user change it.

import {airAsItWas, meanOver, withoutClearness} from './air.js';
import {rowsOf} from './arrays.js';
import {exposureTime, meanings, number, switches} from './words.js';

function element(name, properties = {}, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

/** Cities by name. */
export class Places {
  constructor(text) {
    this.cities = rowsOf(text).map(([name, region, latitude, longitude, metres, timeZone]) => ({
      name, region, latitude: Number(latitude), longitude: Number(longitude), timeZone, elevationKm: metres / 1e3}));
  }

  /** Place for a typed text: a city, or coordinates such as "-1.28, 36.82"; null for any other text. */
  named(text) {
    const typed = text.trim().toLowerCase();
    const pair = typed.match(/^(-?[\d.]+)\s*[, ]\s*(-?[\d.]+)$/);
    if (pair) {
      const [latitude, longitude] = [Number(pair[1]), Number(pair[2])];
      const sound = Math.abs(latitude) <= 90 && Math.abs(longitude) <= 360;
      return sound ? {name: '', latitude, longitude, timeZone: this.nearest(latitude, longitude).timeZone, elevationKm: 0} : null;
    }
    return this.cities.find(({name}) => name.toLowerCase() === typed) ??
      this.cities.find(({name}) => name.toLowerCase().startsWith(typed)) ?? null;
  }

  nearest(latitude, longitude) {
    const away = (city) => Math.hypot(city.latitude - latitude,
      (((city.longitude - longitude + 540) % 360) - 180) * Math.cos(latitude * Math.PI / 180));
    return this.cities.reduce((best, city) => (away(city) < away(best) ? city : best));
  }
}

/** F-numbers and ISO speeds for typical cameras. */
const cameras = {
  'Telescope, f/12': [12.1, 800], 'Refractor 80 mm, f/7.5': [7.5, 800], 'Lens 400 mm, f/5.6': [5.6, 800],
  'Lens 200 mm, f/2.8': [2.8, 400], 'Phone, f/1.8': [1.8, 400]};

/** Logarithmic slider whose left end is 0. */
function slider({title, meaning, low, high, value, show, set}) {
  const shown = element('output', {textContent: show(value)});
  const ratio = Math.log(high / low);
  const place = (v) => (v <= low ? 0 : Math.log(v / low) / ratio);
  const input = element('input', {type: 'range', min: 0, max: 1, step: 'any', value: place(value)});
  input.setAttribute('aria-label', title);
  const valueAt = () => (Number(input.value) === 0 ? 0 : low * Math.exp(ratio * Number(input.value)));
  input.addEventListener('input', () => {
    shown.textContent = show(valueAt());
    input.setAttribute('aria-valuetext', shown.textContent);
    set(valueAt());
  });
  return element('label', {}, element('span', {title: meaning, textContent: title}), shown, input);
}

const pressed = (button, on) => button.setAttribute('aria-pressed', String(on));

export class Panel {
  /**
   * Given  root     element that contains the page
   *        changed  called with 'view', 'look' or 'air' after a change of the state
   */
  constructor(root, facts, places, state, changed) {
    Object.assign(this, {root, facts, places, state, changed});
    this.show();
  }

  /** Rebuilds all controls from the state. */
  show() {
    for (const part of ['who', 'exposure', 'air', 'why'])
      this.root.querySelector(`.${part}`).replaceChildren(...this[part]());
    this.root.querySelector('.words').replaceChildren(...this.words());
  }

  select(title, choices, value, set) {
    const input = element('select', {}, ...Object.entries(choices).map(([key, text]) =>
      element('option', {value: key, textContent: text, selected: key === value})));
    input.addEventListener('change', () => set(input.value));
    return element('label', {}, title, input);
  }

  check(title, meaning, value, set) {
    const input = element('input', {type: 'checkbox', checked: value});
    input.addEventListener('change', () => set(input.checked));
    return element('label', {className: 'switch'}, input, element('span', {title: meaning ?? '', textContent: title}));
  }

  who() {
    const {state} = this, {place} = state;
    const list = element('datalist', {id: 'cities'}, ...this.places.cities.map(({name, region}) =>
      element('option', {value: name, label: region})));
    const input = element('input', {
      type: 'text', placeholder: 'the Earth’s centre', autocomplete: 'off',
      value: place ? place.name || `${place.latitude}, ${place.longitude}` : ''});
    input.setAttribute('list', 'cities');
    const problem = element('output', {});
    input.addEventListener('change', () => {
      const found = input.value.trim() ? this.places.named(input.value) : null;
      problem.textContent = input.value.trim() && !found ? 'not known' : '';
      if (problem.textContent) return;
      state.place = found;
      if (!found && state.up === 'zenith') state.up = 'north';
      this.changed('view');
      this.show();
    });
    const ups = {north: 'celestial north', moon: 'the Moon’s north', ...(place ? {zenith: 'zenith'} : {})};
    return [
      element('label', {}, 'Place: a city, or latitude, longitude', problem, input), list,
      this.select('Up is', ups, state.up, (up) => { state.up = up; this.changed('view'); }),
      ...(place ? [this.check('The air above the place', meanings.observerAir, state.reddening,
        (on) => { state.reddening = on; this.changed('view'); })] : []),
      this.check('Mark the shadow', 'Edges of umbra and penumbra at the Moon’s distance, as geometry has them.', state.circle,
        (on) => { state.circle = on; this.changed('view'); }),
    ];
  }

  exposure() {
    const {state, facts} = this, {exposure} = state;
    const set = (change) => { Object.assign(exposure, change); this.changed('look'); };
    const rules = {follow: 'follows the eclipse', fixed: 'fixed'};
    const looks = {...Object.fromEntries(facts.views.map((view) => [view, view])), stops: 'stops below a full Moon'};
    const camera = Object.entries(cameras).find(([, [f, iso]]) => f === exposure.fNumber && iso === exposure.iso);
    return [
      this.select('Exposure', rules, exposure.rule, (rule) => { set({rule}); this.show(); }),
      ...(exposure.rule === 'fixed' ? [slider({
        title: 'Time', meaning: meanings.stops, low: 1 / 4000, high: 60, value: exposure.time, show: exposureTime,
        set: (time) => set({time: Math.max(time, 1 / 4000)})})] : []),
      this.select('Camera', {...Object.fromEntries(Object.keys(cameras).map((name) => [name, name])),
        ...(camera ? {} : {other: `f/${exposure.fNumber}, ISO ${exposure.iso}`})}, camera ? camera[0] : 'other', (name) => {
        if (cameras[name]) set({fNumber: cameras[name][0], iso: cameras[name][1]});
      }),
      this.select('Shown as', looks, state.look, (look) => { state.look = look; this.changed('look'); }),
    ];
  }

  setAir(change) {
    Object.assign(this.state.air, change);
    this.changed('air');
  }

  /** The air as sliders show it, with a step on Danjon's scale converted to cloud, haze and dust. */
  plainAir() {
    return withoutClearness(this.state.air, this.mean('aerosolDepth'));
  }

  /** Changes the air from a slider, and deselects any step on Danjon's scale. */
  slide(change) {
    this.setAir({...this.plainAir(), ...change});
    for (const button of this.root.querySelectorAll('.steps button')) pressed(button, false);
  }

  air() {
    const {facts} = this, air = this.plainAir();
    const asItWas = (value) => (value === null ? 'as it was' : number(value));
    return [this.presets(), ...(facts.danjon.length ? [this.danjon()] : []),
      slider({title: 'Cloud', meaning: meanings.cloud, low: 0.05, high: 4, value: air.cloud,
        show: (x) => `× ${number(x)}`, set: (cloud) => this.slide({cloud})}),
      slider({title: 'Haze', meaning: meanings.haze, low: 0.05, high: 10, value: air.haze,
        show: (x) => `× ${number(x)}`, set: (haze) => this.slide({haze})}),
      slider({title: 'Volcanic dust', meaning: meanings.dust, low: 0.001, high: 1,
        value: air.dust ?? this.mean('aerosolDepth'), show: (x) => number(x), set: (dust) => this.slide({dust})}),
      slider({title: 'Ozone', meaning: meanings.ozone, low: 20, high: 600, value: air.ozoneDu ?? this.mean('ozoneDu'),
        show: (x) => `${asItWas(Math.round(x))} DU`, set: (ozoneDu) => this.slide({ozoneDu})}),
    ];
  }

  mean(name) {
    return meanOver(this.facts.limb.parts, (part) => part[name]);
  }

  presets() {
    const row = element('div', {className: 'danjon'});
    const clean = {cloud: 0, haze: 0, dust: 0};
    const choices = {
      'As it was': {}, 'Clear': {...clean}, 'Molecules': {...clean, ozone: false, gases: false},
      'No air': {...clean, refraction: false, scattering: false, ozone: false, gases: false}};
    for (const [name, change] of Object.entries(choices)) {
      const button = element('button', {textContent: name});
      button.addEventListener('click', () => { this.setAir({...airAsItWas, ...change}); this.show(); });
      row.append(button);
    }
    return row;
  }

  danjon() {
    const {facts, state} = this;
    const row = element('div', {className: 'danjon steps'}, element('span', {title: meanings.danjon, textContent: 'Danjon'}));
    facts.danjon.forEach((clearness, l) => {
      const button = element('button', {textContent: String(l), title: meanings.danjon});
      pressed(button, state.air.clearness === clearness && clearness !== 0);
      button.addEventListener('click', () => { this.setAir({...airAsItWas, clearness}); this.show(); });
      row.append(button);
    });
    return row;
  }

  why() {
    const {air} = this.state;
    return [element('p', {textContent: 'Take a cause away, and see what it does.'}),
      ...Object.entries(switches).map(([name, title]) =>
        this.check(title, meanings[name] ?? meanings[{aerosol: 'dust', clouds: 'cloud'}[name]], air[name],
          (on) => this.setAir({[name]: on})))];
  }

  words() {
    const keys = {Space: 'plays and stops', '← →': 'one minute', 'Shift ← →': 'ten minutes', 'Home, End': 'P1, P4',
      '+ −': 'exposure, half a stop', F: 'exposure follows', '0': 'the whole Moon again', 'Wheel, two fingers': 'nearer'};
    const listed = ['P1', 'U1', 'U2', 'greatest', 'U3', 'U4', 'P4', 'V', 'stops', 'danjon'].map((word) => {
      const [name, ...rest] = meanings[word].split(': ');
      return [name, rest.join(': ')];
    });
    return [...listed, ...Object.entries(keys)].flatMap(([word, meaning]) =>
      [element('dt', {textContent: word}), element('dd', {textContent: meaning})]);
  }
}
