// SPDX-License-Identifier: MIT
// Decodes the page's arrays of data, which the C++ class PageArrays wrote.

async function inflated(base64) {
  const binary = atob(base64);
  const bytes = Uint8Array.from(binary, (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Response(stream).arrayBuffer();
}

/** Decodes bytes that were stored as differences from the previous byte in their row. */
function summed(bytes, width) {
  const all = new Uint8Array(bytes.length);
  for (let i = 0; i < bytes.length; ++i) all[i] = bytes[i] + (i % width === 0 ? 0 : all[i - 1]);
  return all;
}

/**
 * Given    base64  the arrays as text;  index  where each array is
 * Returned {name: {shape, data}}, with data a Float32Array, a Uint8Array or a string
 */
export async function readArrays(base64, index) {
  const buffer = await inflated(base64);
  const arrays = {};
  for (const [name, {kind, shape, at}] of Object.entries(index)) {
    const size = shape.reduce((a, b) => a * b, 1);
    const bytes = () => new Uint8Array(buffer, at, size);
    const readers = {
      f32: () => new Float32Array(buffer, at, size),
      u8: () => summed(bytes(), shape[shape.length - 1]),
      text: () => new TextDecoder().decode(bytes()),
    };
    arrays[name] = {shape, data: readers[kind]()};
  }
  return arrays;
}

/** The lines of a text, each split at tabs. */
export function rowsOf(text) {
  return text.trimEnd().split('\n').map((line) => line.split('\t'));
}
