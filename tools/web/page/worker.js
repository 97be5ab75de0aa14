// worker.js - runs the viewer. Provides the functions that the module imports (port/web/web.h): a queue of events, files, pictures.
'use strict';

const ESCAPE = 27, POINT = 3, DRAGGED = 0x200; // as in tia/port.h and port/web/web.h
const files = new Map(), missing = new Set();
const decoder = new TextDecoder(), encoder = new TextEncoder();
let wasm, run, suspends, job = null, busy = false, loaded = false, settings;
let queue = [], wake = null;

// ---- the module's memory, whose buffer changes when it grows ----

const bytes = (at, length) => new Uint8Array(wasm.memory.buffer, at, length);
const string = (at, length) => decoder.decode(bytes(at, length).slice());
const cString = at => string(at, new Uint8Array(wasm.memory.buffer, at).indexOf(0));

// ---- events ----

const turns = [], channel = new MessageChannel();
channel.port1.onmessage = () => turns.shift()();

// Resolves after all pending messages. A timer would be delayed by at least 4 ms.
const turn = () => new Promise(resolve => { turns.push(resolve); channel.port2.postMessage(0); });

async function look() {
  if (!queue.length) await turn();
  return queue.length;
}

function rest(ms) {
  if (queue.length || ms === 0) return 0;
  return new Promise(resolve => {
    const timer = ms > 0 ? setTimeout(() => wake(), ms) : 0;
    wake = () => { clearTimeout(timer); wake = null; resolve(0); };
  });
}

function put(event) {
  const last = queue[queue.length - 1];
  if (last && event.kind === POINT && last.kind === POINT && event.key === last.key && event.drag === last.drag) {
    const adds = event.key === DRAGGED;
    last.x = event.x + (adds ? last.x : 0);
    last.y = event.y + (adds ? last.y : 0);
  } else queue.push(event);
}

function take(at) {
  const event = queue.shift();
  if (!event) return 0;
  const view = new DataView(wasm.memory.buffer, at);
  ['kind', 'key', 'shift', 'drag', 'x', 'y'].forEach((name, i) => view.setInt32(4 * i, event[name] | 0, true));
  // An event from before this worker's start gets the time 0, unknown.
  view.setFloat64(24, event.time ? Math.max(event.time - performance.timeOrigin, 0) * 1000 : 0, true);
  return 1;
}

// ---- pictures ----

const FRAME = ['number', 'crc', 'block', 'done', 'samples', 'spp', 'near', 'far', 'path', 'lights', 'light', 'x', 'y',
  'drawUs', 'keyUs', 'relit', 'kept', 'keptSize', 'plays'];

function expand(at, count) {
  const pixels = new Uint16Array(wasm.memory.buffer, at, count), rgba = new Uint32Array(count);
  for (let i = 0; i < count; i++) {
    const p = pixels[i], r = p >> 11, g = p >> 5 & 63, b = p & 31;
    rgba[i] = 0xff000000 | (b << 3 | b >> 2) << 16 | (g << 2 | g >> 4) << 8 | (r << 3 | r >> 2);
  }
  return rgba.buffer;
}

function show(at, width, height, info) {
  const words = new DataView(wasm.memory.buffer, info), frame = {width, height};
  FRAME.forEach((name, i) => { frame[name] = name.length > 1 && name !== 'light' ? words.getUint32(4 * i, true) : words.getInt32(4 * i, true); });
  frame.kept = suspends ? null : bytes(frame.kept, frame.keptSize).slice();
  const pixels = expand(at, width * height);
  postMessage({frame, pixels}, [pixels]);
}

function lines(at, count) {
  const view = new DataView(wasm.memory.buffer, at), list = [];
  for (let i = 0; i < count; i++)
    list.push([0, 4, 8, 12].map(j => view.getFloat32(20 * i + j, true)).concat(view.getUint32(20 * i + 16, true)));
  postMessage({lines: list});
}

// ---- files ----

function fileSize(at, length) {
  const name = string(at, length), file = files.get(name);
  if (file === undefined) missing.add(name);
  return file ? file.length : -1;
}

// Fetches a file that a scene names. Only files below the page's own scenes/ are allowed.
async function fetchFile(name) {
  if (!/^[\w.-]+(\/[\w.-]+)*$/.test(name) || name.includes('..')) return null;
  const answer = await fetch('scenes/' + name).catch(() => null);
  return answer && answer.ok ? new Uint8Array(await answer.arrayBuffer()) : null;
}

async function load({name, text}) {
  files.set(name, encoder.encode(text));
  for (;;) {
    const at = wasm.web_name(), letters = encoder.encode(name.slice(0, 200) + '\0');
    missing.clear();
    bytes(at, letters.length).set(letters);
    if (wasm.web_load(at) === 0) return null;
    if (!missing.size) return cString(wasm.web_why());
    for (const file of [...missing]) files.set(file, await fetchFile(file));
  }
}

// ---- jobs, one after the other ----

function takeKept(kept) {
  const at = kept && wasm.web_kept(kept.length);
  if (!at) return false;
  bytes(at, kept.length).set(kept);
  wasm.web_take_kept();
  return true;
}

async function prepare(now) {
  settings = now.settings || settings;
  let goesOn = now.goesOn && loaded;
  if (now.load) {
    const error = await load(now.load);
    postMessage(error ? {error, name: now.load.name} : {loaded: now.load.name});
    loaded = loaded || !error;
    goesOn = error !== null || (now.kept ? takeKept(now.kept) : goesOn);
  }
  return goesOn;
}

async function work() {
  if (busy) return;
  const worked = job !== null;
  busy = true;
  while (job) {
    const now = job;
    job = null;
    const goesOn = await prepare(now);
    queue = queue.filter(event => event.key !== ESCAPE);
    if (job || !loaded) continue;
    const s = settings;
    wasm.web_set(s.width, s.height, s.arithmetic, s.view, s.rays, s.integrator, s.samples);
    const status = await run(goesOn ? 1 : 0);
    if (status === 2) postMessage({failed: cString(wasm.web_why())});
    if (status === 1 && queue.length && !job) job = {goesOn: true};
  }
  busy = false;
  if (worked) postMessage({idle: true});
}

const begin = () => work().catch(error => { busy = false; postMessage({failed: String(error.stack || error)}); });

async function start(module, wanted) {
  suspends = wanted && 'Suspending' in WebAssembly && 'promising' in WebAssembly;
  const now = () => performance.now() * 1000;
  const wait = suspends
    ? {look: new WebAssembly.Suspending(look), rest: new WebAssembly.Suspending(rest)}
    : {look: () => queue.length, rest: ms => ms < 0 && !queue.length ? 1 : 0};
  const host = {now, take, show, lines, ...wait, file_size: fileSize,
    file_read: (name, length, to) => { const file = files.get(string(name, length)); bytes(to, file.length).set(file); }};
  wasm = (await WebAssembly.instantiate(module, {host})).exports;
  run = suspends ? WebAssembly.promising(wasm.web_run) : wasm.web_run;
  postMessage({ready: true, suspends});
  begin();
}

onmessage = ({data}) => {
  if (data.module) start(data.module, data.suspends).catch(error => postMessage({failed: String(error)}));
  if (data.job) {
    job = data.job.load || !job ? data.job : {...job, settings: data.job.settings};
    queue = [{kind: 2, key: ESCAPE}];
  }
  if (data.events) {
    data.events.forEach(put);
    if (!busy && loaded) job = job || {goesOn: true};
  }
  if (wake) wake();
  if (wasm) begin();
};
