// SPDX-License-Identifier: MIT
// node check_glb.mjs FILE.glb: Khronos' validator finds nothing, and three.js puts the Moon's places where they belong.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import validator from 'gltf-validator';
import * as THREE from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { checkPlaces } from './places.mjs';

const bytes = readFileSync(process.argv[2]);
const report = await validator.validateBytes(new Uint8Array(bytes), { maxIssues: 0 });
assert.deepEqual(report.issues.messages, []);  // no error, no warning, not even a hint
const picture = report.info.resources.find(resource => resource.mimeType === 'image/png').image;
assert.equal(picture.width, 2 * picture.height);

// A browser decodes pictures; here only their kind is looked at.
globalThis.self = globalThis;
const kinds = [];
globalThis.createImageBitmap = async blob => {
  kinds.push(blob.type);
  return { width: 2, height: 1, close() {} };
};
const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
const { scene, asset } = await new GLTFLoader().parseAsync(buffer, '');
const { material } = scene.getObjectByName('Moon').getObjectByProperty('isMesh', true);
const luminous = process.argv[2].includes('lin_rec709');  // in cd/m²
assert.equal(material.type, luminous ? 'MeshStandardMaterial' : 'MeshBasicMaterial');  // three's name for unlit
const map = luminous ? material.emissiveMap : material.map;
assert.equal(map.colorSpace, THREE.SRGBColorSpace);
assert.equal(map.wrapS, THREE.RepeatWrapping);
assert.equal(map.wrapT, THREE.ClampToEdgeWrapping);
if (luminous) {
  assert.ok(material.emissiveIntensity > 1 && material.emissiveIntensity < 6000);  // the full Moon has 5000 cd/m²
  assert.equal(material.color.getHex(), 0);
  assert.equal(material.emissive.getHex(), 0xffffff);
}
assert.equal(material.side, THREE.FrontSide);
assert.deepEqual(kinds, ['image/png']);
assert.match(asset.generator, /^coppermoon/);
assert.equal(asset.extras['coppermoon:radius_m'], 1737400);

checkPlaces(scene, latitude => 0.5 - latitude / 180);  // glTF counts v from the picture's top
const camera = new THREE.PerspectiveCamera(30, 1);     // glTF's own looks along -Z, +Y up
camera.position.set(0, 0, 5);
camera.updateMatrixWorld(true);
assert.ok(new THREE.Vector3(1, 0, 0).project(camera).x > 0, '90 degrees east is to the right');
console.log(`${report.info.totalVertexCount} vertices, ${report.info.totalTriangleCount} triangles, no issues`);
