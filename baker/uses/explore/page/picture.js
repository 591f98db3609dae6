// SPDX-License-Identifier: MIT
// Draws the Moon on a canvas with WebGL 2, without extensions.

import shader from './moon.glsl';
import {degree, transposed} from './vectors.js';

const corners = `#version 300 es
void main() { gl_Position = vec4(vec2(gl_VertexID % 2, gl_VertexID / 2) * 4.0 - 1.0, 0.0, 1.0); }`;

/** Colours for "stops below a full Moon" in sRGB, one for every two stops; the lower stop is drawn darker. */
export const stopColours = [
  [1, 1, 1], [1, 0.95, 0.5], [1, 0.75, 0.2], [0.95, 0.45, 0.15], [0.8, 0.2, 0.25],
  [0.6, 0.2, 0.55], [0.35, 0.3, 0.75], [0.2, 0.5, 0.75], [0.15, 0.55, 0.5], [0.2, 0.25, 0.25]];
export const darker = 0.85;

const widest = 1024;  // largest width of the texture that holds places on the Moon [texels]

function compiled(gl, kind, text) {
  const part = gl.createShader(kind);
  gl.shaderSource(part, text);
  gl.compileShader(part);
  if (!gl.getShaderParameter(part, gl.COMPILE_STATUS) && !gl.isContextLost())
    throw new Error(gl.getShaderInfoLog(part));
  return part;
}

/** A shader program, and a function that sets its uniforms by name and ignores names it does not have. */
function programOf(gl, define) {
  const program = gl.createProgram();
  gl.attachShader(program, compiled(gl, gl.VERTEX_SHADER, corners));
  gl.attachShader(program, compiled(gl, gl.FRAGMENT_SHADER, `#version 300 es\n${define}\n${shader}`));
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost())
    throw new Error(gl.getProgramInfoLog(program));
  const setters = {[gl.FLOAT]: 'uniform1fv', [gl.FLOAT_VEC2]: 'uniform2fv', [gl.FLOAT_VEC3]: 'uniform3fv', [gl.FLOAT_VEC4]: 'uniform4fv'};
  const uniforms = {};
  for (let i = 0; i < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); ++i) {
    const {name, type} = gl.getActiveUniform(program, i), place = gl.getUniformLocation(program, name);
    uniforms[name.replace('[0]', '')] = (value) => (type === gl.FLOAT_MAT3 ? gl.uniformMatrix3fv(place, false, value)
      : gl[setters[type] ?? 'uniform1iv'](place, [value].flat()));
  }
  const set = (values) => Object.entries(values).forEach(([name, value]) => uniforms[name]?.(value));
  return {program, set};
}

export class Picture {
  constructor(canvas, facts, arrays) {
    this.canvas = canvas;
    this.facts = facts;
    this.arrays = arrays;
    this.tables = {};
    this.gl = canvas.getContext('webgl2', {alpha: false, antialias: false, preserveDrawingBuffer: true});
    if (!this.gl) throw new Error('This browser has no WebGL 2, which the picture needs.');
    this.build();
  }

