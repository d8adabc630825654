// SPDX-License-Identifier: Apache-2.0
// Prints the contents of a USD file as read by two readers, as JSON: the prims with their attributes
// as parsed by tinyusdz, and the scene that three.js builds from the file. With `layer`, only the former.
import fs from 'fs';
import {createRequire} from 'module';

const file = process.argv[2];
const node = process;

// tinyusdz is built for browsers: it requires a window and rejects Node.
async function tinyusdz() {
  const wasm = createRequire(import.meta.url).resolve('tinyusdz/tinyusdz.wasm');
  globalThis.window = globalThis;
  globalThis.document = {currentScript: null};
  delete globalThis.process;
  const start = (await import('tinyusdz/tinyusdz.js')).default;
  const module = await start({wasmBinary: fs.readFileSync(wasm), print: () => {}, printErr: () => {}});
  globalThis.process = node;
  delete globalThis.window;
  delete globalThis.document;
  const layer = new module.TinyUSDZLoaderNative();
  if (!layer.loadAsLayerFromBinary(new Uint8Array(fs.readFileSync(file)), file))
    throw new Error(layer.error());
  return layer.layerToString();
}

async function three() {
  const THREE = await import('three');
  const {USDLoader} = await import('three/examples/jsm/loaders/USDLoader.js');
  const bytes = fs.readFileSync(file);
  const content = file.endsWith('.usdc') ? new Uint8Array(bytes).buffer : bytes.toString('utf8');
  const scene = new USDLoader().parse(content);
  scene.updateMatrixWorld(true);
  const found = [];
  scene.traverse((object) => {
    const one = {type: object.type, name: object.name, parent: object.parent?.name ?? '',
                 matrix: object.matrixWorld.elements};
    if (object.isMesh) {
      const box = new THREE.Box3().setFromObject(object, true);
      one.box = [box.min.toArray(), box.max.toArray()];
      one.vertices = object.geometry.attributes.position.count;
    }
    if (object.isLight)
      Object.assign(one, {color: object.color.toArray(), intensity: object.intensity});
    found.push(one);
  });
  return found;
}

const parsed = await tinyusdz();
console.log(JSON.stringify({tinyusdz: parsed, three: node.argv[3] === 'layer' ? [] : await three()}));
