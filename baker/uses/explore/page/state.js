// SPDX-License-Identifier: MIT
// Converts the page's state to and from a link's fragment, and to the command that renders the same picture.

import {airAsItWas, meanOver, remaining} from './air.js';
import {switches, utc} from './words.js';

export function firstState(facts) {
  return {
    ms: facts.contacts.find(({name}) => name === 'greatest').ms,
    place: Object.keys(facts.place ?? {}).length ? facts.place : null,
    up: 'north',
    reddening: facts.reddening,  // whether the observer's air reddens the Moon
    exposure: {rule: 'follow', time: 1, iso: 800, fNumber: 12.1},
    look: facts.views[0],
    air: {...airAsItWas},
    circle: false,
    zoom: 1,
    middle: [0, 0],
  };
}

const numberIn = (text, low, high) => {
  const value = Number(text);
  return text !== null && text !== '' && value >= low && value <= high ? value : undefined;
};

const airNumbers = {
  cloud: [0, 10], haze: [0, 10], dust: [0, 2], ozoneDu: [0, 1000], clearness: [-2, 1]};

/** Fragment for a link, with everything that differs from the first state. */
export function linkOf(state, facts) {
  const first = firstState(facts), words = new URLSearchParams();
  if (Math.abs(state.ms - first.ms) >= 500) words.set('t', utc(state.ms));
  const {place} = state;
  if (place !== first.place) words.set('at', place
    ? [place.latitude, place.longitude, place.name ?? '', place.timeZone ?? '', place.elevationKm ?? 0].join('|') : '');
  if (state.up !== first.up) words.set('up', state.up);
  if (state.reddening !== first.reddening) words.set('reddening', state.reddening ? 'on' : 'off');
  if (state.exposure.rule === 'fixed') words.set('time', state.exposure.time);
  if (state.exposure.iso !== first.exposure.iso) words.set('iso', state.exposure.iso);
  if (state.exposure.fNumber !== first.exposure.fNumber) words.set('f', state.exposure.fNumber);
  if (state.look !== first.look) words.set('look', state.look);
  if (state.circle) words.set('circle', '1');
  if (state.zoom !== 1) words.set('zoom', [state.zoom, ...state.middle].map((x) => x.toFixed(3)).join('|'));
  for (const name of Object.keys(airNumbers))
    if (state.air[name] !== airAsItWas[name]) words.set(name, state.air[name]);
  const off = Object.keys(switches).filter((name) => !state.air[name]);
  if (off.length) words.set('off', off.join('|'));
  return words.toString();
}

/** The state in a link's fragment. Invalid values are taken from the first state. */
export function stateOf(link, facts) {
  const state = firstState(facts), words = new URLSearchParams(link);
  const ms = Date.parse(words.get('t') ?? '');
  const {fromMs, motion} = facts;
  if (!Number.isNaN(ms)) state.ms = Math.min(Math.max(ms, fromMs), fromMs + 1e3 * motion.seconds);
  if (words.has('at')) {
    const [latitude, longitude, name, timeZone, elevationKm] = words.get('at').split('|');
    const at = {latitude: numberIn(latitude, -90, 90), longitude: numberIn(longitude, -360, 360)};
    state.place = at.latitude === undefined || at.longitude === undefined ? null
      : {...at, name: name ?? '', timeZone: zoneNamed(timeZone), elevationKm: numberIn(elevationKm ?? null, -0.5, 100) ?? 0};
  }
  if (['north', 'zenith', 'moon'].includes(words.get('up'))) state.up = words.get('up');
  if (['on', 'off'].includes(words.get('reddening'))) state.reddening = words.get('reddening') === 'on';
  const time = numberIn(words.get('time'), 1e-6, 1e6);
  if (time) Object.assign(state.exposure, {rule: 'fixed', time});
  state.exposure.iso = numberIn(words.get('iso'), 1, 1e7) ?? state.exposure.iso;
  state.exposure.fNumber = numberIn(words.get('f'), 0.5, 512) ?? state.exposure.fNumber;
  if ([...facts.views, 'stops'].includes(words.get('look'))) state.look = words.get('look');
  state.circle = words.get('circle') === '1';
  const [zoom, x, y] = (words.get('zoom') ?? '').split('|');
  state.zoom = numberIn(zoom, 0.5, 64) ?? 1;
  state.middle = [numberIn(x, -2, 2) ?? 0, numberIn(y, -2, 2) ?? 0];
  for (const [name, range] of Object.entries(airNumbers))
    state.air[name] = numberIn(words.get(name), ...range) ?? state.air[name];
  for (const name of (words.get('off') ?? '').split('|')) if (name in switches) state.air[name] = false;
  return state;
}

