// SPDX-License-Identifier: MIT
// Operations on vectors of three numbers and on 3 x 3 matrices, which are stored column by column.

export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const scaled = (a, k) => [a[0] * k, a[1] * k, a[2] * k];
export const difference = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const length = (a) => Math.sqrt(dot(a, a));
export const unit = (a) => scaled(a, 1 / length(a));
export const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

export const times = (m, v) =>
  [0, 1, 2].map((row) => m[row] * v[0] + m[3 + row] * v[1] + m[6 + row] * v[2]);

export const transposed = (m) => [m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]];

/** Unit vector towards a longitude and a latitude [rad]. */
export const direction = (longitude, latitude) => [
  Math.cos(latitude) * Math.cos(longitude), Math.cos(latitude) * Math.sin(longitude),
  Math.sin(latitude)];

export const degree = Math.PI / 180;

/** Luminance of a linear Rec.709 colour: the three numbers from index i on. */
export const luminance = (rgb, i = 0) => 0.2126390059 * rgb[i] + 0.7151686788 * rgb[i + 1] + 0.0721923154 * rgb[i + 2];
