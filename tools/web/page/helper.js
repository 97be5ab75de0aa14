// helper.js - a worker that draws rows of another worker's picture: to share the work, or for a file. worker.js imports it.
'use strict';

const CHUNK = 4; // rows of a message: few, so that two workers seldom draw the same row
const AHEAD = 2; // parts of samples that a helper has, so that it need not wait for the next one
const SUM = 24; // bytes of struct tia_sum
let task = null, parts = [], wakeUp = () => {}, working = false, known = null;

// Makes the picture of a task ready to be drawn; throws if that fails.
async function prepareRows({settings, load: scene, number, kept, samples}, colours) {
  if (number === undefined || known !== number) {
    const why = await load(scene);
    if (why) throw new Error(why);
    known = number;
  }
  applySettings(settings);
  if (!takeKept(kept) || wasm.web_rows_begin(colours ? 1 : 0, samples || 0)) throw new Error(cString(wasm.web_why()) || 'the picture is another one');
}

// Returns where the module has drawn; throws if it has not.
function drawnAt(at) {
  if (!at) throw new Error(cString(wasm.web_why()));
  return at;
}

const rows = (y, count, width) => new Uint16Array(wasm.memory.buffer, drawnAt(wasm.web_rows(y, count)), width * count).slice();

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

// Draws the parts of samples that it is given, until the task is replaced.
async function shareSamples(now, {port}) {
  await prepareRows(now, false);
  port.postMessage({generation: now.generation, wants: AHEAD});
  while (task === now) {
    const part = parts.shift();
    if (part) {
      const {y, count, sample} = part, sums = bytes(drawnAt(wasm.web_sums(y, count, sample)), now.settings.width * count * SUM).slice();
      port.postMessage({generation: now.generation, y, sample, sums, wants: 1}, [sums.buffer]);
      await turn();
    } else await new Promise(resolve => { wakeUp = resolve; });
  }
}

function help(place) {
  const begin = async () => {
    if (working) return;
    working = true;
    for (let now = task; now; now = task) {
      await (now.parts ? shareSamples : shareRows)(now, place).catch(error => console.warn(String(error)));
      if (task === now) task = null;
    }
    working = false;
  };
  place.port.onmessage = ({data}) => {
    if (data.part) parts.push(data.part);
    else { task = data.task; parts = []; }
    wakeUp();
    begin();
  };
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
