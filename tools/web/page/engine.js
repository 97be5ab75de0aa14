// engine.js - the worker that draws, and its helpers: starts them, sends them jobs and events.
import {$, fail, page, stopWorker} from './page.js';
import {text} from './editor.js';

let module, worker, suspends = page.query.get('suspend') !== 'no', ready = false, idle = true, kept = null;
let hear = () => {}, helpers = [], extra = new Map();
const RELEASE = 1, TAP = 2, POINT = 3, SPACE = 32; // as in tia/port.h
let pauses = null, whenPaused = []; // whether the scene will be paused, null: as it is shown; functions to call when it is shown so

export const suspending = () => suspends;

// As many helpers as processors beside the first, at most 7; `workers=N` in the address sets the number of all workers.
const helperCount = () => Math.min(Math.max((+page.query.get('workers') || navigator.hardwareConcurrency || 1) - 1, 0), 7);

function newWorker() {
  const made = new Worker('worker.js');
  made.onerror = error => fail(error.message || 'the worker cannot be started');
  return made;
}

function begin() {
  ready = false;
  worker = newWorker();
  worker.onmessage = ({data}) => receive(data);
  worker.postMessage({module, suspends});
}

// Each helper is joined to the worker by a channel; they are started when a picture first takes long.
function beginHelpers() {
  helpers = Array.from({length: helperCount()}, (_, turn) => {
    const helper = newWorker(), channel = new MessageChannel();
    helper.postMessage({module, helps: {port: channel.port2, turn, of: helperCount()}}, [channel.port2]);
    worker.postMessage({helper: channel.port1}, [channel.port1]);
    return helper;
  });
  document.documentElement.dataset.workers = helpers.length + 1;
}

export function startEngine(compiled, listener) {
  module = compiled;
  hear = listener;
  begin();
}

export const settings = () => {
  const size = $('size').value === 'auto' ? page.scene === 'thesis.tia' && innerWidth >= 600 ? '640x480' : '320x240' : $('size').value;
  const [width, height] = size.split('x').map(Number);
  const plain = $('arithmetic').value === '0';
  return {width, height, arithmetic: +$('arithmetic').value, view: plain ? +$('view').value : 0, rays: plain && $('show-rays').checked,
    integrator: +$('integrator').value, samples: +$('samples').value};
};

// Numbers a change; no picture is complete until the worker has drawn one that shows it.
function outdate() {
  page.change++;
  page.complete = false;
  $('crc').textContent = '\u2026';
}

function ask(job) {
  outdate();
  idle = false;
  kept = job.goesOn ? kept : null;
  pauses = null;
  whenPaused = [];
  worker.postMessage({job: {settings: settings(), ...job}, change: page.change});
}

export const load = () => ({load: {name: page.scene, text: text(), extra}});

// Files of the user's that scenes may name, by name.
export const addFile = (name, bytes) => extra.set(name, bytes);

function replace() {
  stopWorker(worker);
  begin();
}

// If the browser cannot suspend WebAssembly, a worker that draws receives no messages, so another worker replaces it.
export function send(events) {
  if (events.some(event => event.key === SPACE && event.kind !== RELEASE)) {
    pauses = !willPause();
    whenPaused = [];
  }
  if (events.some(event => event.kind !== RELEASE && (event.kind !== POINT || event.drag))) outdate();
  const numbered = {events, change: page.change};
  if (!suspends && !idle && ready) {
    replace();
    worker.postMessage({job: {settings: settings(), ...load(), goesOn: true, kept}, ...numbered});
  } else worker.postMessage(numbered);
  idle = false;
}

export function change(job) {
  if (!page.scene) return;
  if (!suspends && !idle && ready) {
    replace();
    job = {...load(), ...job, kept: job.goesOn ? kept : null};
  }
  ask(job);
}

const willPause = () => pauses === null ? page.frame !== null && page.frame.paused !== 0 : pauses;

// Pauses a scene that plays, and resolves when it stands still. If a key goes on playing before, or another scene begins, it never does.
export async function pause() {
  if (!page.frame || !page.frame.plays || (page.frame.paused && pauses === null)) return;
  if (!willPause()) send([{kind: TAP, key: SPACE}]);
  await new Promise(resolve => whenPaused.push(resolve));
}

function receive(data) {
  if (data.ready) { ready = true; suspends = data.suspends; }
  if (data.idle) idle = true;
  if (data.frame) kept = data.frame.kept || kept;
  if (data.slow && suspends && !helpers.length && helperCount()) beginHelpers();
  hear(data);
  if (data.frame && pauses === (data.frame.paused !== 0) && data.frame.block === 1) pauses = null;
  if (page.frame && page.frame.paused && pauses === null && (page.complete || !page.frame.whole)) whenPaused.splice(0).forEach(resolve => resolve());
}

// Asks a worker of its own for a picture of the lights and the camera that are shown: 16 bits a channel, or a record.
export function order(what) {
  return new Promise((resolve, reject) => {
    const clerk = newWorker();
    clerk.onmessage = ({data}) => {
      stopWorker(clerk);
      data.failed ? reject(new Error(data.failed)) : resolve(data);
    };
    clerk.postMessage({module, order: {settings: settings(), ...load(), kept, ...what}});
  });
}
