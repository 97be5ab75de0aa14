// conform-worker.js - compares WebGL 2 with the exact rasteriser, which is in conform.wasm (bench/conform/conform_page.c).
'use strict';

importScripts('webgl.js');

const SHOW_MS = 100; // time between two messages

onmessage = async ({data: [trials, step, seed]}) => {
  const triangles = typeof OffscreenCanvas === 'undefined' ? null : openTriangles();
  let memory, found = '', drawn = 0, shown = 0;

  if (!triangles) return postMessage({why: 'This browser has no WebGL 2 here.'});
  postMessage({driver: triangles.driver});
  const draw = (numbers, count, bytes) => {
    const list = Array.from(new Int32Array(memory.buffer, numbers, count));
    new Uint8Array(memory.buffer).set(triangles.draw(list), bytes);
    drawn++;
    if (performance.now() - shown > SHOW_MS) {
      shown = performance.now();
      postMessage({drawn});
    }
    return 1;
  };
  const say = (text, length) => { found += String.fromCharCode(...new Uint8Array(memory.buffer, text, length)); };
  const {instance} = await WebAssembly.instantiate(await (await fetch('conform.wasm')).arrayBuffer(), {conform: {draw, say}});
  memory = instance.exports.memory;
  const result = instance.exports.conform(trials, step, seed);
  postMessage(result > 1 ? {why: 'WebGL failed.'} : {found, same: result === 0});
};
