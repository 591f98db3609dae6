// SPDX-License-Identifier: MIT
// node generate_mtlx.mjs FILE.mtlx: MaterialX's own generator makes a fragment shader of OpenGL ES 3 of the file's node graph, and prints it
// with the values of its uniforms, as JSON.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';

const bin = new URL('node_modules/@needle-tools/materialx/bin/', import.meta.url).pathname;
// Its WebAssembly is built for scripts that are no modules.
globalThis.require = createRequire(import.meta.url);
globalThis.__dirname = bin;
const { default: start } = await import(bin + 'JsMaterialXGenShader.js');
const data = readFileSync(bin + 'JsMaterialXGenShader.data.txt');
const mx = await start({
  wasmBinary: readFileSync(bin + 'JsMaterialXGenShader.wasm'),
  getPreloadedPackage: () => data.buffer.slice(data.byteOffset, data.byteOffset + data.byteLength),
});

const generator = mx.EsslShaderGenerator.create(), context = new mx.GenContext(generator), graph = mx.createDocument();
graph.setDataLibrary(mx.loadStandardLibraries(context));
const text = readFileSync(process.argv[2], 'utf8');
const surface = `<surface_unlit name="surface" type="surfaceshader">
  <input name="emission_color" type="color3" nodegraph="eclipse_shadow" output="out" /></surface_unlit></materialx>`;
await mx.readFromXmlString(graph, text.replace('</materialx>', surface));
assert.ok(graph.validate());
const shader = generator.generate('shadow', mx.findRenderableElement(graph), context);
const block = shader.getStage('pixel').getUniformBlocks().PublicUniforms, uniforms = {};
for (let i = 0; i < block.size(); ++i) {
  const port = block.get(i), value = port.getValue()?.getData();
  if (typeof value === 'number') uniforms[port.getVariable()] = value;
  else if (value?.data) uniforms[port.getVariable()] = [...value.data()];
}
console.log(JSON.stringify({ source: shader.getSourceCode('pixel'), uniforms }));
