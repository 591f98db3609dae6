// SPDX-License-Identifier: MIT
// Texts that the page shows, including explanations of its terms.

export const meanings = {
  P1: 'P1: the Moon touches the penumbra, where the Earth covers a part of the Sun.',
  U1: 'U1: the Moon touches the umbra. The partial eclipse begins.',
  U2: 'U2: the whole Moon is in the umbra. Totality begins.',
  greatest: 'Greatest eclipse: the Moon is nearest to the middle of the shadow.',
  U3: 'U3: the Moon begins to leave the umbra. Totality ends.',
  U4: 'U4: the Moon has left the umbra.',
  P4: 'P4: the Moon has left the penumbra.',
  V: 'V: visual magnitude of the whole Moon. Five magnitudes are a factor of 100; smaller is brighter.',
  stops: 'Stops: each is a factor of two in light.',
  danjon: 'Danjon’s scale: 0 is a nearly invisible Moon, 2 deep red, 4 bright copper.',
  dust: 'Optical depth of volcanic droplets in the stratosphere: 0.005 in quiet years, 0.1 after a great eruption.',
  cloud: 'Factor on how often cloud stops a ray that grazes the Earth.',
  haze: 'Factor on the aerosol below the stratosphere.',
  ozone: 'Ozone over each place, in Dobson units. It takes out orange light: the rim of the umbra turns turquoise.',
  refraction: 'The air bends light into the shadow. Without it the umbra is black.',
  scattering: 'The molecules of the air scatter blue light out of the rays: what is left is red.',
  observerAir: 'The air between the Moon and the place dims and reddens it: the more, the lower it stands.',
  gases: 'Oxygen, water vapour and nitrogen dioxide take some light, most of it deep red.',
};

export const switches = {
  refraction: 'Bending of light', scattering: 'Scattering by air', ozone: 'Ozone',
  gases: 'Other gases', aerosol: 'Dust and haze', clouds: 'Cloud',
};

/** Exposure time in words: 0.0333 is "1/30 s". */
export function exposureTime(seconds) {
  if (seconds >= 0.4) return `${Number(seconds.toPrecision(2))} s`;
  return `1/${Number((1 / seconds).toPrecision(2))} s`;
}

const wholeSeconds = (ms) => Math.round(ms / 1e3) * 1e3;

export function utc(ms) {
  return `${new Date(wholeSeconds(ms)).toISOString().slice(0, 19)}Z`;
}

/** Number with a minus sign in place of a hyphen: "−2.71". */
export const signed = (value, decimals) => value.toFixed(decimals).replace('-', '−');

/**
 * Date and time in a time zone, by default the browser's: "27 Jul, 15:21:45 CDT", or "… UTC−5" if the zone has no
 * abbreviation in letters.
 *
 * Given  facts  zones: each zone's abbreviations at the page's first and last moment
 */
export function localTime(ms, timeZone, {fromMs, zones}) {
  const format = new Intl.DateTimeFormat('en-GB', {
    month: 'short', day: 'numeric', hour: '2-digit', minute: '2-digit', second: '2-digit',
    hourCycle: 'h23', timeZoneName: 'shortOffset', ...(timeZone && {timeZone}),
  });
  const offsetAt = (at) => format.formatToParts(at).find(({type}) => type === 'timeZoneName').value;
  const offset = offsetAt(ms), [first, last] = zones[timeZone || format.resolvedOptions().timeZone] ?? [];
  const name = offset === offsetAt(fromMs) ? first : last;
  const shown = /^[A-Z]+$/i.test(name ?? '') ? name : offset.replace('GMT', 'UTC').replace('-', '−').replace(/\+0$/, '');
  return format.formatToParts(wholeSeconds(ms)).map(({type, value}) => (type === 'timeZoneName' ? shown : value)).join('');
}

/** Angle with its hemisphere: "12.3° N". */
const half = (value, [positive, negative]) => `${Math.abs(value).toFixed(1)}° ${value < 0 ? negative : positive}`;
export const placeText = ({latitude, longitude}) => `${half(latitude, 'NS')}, ${half(longitude, 'EW')}`;

/** A number to three digits, without an exponent between 1e-4 and 1e5. */
export function number(value) {
  if (value === 0 || !Number.isFinite(value)) return '0';
  if (value >= 1e5 || value < 1e-4) return value.toExponential(2);
  return String(Number(value.toPrecision(3)));
}
