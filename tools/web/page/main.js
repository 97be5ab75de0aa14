// main.js - the page: compiles the module, starts the parts, and passes on what the worker says.
import {$, fail, page} from './page.js';
import {change, startEngine} from './engine.js';
import {showMistakes, startEditor} from './editor.js';
import {startCompletions} from './complete.js';
import {clearRays, drawRays, show, showAgain, updateNote} from './picture.js';
import {startFiles} from './files.js';
import {startInput} from './input.js';
import {edited, showThumbnails, startScenes} from './scenes.js';
import {startOffline} from './offline.js';
import {loadReference, startReference} from './reference.js';

function hear(data) {
  if (data.frame) show(data.frame, data.pixels);
  if (data.unchanged) showAgain(data.change);
  if (data.lines) drawRays(data.lines);
  if (data.loaded) showMistakes(null, page.scene);
  if (data.error) showMistakes(data.error, page.scene);
  if (data.failed) fail(data.failed);
  if (data.frame || data.error || data.failed) showThumbnails();
  if (page.complete && !page.first) {
    page.first = performance.now();
    $('picture').dataset.first = Math.round(page.first);
    startOffline();
  }
}

async function compile() {
  const answer = await fetch('tia.wasm');
  return answer.headers.get('content-type') === 'application/wasm' ? WebAssembly.compileStreaming(answer)
    : WebAssembly.compile(await answer.arrayBuffer());
}

function listen() {
  startInput();
  startEditor(edited);
  startCompletions();
  startReference();
  startFiles();
  for (const id of ['view', 'arithmetic', 'integrator', 'samples', 'size', 'show-rays'])
    $(id).addEventListener('change', () => { clearRays(); updateNote(); change({goesOn: true}); });
}

async function start() {
  listen();
  const size = page.query.get('size');
  if ([...$('size').options].some(option => option.value === size)) $('size').value = size;
  $('rays').width = 1280;
  $('rays').height = 960;
  const [gallery, module] = await Promise.all([fetch('gallery.json').then(answer => answer.json()), compile()]);
  page.gallery = gallery;
  $('version').textContent = `tia ${gallery.version}.`;
  startEngine(module, hear);
  loadReference();
  await startScenes();
  $('picture').focus({preventScroll: true});
}

start().catch(error => fail(String(error)));
