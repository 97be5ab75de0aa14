// helper.js - a worker that draws rows of another worker's picture: to share the work, or for a file. worker.js imports it.
'use strict';

const CHUNK = 4; // rows of a message: few, so that two workers seldom draw the same row
let task = null, working = false, known = null;

// Makes the picture of a task ready to be drawn; throws if that fails.
async function prepareRows({settings, load: scene, number, kept}, colours) {
  if (number === undefined || known !== number) {
    const why = await load(scene);
    if (why) throw new Error(why);
    known = number;
  }
  applySettings(settings);
  if (!takeKept(kept) || wasm.web_rows_begin(colours ? 1 : 0)) throw new Error(cString(wasm.web_why()) || 'the picture is another one');
}

function rows(y, count, width) {
  const at = wasm.web_rows(y, count);
  if (!at) throw new Error(cString(wasm.web_why()));
  return new Uint16Array(wasm.memory.buffer, at, width * count).slice();
}

// ---- sharing ----

// Draws every n-th chunk of rows from the bottom up, until the task is done or replaced.
async function shareRows(now, {port, turn: mine, of}) {
  const {width, height} = now.settings;
  await prepareRows(now, false);
  for (let end = height - mine * CHUNK; end > 0 && task === now; end -= of * CHUNK) {
    const y = Math.max(end - CHUNK, 0), pixels = rows(y, end - y, width);
    port.postMessage({generation: now.generation, y, count: end - y, pixels}, [pixels.buffer]);
    await turn();
  }
}

function help(place) {
  const begin = async () => {
    if (working) return;
    working = true;
    for (let now = task; now; now = task) {
      await shareRows(now, place).catch(error => console.warn(String(error)));
      if (task === now) task = null;
    }
    working = false;
  };
  place.port.onmessage = ({data}) => { task = data.task; begin(); };
  place.port.postMessage({ready: true});
}

// ---- files ----

function recordOf({picture, options}) {
  const check = status => { if (status) throw new Error(cString(wasm.web_why())); };
  const names = [...asked];
  check(wasm.web_record_begin(putName(picture)));
  for (const name of names) check(wasm.web_record_file(putName(name)));
  for (const option of options) check(wasm.web_record_option(putName(option)));
  const at = wasm.web_record_end();
  check(!at);
  return cString(at);
}

async function fulfil(order) {
  const {width, height} = order.settings;
  await prepareRows(order, order.colours);
  if (order.record) return postMessage({record: recordOf(order.record)});
  for (let y = 0; y < height; y += CHUNK) rows(y, Math.min(CHUNK, height - y), width);
  const colours = new Uint16Array(wasm.memory.buffer, wasm.web_colours(), 3 * width * height).slice();
  postMessage({width, height, colours}, [colours.buffer]);
}
