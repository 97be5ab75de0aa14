// input.js - keys and the pointer on the picture.
import {$, page} from './page.js';
import {send, suspending} from './engine.js';
import {text} from './editor.js';
import {placeLight} from './picture.js';

const PRESS = 0, RELEASE = 1, TAP = 2, POINT = 3, DRAGGED = 0x200; // as in tia/port.h and port/web/web.h
const KEYS = {ArrowLeft: 0x100, ArrowRight: 0x101, ArrowUp: 0x102, ArrowDown: 0x103, PageUp: 0x104, PageDown: 0x105, Home: 0x106,
  Tab: 9, ' ': 32, '=': 43, _: 45};
const picture = $('picture'), held = new Map();
let early = []; // keys that were pressed before there was a scene

// Keys of the scene that set lights.
export const bindings = () => [...text().matchAll(/^\s*key\s+(\S)\s/gm)].map(match => match[1]);

// ---- keys ----

const code = key => KEYS[key] || (key.length === 1 && key >= ' ' && key <= '~' ? key.toLowerCase().charCodeAt(0) : 0);

// Returns the number of the light that a key of the scene sets; undefined for other keys.
const lightOf = key => (text().match(new RegExp(`^\\s*key\\s+${key.replace(/\W/g, '\\$&')}\\s+light\\s+(\\d+)`, 'm')) || [])[1];

// Keeps account of what keys have changed, for checksums and records: page.pose, page.eye and page.technique.
function follow(key, shift) {
  const light = lightOf(key), last = page.pose ? page.pose.slice(-1) : '-';
  if (light !== undefined) {
    if (page.pose === null) page.pose = page.frame && page.frame.lights > 1 ? null : key;
    else page.pose = (last === '-' || lightOf(last) === light ? page.pose.slice(0, -1) : page.pose) + key;
  } else if (key === 'Home') page.eye = 'home';
  else if (key === 't') page.technique = 'another';
  else if ((shift && key in KEYS) || 'hjkl+-=_'.includes(key)) page.eye = 'moved';
  else if (key !== 'Tab' && key !== ' ') page.pose = null;
}

export function press(key, shift, time, repeat) {
  const value = code(key);
  if (!value) return;
  if (!page.frame && !page.scene) { early.push(key); return; }
  follow(key, shift);
  if (!suspending()) send([{kind: TAP, key: value, shift, time}]);
  else if (!repeat) {
    held.set(key, value);
    send([{kind: PRESS, key: value, shift, time}]);
  }
}

export function release(key) {
  if (held.delete(key)) send([{kind: RELEASE, key: code(key)}]);
}

export function releaseAll() { [...held.keys()].forEach(release); }

function choose(select, step) {
  const count = select.options.length;
  select.selectedIndex = (select.selectedIndex + step + count) % count;
  select.dispatchEvent(new Event('change'));
}

function onKey(event) {
  const {key} = event, here = picture.contains(event.target);
  if (event.ctrlKey || event.metaKey || event.altKey || key === 'Tab' || (!here && event.target !== document.body)) return;
  if (event.target === $('light') && (key === ' ' || key === 'Enter')) return;
  if (!here && key in KEYS) return;
  if (!bindings().includes(key)) {
    if (key === 'n' || key === 'p') return choose($('scene'), key === 'n' ? 1 : -1);
    if (key === 'v') return $('view').disabled ? undefined : choose($('view'), 1);
    if (key === '?') { $('help').open = !$('help').open; return; }
  }
  if (code(key)) event.preventDefault();
  press(key, event.shiftKey, performance.timeOrigin + event.timeStamp, event.repeat);
}

// ---- the pointer ----

const part = (value, from, size) => Math.min(Math.max(Math.round((value - from) / size * 65536), 0), 65535);

function point(event, drags) {
  const box = picture.getBoundingClientRect();
  send([{kind: POINT, drag: drags ? 1 : 0, x: part(event.clientX, box.left, box.width), y: part(event.clientY, box.top, box.height)}]);
}

picture.addEventListener('pointerdown', event => {
  if (event.target === $('light') || !event.isPrimary || event.button) return;
  page.drag = 'eye';
  picture.setPointerCapture(event.pointerId);
  point(event, true);
});
picture.addEventListener('pointermove', event => {
  if (!event.isPrimary || page.drag === 'light') return;
  if (page.drag === 'eye') page.eye = 'moved';
  if (page.drag === 'eye' || $('show-rays').checked) point(event, page.drag === 'eye');
});
for (const over of ['pointerup', 'pointercancel'])
  picture.addEventListener(over, event => { if (page.drag === 'eye') point(event, false); page.drag = null; });
picture.addEventListener('contextmenu', event => { if (page.drag) event.preventDefault(); });

let last = null;
$('light').addEventListener('pointerdown', event => {
  page.drag = 'light';
  last = event;
  $('light').setPointerCapture(event.pointerId);
});
$('light').addEventListener('pointermove', event => {
  if (page.drag !== 'light') return;
  const box = picture.getBoundingClientRect(), inside = v => Math.min(Math.max(v, .03), .97) * 100 + '%';
  page.pose = null;
  $('light').style.left = inside((event.clientX - box.left) / box.width);
  $('light').style.top = inside((event.clientY - box.top) / box.height);
  send([{kind: POINT, key: DRAGGED, drag: 1, time: performance.timeOrigin + event.timeStamp,
    x: Math.round((event.clientX - last.clientX) / box.width * 65536), y: Math.round((event.clientY - last.clientY) / box.height * 65536)}]);
  last = event;
});
for (const over of ['pointerup', 'pointercancel']) $('light').addEventListener(over, () => { page.drag = null; placeLight(); });

// ---- buttons ----

// Presses the keys that were typed before there was a scene, and a scene's first key if it has no other light.
export function pressEarly() {
  const own = bindings();
  if (own.length && !/^\s*light\b/m.test(text())) early.unshift(own[0]);
  for (const key of early.splice(0)) { press(key, false, 0); release(key); }
}

export function startInput() {
  addEventListener('keydown', onKey);
  addEventListener('keyup', event => release(event.key));
  addEventListener('blur', releaseAll);
  document.querySelector('.keys').addEventListener('pointerdown', event => {
    const button = event.target.closest('[data-key]');
    if (!button || !event.isPrimary) return;
    press(button.dataset.key, false, performance.timeOrigin + event.timeStamp, false);
    button.onpointerup = button.onpointercancel = button.onpointerleave = () => release(button.dataset.key);
  });
  // A button that is clicked from the keyboard types its key, but cannot hold it.
  document.querySelector('.keys').addEventListener('click', event => {
    const button = event.target.closest('[data-key]');
    if (!button || event.detail) return;
    press(button.dataset.key, false, 0, false);
    release(button.dataset.key);
  });
}
