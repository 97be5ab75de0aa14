// web.mjs - measures the time of a picture in the page's WebAssembly module: node bench/web.mjs SCENE WxH [ARITHMETIC [MODULE]]
// Compare it with the time of build/tia for the same picture. node compiles WebAssembly as Chromium does.
import fs from 'node:fs';
import path from 'node:path';

const [scene, size, arithmetic = '0', module = 'build/web/tia.wasm'] = process.argv.slice(2);
const [width, height] = size.split('x').map(Number);
let wasm, crc, drawn;
const bytes = (at, length) => new Uint8Array(wasm.memory.buffer, at, length);
const file = (at, length) => path.join(path.dirname(scene), Buffer.from(bytes(at, length)).toString());
const host = {
  now: () => performance.now() * 1000, take: () => 0, look: () => 0, rest: () => 1, lines: () => {}, share: () => {},
  file_size: (at, length) => fs.existsSync(file(at, length)) ? fs.statSync(file(at, length)).size : -1,
  file_read: (at, length, to) => { const text = fs.readFileSync(file(at, length)); bytes(to, text.length).set(text); },
  show: (at, w, h, info) => {
    const words = new DataView(wasm.memory.buffer, info);
    if (words.getUint32(8, true) === 1) { crc = words.getUint32(4, true); drawn = words.getUint32(52, true); }
  },
};
wasm = (await WebAssembly.instantiate(fs.readFileSync(module), {host})).instance.exports;
const name = Buffer.from(path.basename(scene) + '\0'), at = wasm.web_name();
bytes(at, name.length).set(name);
if (wasm.web_load(at) !== 0) throw new Error('the scene cannot be read');
wasm.web_set(width, height, Number(arithmetic), 0, 0, -1, 0);
const cpu = process.cpuUsage();
wasm.web_run(0);
const {user} = process.cpuUsage(cpu);
console.log(`${scene} ${size} ${crc.toString(16).padStart(8, '0')} ${Math.round(user / 1000)} ms of the processor, drawn in ${Math.round(drawn / 1000)} ms`);