  /** Creates everything on the graphics card, also again after the context was lost. */
  build() {
    const {gl, facts, arrays} = this;
    this.screen = programOf(gl, '');
    this.raw = programOf(gl, '#define RAW');
    const {shape, data} = arrays.map;
    this.map = this.texture(gl.TEXTURE_2D, gl.LINEAR_MIPMAP_LINEAR);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.R8, shape[1], shape[0], 0, gl.RED, gl.UNSIGNED_BYTE, data);
    gl.generateMipmap(gl.TEXTURE_2D);
    this.ground = this.texture(gl.TEXTURE_2D, gl.LINEAR);
    const {shape: cells, data: grounds} = arrays.ground;
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RG8, cells[1], cells[0], 0, gl.RG, gl.UNSIGNED_BYTE, grounds);
    this.views = {};
    for (const name of facts.views) {
      if (!arrays[`view.${name}`]) continue;
      const n = facts.viewTable.size;
      this.views[name] = this.texture(gl.TEXTURE_3D, gl.LINEAR);
      gl.texImage3D(gl.TEXTURE_3D, 0, gl.RGB8, n, n, n, 0, gl.RGB, gl.UNSIGNED_BYTE, arrays[`view.${name}`].data);
    }
    this.noView = this.texture(gl.TEXTURE_3D, gl.NEAREST);
    gl.texImage3D(gl.TEXTURE_3D, 0, gl.RGB8, 1, 1, 1, 0, gl.RGB, gl.UNSIGNED_BYTE, new Uint8Array(3));
    this.lights = {};
    this.places = this.texture(gl.TEXTURE_2D, gl.NEAREST);
    this.frame = gl.createFramebuffer();
    for (const [name, table] of Object.entries(this.tables)) this.setLight(name, table, this.shadow);
  }

  texture(kind, filter) {
    const {gl} = this, texture = gl.createTexture();
    gl.bindTexture(kind, texture);
    gl.texParameteri(kind, gl.TEXTURE_MIN_FILTER, filter);
    gl.texParameteri(kind, gl.TEXTURE_MAG_FILTER, filter === gl.NEAREST ? filter : gl.LINEAR);
    for (const side of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T, gl.TEXTURE_WRAP_R])
      gl.texParameteri(kind, side, gl.CLAMP_TO_EDGE);
    return texture;
  }

  /** Sets the light on the Moon (Shadow.table) that is 'seen' by the observer, 'above' the observer's air, or
   * 'followed' by the exposure. */
  setLight(name, table, shadow) {
    const {gl} = this;
    if (this.tables[name] === table && this.lights[name]) return;
    this.tables[name] = table;
    this.shadow = shadow;
    this.lights[name] ??= this.texture(gl.TEXTURE_2D, gl.NEAREST);
    gl.bindTexture(gl.TEXTURE_2D, this.lights[name]);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, 2 * table.nodes, table.rows, 0, gl.RGBA, gl.FLOAT, table.values);
  }

  /** Binds a texture to a texture unit and returns the unit. */
  bound(unit, texture, kind = this.gl.TEXTURE_2D) {
    this.gl.activeTexture(this.gl.TEXTURE0 + unit);
    this.gl.bindTexture(kind, texture);
    return unit;
  }

  /** Sets the uniforms that both programs share, in one of them. */
  setUniforms({program, set}, sky, view, frame, {shadowed = true, light = 'seen'} = {}) {
    const {facts, shadow} = this, {map, photometry: law} = facts, {ground} = map, {nodes, sectors, stretches} = this.tables[light];
    const longitudes = (of) => [of.firstLongitude * degree, of.longitudes * degree];
    this.gl.useProgram(program);
    set({
      centre: sky.centre, sunDistance: sky.sunDistance, moonRadius: facts.moonRadiusKm,
      moonFromShadow: transposed(sky.moonFrame), earthRadius: facts.earth.opaqueKm, au: facts.sun.auKm,
      nodes, sectors, stretches, ends: shadow.ends, depths: shadow.depths, middleDepth: shadow.middleDepth,
      mapLogs: [map.logLow, map.logRange], mapLongitudes: longitudes(map),
      groundLongitudes: longitudes(ground), widestSurge: ground.surge,
      law: [law.scale, law.incidence, law.emission, law.constant], phases: law.phase, surges: law.surge,
      phaseStep: law.phaseDegrees * degree / (law.phase.length - 1), shadowed,
      moonDistance: view.distance, forward: view.forward, right: view.right, up: view.up,
      middle: frame.middle, pixel: frame.pixel, size: [frame.width, frame.height],
      light: this.bound(0, this.lights[light]), map: this.bound(1, this.map), ground: this.bound(2, this.ground),
    });
  }

  /**
   * Draws the Moon.
   *
   * Given  frame  middle [lunar radii], pixel [lunar radii], width, height [pixels]
   *        look   {exposure, view, around: light of the sky [cd/m²]} or {stops: true}
   */
  draw(sky, view, frame, look) {
    const {gl, facts} = this, table = this.views[look.view];
    this.setUniforms(this.screen, sky, view, frame);
    this.screen.set({
      view: this.bound(3, table ?? this.noView, gl.TEXTURE_3D),
      look: look.stops ? 2 : table ? 1 : look.view === 'Hue-preserving' ? 3 : 0, exposure: look.exposure,
      viewCode: [facts.viewTable.gain, facts.viewTable.stops], viewSize: facts.viewTable.size,
      around: look.stops ? [0, 0, 0] : look.around, fullMoon: look.fullMoon, stopColours: stopColours.flat(), darker,
    });
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, frame.width, frame.height);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  /** Radiance in a picture, or at `places` if given: [pixel × 4], red, green and blue [cd/m²], then V. */
  read(sky, view, frame, {shadowed = true, light = 'seen', places = null} = {}) {
    const {gl} = this, {width, height} = frame;
    this.setUniforms(this.raw, sky, view, frame, {shadowed, light});
    this.raw.set({places: this.bound(3, this.places), atPlaces: Boolean(places)});
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, places ? width : 1, places ? height : 1, 0, gl.RGBA, gl.FLOAT,
      places ?? new Float32Array(4));
    const target = gl.createRenderbuffer();
    gl.bindRenderbuffer(gl.RENDERBUFFER, target);
    gl.renderbufferStorage(gl.RENDERBUFFER, gl.RGBA32UI, width, height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.frame);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER, target);
    gl.viewport(0, 0, width, height);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    const bits = new Uint32Array(width * height * 4);
    gl.readPixels(0, 0, width, height, gl.RGBA_INTEGER, gl.UNSIGNED_INT, bits);
    gl.deleteRenderbuffer(target);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    return new Float32Array(bits.buffer);
  }

  /** Radiance at places on the Moon, given as unit vectors in Moon-fixed axes. */
  readAt(sky, view, directions) {
    const width = Math.min(directions.length, widest), height = Math.ceil(directions.length / widest);
    const places = new Float32Array(4 * width * height);
    directions.forEach((d, i) => places.set(d, 4 * i));
    return this.read(sky, view, {middle: [0, 0], pixel: 1, width, height}, {places});
  }
}
