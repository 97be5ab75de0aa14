// page.js - what the modules of the page share: its elements, its state, and its voice for screen readers.

export const $ = id => document.getElementById(id);

// scene: name of the scene; pose: the keys that have set its lights, '-' for none, null if something else has moved one; eye: 'home' or
// 'moved'; technique: 'own' or 'another', for shadows; change: number of the last change, by a key or a setting; complete: the
// picture shows it; frame: data of the last picture (worker.js); gallery: gallery.json.
export const page = {scene: null, pose: '-', eye: 'home', technique: 'own', change: 0, complete: false, frame: null, gallery: null, query: new URLSearchParams(location.search)};

let saying = 0;
export function say(text) {
  clearTimeout(saying);
  saying = setTimeout(() => { $('status').textContent = text; }, 500);
}

export function fail(text) {
  $('verdict').className = 'bad';
  $('verdict').textContent = text;
  say(text);
}

// A short notice beside the buttons of the text, spoken too.
export function notice(text) {
  $('notice').textContent = text;
  say(text);
}

export function element(tag, properties, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

// Stops a worker for good. A script that it was still loading fails after that, which is nobody's error.
export function stopWorker(worker) {
  worker.onmessage = null;
  worker.onerror = event => event.preventDefault();
  worker.terminate();
}
