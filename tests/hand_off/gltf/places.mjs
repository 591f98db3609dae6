// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import * as THREE from 'three';

/// Rays from outside meet the Moon's front at places of the texture that belong there.
export function checkPlaces(scene, vOfLatitude) {
  scene.updateMatrixWorld(true);
  for (const latitude of [-80, -45.3, 0.2, 30, 75])
    for (const longitude of [-170.1, -90.2, -20, 0.1, 45, 90.3, 179]) {
      const [b, l] = [latitude, longitude].map(THREE.MathUtils.degToRad);
      const place = new THREE.Vector3(Math.cos(b) * Math.sin(l), Math.sin(b), Math.cos(b) * Math.cos(l));
      const ray = new THREE.Raycaster(place.clone().multiplyScalar(5), place.clone().negate());
      const [hit] = ray.intersectObject(scene, true);
      assert.ok(Math.abs(hit.distance - 4) < 1e-3, `radius at ${latitude}, ${longitude}: ${5 - hit.distance}`);
      assert.ok(Math.abs(hit.uv.x - (0.5 + longitude / 360)) < 1e-3, `u at ${latitude}, ${longitude}: ${hit.uv.x}`);
      assert.ok(Math.abs(hit.uv.y - vOfLatitude(latitude)) < 1e-3, `v at ${latitude}, ${longitude}: ${hit.uv.y}`);
    }
}