/** The name of a time zone if the browser knows it, otherwise empty. */
function zoneNamed(name) {
  try {
    return name && new Intl.DateTimeFormat('en', {timeZone: name}) ? name : '';
  } catch {
    return '';
  }
}

const short = (value) => String(Number(value.toPrecision(4)));

/** Command-line options that make the same air. */
function airOptions(air, facts) {
  const options = [], cloud = air.clouds ? air.cloud : 0, haze = air.aerosol ? air.haze : 0;
  const mean = (name) => meanOver(facts.limb.parts, (part) => part[name]), share = remaining(air);
  const add = (changed, ...words) => { if (changed) options.push(...words); };
  const step = air.clearness === 0 ? -1 : facts.danjon.indexOf(air.clearness);
  if (step >= 0) return ['--danjon', String(step)];
  add(!air.refraction, '--refraction', 'off');
  add(!air.scattering, '--rayleigh', 'off');
  add(!air.gases, '--oxygen-pairs', 'off', '--oxygen-bands', 'off', '--nitrogen-dioxide', 'off', '--water-vapour', '0');
  if (!air.ozone || air.ozoneDu !== null) options.push('--ozone-du', short(air.ozone ? air.ozoneDu : 0));
  if (facts.dated) {
    add(cloud * share !== 1, '--cloud-chance', short(cloud * share), '--cirrus', short(cloud * share));
    add(haze * share !== 1, '--free-troposphere', short(haze * share));
    add(haze * share !== 1, '--tropospheric-aerosol', short(haze * share * facts.haze));
  } else {
    add(cloud !== 1, '--cloud-cover', short(Math.min(1, cloud * mean('cloudCover'))));
    add(haze !== 1, '--tropospheric-aerosol', short(haze * facts.haze));
  }
  const depth = (air.dust ?? mean('aerosolDepth')) * share - Math.min(0, air.clearness);
  if (!air.aerosol) options.push('--stratospheric-aerosol', '0');
  else add(air.dust !== null || air.clearness !== 0, '--stratospheric-aerosol', short(Math.min(2, depth)));
  return options;
}

const quoted = (word) => (/^[\w.,:+/-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`);

/** Command line that makes the current picture. */
export function commandOf(state, facts, seconds) {
  const {place, exposure} = state, words = ['still', utc(state.ms)];
  if (place) {
    const metres = Math.round(1000 * (place.elevationKm ?? 0));
    words.push('--at', [place.latitude.toFixed(4), place.longitude.toFixed(4), ...(metres ? [metres] : [])].join(','));
    if (!state.reddening) words.push('--reddening', 'off');
    words.push('--flattening', 'off');  // the page draws the Moon without flattening
  }
  if (state.up !== 'north') words.push('--up', {zenith: 'zenith', moon: 'moon-north'}[state.up]);
  words.push('--time', exposure.rule === 'follow' ? short(seconds) : short(exposure.time));
  words.push('--iso', short(exposure.iso), '--f-number', short(exposure.fNumber));
  if (state.look !== facts.views[0] && state.look !== 'stops') words.push('--view', state.look);
  words.push(...airOptions(state.air, facts));
  const options = facts.options ? ` ${facts.options}` : '';
  return `coppermoon ${words.map(quoted).join(' ')}${options} -o moon.png`;
}
