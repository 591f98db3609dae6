// SPDX-License-Identifier: MIT
// What the page says, and what its words mean.

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
  gases: 'Pairs of oxygen molecules and nitrogen dioxide take a little light.',
};

export const switches = {
  refraction: 'Bending of light', scattering: 'Scattering by air', ozone: 'Ozone',
  gases: 'Other gases', aerosol: 'Dust and haze', clouds: 'Cloud',
};

/** 0.0333 as "1/30 s". */
export function exposureTime(seconds) {
  if (seconds >= 0.4) return `${Number(seconds.toPrecision(2))} s`;
  return `1/${Number((1 / seconds).toPrecision(2))} s`;
}

const wholeSeconds = (ms) => Math.round(ms / 1e3) * 1e3;

export function utc(ms) {
  return `${new Date(wholeSeconds(ms)).toISOString().slice(0, 19)}Z`;
}

/** −2.71, with a minus sign. */
export const signed = (value, decimals) => value.toFixed(decimals).replace('-', '−');

/** Clock time in a time zone; in the browser's own where none is given. */
export function localTime(ms, timeZone) {
  const options = {
    month: 'short', day: 'numeric', hour: '2-digit', minute: '2-digit', second: '2-digit',
    hourCycle: 'h23', timeZoneName: 'short',
  };
  return new Intl.DateTimeFormat('en-GB', timeZone ? {...options, timeZone} : options).format(wholeSeconds(ms));
}

/** 12.3° N or S, E or W. */
const half = (value, [positive, negative]) => `${Math.abs(value).toFixed(1)}° ${value < 0 ? negative : positive}`;
export const placeText = ({latitude, longitude}) => `${half(latitude, 'NS')}, ${half(longitude, 'EW')}`;

/** Three digits, without an exponent where it can be read. */
export function number(value) {
  if (value === 0 || !Number.isFinite(value)) return '0';
  if (value >= 1e5 || value < 1e-4) return value.toExponential(2);
  return String(Number(value.toPrecision(3)));
}
