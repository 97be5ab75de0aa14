// worker-files.js - the module's memory, and the files that it reads, for worker.js and helper.js.
'use strict';

const files = new Map(), missing = new Set(), asked = new Set();
const decoder = new TextDecoder(), encoder = new TextEncoder();
let wasm;

// The memory's buffer changes when it grows.
const bytes = (at, length) => new Uint8Array(wasm.memory.buffer, at, length);
const string = (at, length) => decoder.decode(bytes(at, length).slice());
const cString = at => string(at, new Uint8Array(wasm.memory.buffer, at).indexOf(0));

// Writes a name where the module expects it; returns its address.
function putName(name) {
  const at = wasm.web_name(), letters = encoder.encode(name.slice(0, 200) + '\0');
  bytes(at, letters.length).set(letters);
  return at;
}

function fileSize(at, length) {
  const name = string(at, length), file = files.get(name);
  if (!file) missing.add(name);
  asked.add(name);
  return file ? file.length : -1;
}

function fileRead(name, length, to) {
  const file = files.get(string(name, length));
  bytes(to, file.length).set(file);
}

// Fetches a file that a scene names. Only files below the page's own scenes/ are allowed.
async function fetchFile(name) {
  if (!/^[\w.-]+(\/[\w.-]+)*$/.test(name) || name.includes('..')) return null;
  const answer = await fetch('scenes/' + name).catch(() => null);
  return answer && answer.ok ? new Uint8Array(await answer.arrayBuffer()) : null;
}

// Loads a scene and the files that it names; `extra`: files of the user's, by name. Returns null; or why it cannot be read, each of
// its mistakes with its line below it, as web_mistakes has them.
async function load({name, text, extra}) {
  for (const [other, content] of extra) files.set(other, content);
  files.set(name, encoder.encode(text));
  for (;;) {
    missing.clear();
    asked.clear();
    if (wasm.web_load(putName(name)) === 0) return null;
    if (!missing.size || [...missing].every(file => files.has(file))) return cString(wasm.web_mistakes()) || cString(wasm.web_why());
    for (const file of [...missing]) files.set(file, await fetchFile(file));
  }
}

// Takes over the lights and the camera of another worker.
function takeKept(kept) {
  const at = kept && wasm.web_kept(kept.length);
  if (!at) return false;
  bytes(at, kept.length).set(kept);
  wasm.web_take_kept();
  return true;
}

function applySettings(s) {
  wasm.web_set(s.width, s.height, s.arithmetic, s.view, s.rays, s.integrator, s.samples);
}

// ---- turns ----

const turns = [], channel = new MessageChannel();
channel.port1.onmessage = () => turns.shift()();

// Resolves after all pending messages. A timer would be delayed by at least 4 ms.
const turn = () => new Promise(resolve => { turns.push(resolve); channel.port2.postMessage(0); });
