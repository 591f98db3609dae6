// SPDX-License-Identifier: MIT
// Positions of the Sun, Moon and Earth at one moment, and the view from a place on the Earth. In the shadow's frame, X
// is celestial east, Y is celestial north, Z points away from the Sun, and the Earth's centre is the origin [km].

import {cross, degree, difference, direction, dot, length, scaled, times, transposed, unit} from './vectors.js';

/** Σ c_k T_k(x), by Clenshaw's recurrence. */
function chebyshev(coefficients, x) {
  let b1 = 0, b2 = 0;
  for (let k = coefficients.length - 1; k > 0; --k) [b1, b2] = [2 * x * b1 - b2 + coefficients[k], b1];
  return x * b1 - b2 + coefficients[0];
}

export class Motion {
  constructor(facts) {
    this.facts = facts;
    this.motion = facts.motion;
    this.fromMs = facts.fromMs;
    this.toMs = facts.fromMs + facts.motion.seconds * 1e3;
  }

  /** The sky at a moment [ms since 1970], limited to the time that the series cover. */
  at(ms) {
    const within = Math.min(Math.max(ms, this.fromMs), this.toMs);
    const x = 2 * (within - this.fromMs) / (this.toMs - this.fromMs) - 1;
    const of = (name) => this.motion.series[name].map((c) => chebyshev(c, x));
    const [start, grown] = this.motion.siderealTime;
    return {
      centre: of('centre'),
      sunDistance: of('sunDistance')[0],
      moonFrame: of('moonFrame'),
      equatorFrame: of('equatorFrame'),
      siderealTime: start + grown * (x + 1) / 2,
    };
  }

  /** Least and greatest depth in the shadow that visible ground reaches during the eclipse [km]. */
  depths() {
    const radius = this.facts.moonRadiusKm;
    const depths = [];
    for (let i = 0; i <= 20; ++i)
      depths.push(this.at(this.fromMs + (this.toMs - this.fromMs) * i / 20).centre[2]);
    return [Math.min(...depths) - radius - 20, Math.max(...depths) + 20];
  }
}

const equatorial = 6378.137, flattening = 1 / 298.257223563;  // WGS 84

/** Position [km] and zenith of a place on the Earth. */
function placeOnEarth(sky, place) {
  const latitude = place.latitude * degree;
  const longitude = place.longitude * degree + sky.siderealTime;
  const up = direction(longitude, latitude);
  const e2 = flattening * (2 - flattening);
  const normal = equatorial / Math.sqrt(1 - e2 * Math.sin(latitude) ** 2);
  const height = place.elevationKm ?? 0;
  const position = [
    (normal + height) * up[0], (normal + height) * up[1], (normal * (1 - e2) + height) * up[2]];
  return {position: times(sky.equatorFrame, position), zenith: times(sky.equatorFrame, up)};
}

/** Refraction at a true altitude [degrees], as in atmosphere::apparent_altitude. */
export function refraction(altitude) {
  const lowest = Math.max(altitude, -1), fades = Math.min(1, Math.max(0, altitude + 2));
  return fades * (1.02 / Math.tan((lowest + 10.3 / (lowest + 5.11)) * degree) + 0.0019279) / 60;
}

/** Altitude with and without refraction, and azimuth from north through east [degrees]. */
function horizonPlace(sky, zenith, sight) {
  const pole = times(sky.equatorFrame, [0, 0, 1]);
  const east = unit(cross(pole, zenith)), north = cross(zenith, east);
  const altitude = Math.asin(dot(sight, zenith)) / degree;
  const azimuth = Math.atan2(dot(sight, east), dot(sight, north)) / degree;
  return {altitude: altitude + refraction(altitude), trueAltitude: altitude, azimuth: (azimuth + 360) % 360};
}

/**
 * View of the Moon.
 *
 * Given    place  on the Earth; if absent, the Earth's centre
 *          up     what is up in the picture: 'north', 'zenith' or 'moon'
 * Returned distance [km]; forward, right and up: the picture's axes; for a place also altitude, trueAltitude, azimuth
 *          and sunAltitude [degrees], which is true
 */
export function viewFrom(sky, place, up) {
  const pole = times(sky.equatorFrame, [0, 0, 1]);
  const stand = place ? placeOnEarth(sky, place) : {position: [0, 0, 0], zenith: pole};
  const toMoon = difference(sky.centre, stand.position);
  const forward = unit(toMoon);
  const pointing = {north: pole, zenith: stand.zenith, moon: times(sky.moonFrame, [0, 0, 1])}[up];
  const upward = unit(difference(pointing, scaled(forward, dot(pointing, forward))));
  const view = {
    distance: length(toMoon), position: stand.position, forward, up: upward,
    right: cross(forward, upward),
  };
  if (place) {
    const sunAltitude = -Math.asin(stand.zenith[2]) / degree;  // the Sun is towards −Z
    Object.assign(view, horizonPlace(sky, stand.zenith, forward), {sunAltitude});
  }
  return view;
}

/**
 * Ground seen at a point in the picture.
 *
 * Given    x, y  from the disc's middle to the right and up, in lunar radii at its distance
 * Returned unit vector, shadow's frame; null beside the Moon
 */
export function groundAt(view, radius, x, y) {
  const away = radius / view.distance * Math.hypot(x, y);  // tangent of the angle from the disc's centre
  const sine = away / Math.sqrt(1 + away * away), cosine = 1 / Math.sqrt(1 + away * away);
  const nearest = view.distance * sine;  // distance between the line of sight and the Moon's centre
  if (nearest >= radius) return null;
  const reach = Math.hypot(x, y) || 1;
  const out = [0, 1, 2].map((i) => (x * view.right[i] + y * view.up[i]) / reach);
  const half = Math.sqrt(radius * radius - nearest * nearest);
  return [0, 1, 2].map((i) => {
    const sight = cosine * view.forward[i] + sine * out[i];
    const across = cosine * out[i] - sine * view.forward[i];
    return (nearest * across - half * sight) / radius;
  });
}

/** Point in the picture at which ground is seen (the inverse of groundAt), or null if it is behind the limb. */
export function pictureOf(view, radius, ground) {
  const depth = view.distance + radius * dot(ground, view.forward);
  const towards = dot(ground, view.forward);
  if (towards > -radius / view.distance) return null;
  const scale = view.distance / depth;
  return [dot(ground, view.right) * scale, dot(ground, view.up) * scale];
}

/** Selenographic longitude and latitude of some ground [degrees]. */
export function selenographic(sky, ground) {
  const [x, y, z] = times(transposed(sky.moonFrame), ground);
  return {longitude: Math.atan2(y, x) / degree, latitude: Math.asin(z) / degree};
}

/** Ground at a selenographic place [degrees]. */
export function groundOf(sky, {longitude, latitude}) {
  return times(sky.moonFrame, direction(longitude * degree, latitude * degree));
}

/** Where some ground is in the shadow: axis distance and depth [km], position angle [rad]. */
export function placeInShadow(sky, radius, ground) {
  const p = sky.centre.map((c, i) => c + radius * ground[i]);
  return {axisDistance: Math.hypot(p[0], p[1]), angle: Math.atan2(p[0], p[1]), depth: p[2]};
}
