// worker.js - runs the viewer. Provides the functions that the module imports (port/web/web.h): a queue of events, files, pictures.
'use strict';

importScripts('worker-files.js', 'helper.js');

const ESCAPE = 27, POINT = 3, DRAGGED = 0x200; // as in tia/port.h and port/web/web.h
let run, suspends, job = null, busy = false, loaded = false, settings;
let whole = false, drawn = ''; // the last picture is complete; its settings
let change = 0, settled = true; // number of the page's last change; the page knows that the last picture shows it
let queue = [], wake = null;

// ---- events ----

async function look() {
  if (!queue.length) await turn();
  return queue.length;
}

function rest(ms) {
  if (queue.length || ms === 0) return 0;
  if (whole && !settled) {
    settled = true;
    postMessage({unchanged: true, change});
  }
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
  'drawUs', 'keyUs', 'relit', 'kept', 'keptSize', 'plays', 'paused', 'time', 'copied'];

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
  frame.kept = bytes(frame.kept, frame.keptSize).slice();
  whole = frame.block === 1 && frame.samples >= frame.spp;
  settled = whole && !queue.length;
  Object.assign(frame, {whole, settled, change});
  const pixels = expand(at, width * height);
  postMessage({frame, pixels}, [pixels]);
}

function lines(at, count) {
  const view = new DataView(wasm.memory.buffer, at), list = [];
  for (let i = 0; i < count; i++)
    list.push([0, 4, 8, 12].map(j => view.getFloat32(20 * i + j, true)).concat(view.getUint32(20 * i + 16, true)));
  postMessage({lines: list});
}

// ---- helpers ----

const helpers = [];
let scene = null, number = 0, generation = 0, shared = null;

// Asks the helpers for rows of a frame that takes long, or for parts of its samples (struct web_share); 0: no longer.
function share(at) {
  generation++;
  shared = null;
  if (!suspends) return;
  if (at) {
    const view = new DataView(wasm.memory.buffer, at), word = i => view.getUint32(4 * i, true);
    shared = {kept: bytes(word(0), word(1)).slice(), pixels: word(2), have: word(3), samples: word(4), width: settings.width};
    if (!helpers.length) postMessage({slow: true});
  }
  helpers.forEach(askHelper);
}

function askHelper(helper) {
  helper.postMessage({task: shared && {generation, kept: shared.kept, samples: shared.samples, parts: !shared.pixels, settings, load: scene, number}});
}

function takeRows({y, count, pixels}) {
  new Uint16Array(wasm.memory.buffer, shared.pixels + 2 * y * shared.width, pixels.length).set(pixels);
  bytes(shared.have + y, count).fill(1);
}

function takeSums({y, sample, sums}) {
  bytes(wasm.web_part_sums(), sums.length).set(sums);
  wasm.web_part_done(y, sample);
}

// Gives the next part of the samples to a helper (struct part).
function givePart(helper) {
  const at = wasm.web_part(), view = new DataView(wasm.memory.buffer, at, at && 12), word = i => view.getUint32(4 * i, true);
  if (at) helper.postMessage({part: {y: word(0), count: word(1), sample: word(2)}});
}

// Takes what a helper has drawn; it wants as many parts as it says.
function receive(helper, data) {
  if (data.generation !== generation || !shared) return;
  if (data.pixels) takeRows(data);
  if (data.sums) takeSums(data);
  for (let i = 0; i < data.wants; i++) givePart(helper);
}

function addHelper(port) {
  port.onmessage = ({data}) => {
    if (!data.ready) return receive(port, data);
    helpers.push(port);
    if (shared) askHelper(port);
  };
}

// ---- jobs, one after the other ----

// Returns true if the viewer continues with its lights and camera; null if nothing is to be drawn: the text has a mistake, and the
// picture of the last one without is complete.
async function prepare(now) {
  settings = now.settings || settings;
  let goesOn = now.goesOn && loaded;
  if (now.load) {
    const error = await load(now.load);
    if (!error) { scene = now.load; number++; }
    postMessage(error ? {error, name: now.load.name} : {loaded: now.load.name});
    loaded = loaded || !error;
    if (error && whole && !now.kept && drawn === JSON.stringify(settings)) return null;
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
    if (goesOn === null) postMessage({unchanged: true, change});
    if (job || !loaded || goesOn === null) continue;
    whole = false;
    drawn = JSON.stringify(settings);
    applySettings(settings);
    const status = await run(goesOn ? 1 : 0);
    if (status === 2) postMessage({failed: cString(wasm.web_why())});
    if (status === 1 && queue.length && !job) job = {goesOn: true};
  }
  busy = false;
  if (worked) postMessage({idle: true});
}

const begin = () => work().catch(error => { busy = false; postMessage({failed: String(error.stack || error)}); });

// ---- start ----

async function instantiate(module, waits) {
  const now = () => performance.now() * 1000;
  const host = {now, take, show, lines, share, ...waits, file_size: fileSize, file_read: fileRead};
  wasm = (await WebAssembly.instantiate(module, {host})).exports;
}

async function start(module, wanted) {
  suspends = wanted && 'Suspending' in WebAssembly && 'promising' in WebAssembly;
  await instantiate(module, suspends
    ? {look: new WebAssembly.Suspending(look), rest: new WebAssembly.Suspending(rest)}
    : {look: () => queue.length, rest: ms => ms < 0 && !queue.length ? 1 : 0});
  run = suspends ? WebAssembly.promising(wasm.web_run) : wasm.web_run;
  postMessage({ready: true, suspends});
  begin();
}

// A worker that only draws rows: for another worker, or for a file.
async function startRows(data) {
  await instantiate(data.module, {look: () => 0, rest: () => 1});
  if (data.helps) help(data.helps);
  else await fulfil(data.order);
}

onmessage = ({data}) => {
  const failed = error => postMessage({failed: error.message || String(error)});
  if (data.helps || data.order) { startRows(data).catch(failed); return; }
  if (data.module) start(data.module, data.suspends).catch(failed);
  if (data.helper) addHelper(data.helper);
  if (data.change) { change = data.change; settled = false; }
  if (data.job) {
    job = data.job.load || !job ? data.job : {...job, settings: data.job.settings};
    queue = [{kind: 2, key: ESCAPE}];
  }
  if (data.events) {
    data.events.forEach(put);
    if (!busy && loaded) job = job || {goesOn: true};
  }
  if (wake) wake();
  if (run) begin();
};
