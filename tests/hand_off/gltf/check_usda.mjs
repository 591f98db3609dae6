// SPDX-License-Identifier: MIT
// node check_usda.mjs FILE.usda: two readers of USD that are not Pixar's, tinyusdz (C++) and three.js, find the mesh,
// the texture's places on it, and the material.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { USDLoader } from 'three/examples/jsm/loaders/USDLoader.js';
import { checkPlaces } from './places.mjs';

const bytes = readFileSync(process.argv[2]);

// A browser loads the texture; here its name is enough.
const asked = [];
globalThis.document = {
  createElementNS: () => ({ addEventListener() {}, removeEventListener() {}, set src(name) { asked.push(name); } }),
};
const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
checkPlaces(new USDLoader().parse(buffer), latitude => 0.5 + latitude / 180);  // USD counts t from the south
assert.deepEqual(asked, ['moon_lin_rec709.exr']);

// Its WebAssembly is built for browsers.
process.type = 'renderer';
globalThis.window = globalThis;
const { default: start } = await import('tinyusdz/tinyusdz.js');
const code = readFileSync(new URL('node_modules/tinyusdz/tinyusdz.wasm', import.meta.url));
const { TinyUSDZLoaderNative } = await start({
  instantiateWasm(imports, done) {
    WebAssembly.instantiate(code, imports).then(made => done(made.instance, made.module));
    return {};
  },
});
const usd = new TinyUSDZLoaderNative();
assert.ok(usd.loadFromBinary(new Uint8Array(bytes), 'moon.usda'), usd.error());
assert.equal(usd.numMeshes(), 1);
const mesh = usd.getMesh(0), material = usd.getMaterial(0), image = usd.getImage(usd.getTexture(0).textureImageId);
assert.equal(mesh.absPath, '/Moon/Surface');
assert.equal(usd.getDefaultRootNode().primName, 'Moon');
assert.deepEqual(material.diffuseColor, [0, 0, 0]);
assert.deepEqual(material.specularColor, [0, 0, 0]);
assert.equal(material.emissiveColorTextureId, 0);
assert.equal(usd.getTexture(0).wrapS, 'repeat');
assert.equal(usd.getTexture(0).wrapT, 'clamp_to_edge');
assert.equal(image.uri, './moon_lin_rec709.exr');
assert.equal(image.usdColorSpace, 'raw');

const layer = new TinyUSDZLoaderNative();
assert.ok(layer.loadAsLayerFromBinary(new Uint8Array(bytes), 'moon.usda'), layer.error());
const text = layer.layerToString();
assert.match(text, /upAxis = "Y"/);
assert.match(text, /metersPerUnit = 1\b/);
assert.match(text, /float radius_m = 1737400\b/);
assert.match(text, /token outputs:mtlx:surface.connect = <\/Moon\/Looks\/Moonlight\/MaterialX.outputs:out>/);
assert.match(text, /asset inputs:file = @.\/moon_lin_rec709.exr@ \(\s*colorSpace = "lin_rec709_scene"\s*\)/);
console.log(`${mesh.points.length / 3} points, ${mesh.faceVertexCounts.length} faces`);
