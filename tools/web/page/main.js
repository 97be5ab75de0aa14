// main.js - the page: sends the user's choices, keys and pointer movements to the worker, and shows the pictures and errors that come back.
'use strict';

const $ = id => document.getElementById(id);
const PRESS = 0, RELEASE = 1, TAP = 2, POINT = 3, DRAGGED = 0x200; // as in tia/port.h and port/web/web.h
const KEYS = {ArrowLeft: 0x100, ArrowRight: 0x101, ArrowUp: 0x102, ArrowDown: 0x103, PageUp: 0x104, PageDown: 0x105, Home: 0x106,
  Tab: 9, ' ': 32, '=': 43, _: 45};
const RAYS = [['#fff', 'primary'], ['#ff0', 'reflected'], ['#0ff', 'refracted'], ['#c6c3c6', 'past an opacity'],
  ['#0f0', 'light arrives'], ['#f00', 'light does not'], ['#f0f', 'normal']];
const ERRORS = [['#ffff00', 'one level apart'], ['#ff0000', 'more'], ['#00ffff', 'another path']];
const picture = $('picture'), canvas = $('canvas'), context = canvas.getContext('2d', {willReadFrequently: true});
const query = new URLSearchParams(location.search);
const texts = new Map(); // texts of scenes by name, as they were fetched
let gallery, module, worker, suspends = query.get('suspend') !== 'no', ready = false, idle = true;
let scene = null, pose = '-', frame = null, kept = null, held = new Map(), drag = null;
let early = []; // keys that were pressed before there was a scene

// ---- the worker ----

function begin() {
  ready = false;
  worker = new Worker('worker.js');
  worker.onmessage = ({data}) => hear(data);
  worker.onerror = error => fail(error.message || 'the worker cannot be started');
  worker.postMessage({module, suspends});
}

const settings = () => {
  const size = $('size').value === 'auto' ? scene === 'thesis.tia' && innerWidth >= 600 ? '640x480' : '320x240' : $('size').value;
  const [width, height] = size.split('x').map(Number);
  const plain = $('arithmetic').value === '0';
  return {width, height, arithmetic: +$('arithmetic').value, view: plain ? +$('view').value : 0, rays: plain && $('show-rays').checked,
    integrator: +$('integrator').value, samples: +$('samples').value};
};

function ask(job) {
  idle = false;
  kept = job.goesOn ? kept : null;
  worker.postMessage({job: {settings: settings(), ...job}});
}

const load = () => ({load: {name: scene, text: $('text').value}});

// If the browser cannot suspend WebAssembly, a worker that draws receives no messages, so another worker replaces it.
function send(events) {
  if (!suspends && !idle && ready) {
    worker.terminate();
    begin();
    worker.postMessage({job: {settings: settings(), ...load(), goesOn: true, kept}, events});
  } else worker.postMessage({events});
  idle = false;
}

function change(job) {
  if (!scene) return;
  if (!suspends && !idle && ready) {
    worker.terminate();
    begin();
    job = {...load(), ...job, kept: job.goesOn ? kept : null};
  }
  ask(job);
}

function fail(text) {
  $('verdict').className = 'bad';
  $('verdict').textContent = text;
  say(text);
}

function hear(data) {
  if (data.ready) { ready = true; suspends = data.suspends; }
  if (data.idle) idle = true;
  if (data.frame) show(data.frame, data.pixels);
  if (data.lines) drawRays(data.lines);
  if (data.loaded) showError(null);
  if (data.error) showError(data.error);
  if (data.failed) fail(data.failed);
}

// ---- pictures ----

let saying = 0;
function say(text) {
  clearTimeout(saying);
  saying = setTimeout(() => { $('status').textContent = text; }, 500);
}

const ms = us => us < 9950 ? (us / 1000).toFixed(1) + ' ms' : us < 1e6 ? Math.round(us / 1000) + ' ms' : (us / 1e6).toFixed(1) + ' s';
const hex = crc => crc.toString(16).padStart(8, '0');

// Returns the known checksum of this picture; undefined if there is none.
function pinned() {
  const s = settings(), edited = texts.get(scene) !== $('text').value;
  if (edited || pose === null || (frame && frame.plays) || s.arithmetic || s.view || s.rays || s.integrator !== -1 || s.samples) return undefined;
  return gallery.pinned[`${scene.replace('.tia', '')} ${pose} ${s.width}x${s.height}`];
}

function judge(crc) {
  const known = pinned(), verdict = $('verdict');
  $('pinned').textContent = known || '-';
  verdict.className = known ? known === crc ? 'good' : 'bad' : '';
  if ($('arithmetic').value === '2')
    verdict.textContent = `${frame.near + frame.far + frame.path} of ${frame.width * frame.height} pixels differ: ` +
      `${frame.near} by a level, ${frame.far} by more, ${frame.path} on another path`;
  else
    verdict.textContent = !known ? frame.plays ? 'it plays: no checksum is pinned' : 'no checksum is pinned for this picture'
      : known === crc ? '\u2713 the same bits as everywhere' : '\u2717 other bits than the pinned ones';
  return known ? known === crc ? 'checksum agrees with the pinned one' : 'checksum differs from the pinned one' : '';
}

function show(now, pixels) {
  const complete = now.block === 1 && (now.spp === 0 || now.samples >= now.spp);
  frame = now;
  kept = now.kept || kept;
  if (canvas.width !== now.width || canvas.height !== now.height) {
    canvas.width = now.width;
    canvas.height = now.height;
  }
  context.putImageData(new ImageData(new Uint8ClampedArray(pixels), now.width, now.height), 0, 0);
  $('progress').value = now.block > 1 ? now.done / 65536 : now.spp ? now.samples / now.spp : 1;
  $('time').textContent = now.block > 1 ? '\u2026' : now.spp ? `${now.samples} of ${now.spp} samples` : ms(now.drawUs);
  if (now.keyUs) $('latency').textContent = ms(now.keyUs);
  $('crc').textContent = complete ? hex(now.crc) : '\u2026';
  if (complete) say(`${scene} drawn, CRC-32 ${hex(now.crc)}, ${judge(hex(now.crc))}`);
  if (complete) picture.dataset.complete = `${scene} ${hex(now.crc)}`;
  else { $('pinned').textContent = pinned() || '-'; $('verdict').textContent = '\u2026'; $('verdict').className = ''; }
  placeLight();
  $('next-light').hidden = now.lights < 2;
  $('pause').hidden = !now.plays;
  updateNote();
}

function placeLight() {
  if (!frame) return;
  const light = $('light');
  light.hidden = frame.light < 0;
  if (light.hidden || drag) return;
  const inside = v => Math.min(Math.max(v / 65536, .03), .97), x = inside(frame.x), y = inside(frame.y);
  light.style.left = 100 * x + '%';
  light.style.top = 100 * y + '%';
  light.classList.toggle('outside', x !== frame.x / 65536 || y !== frame.y / 65536);
  light.setAttribute('aria-label', `Light ${frame.light + 1} of ${frame.lights}: drag it, or move it by arrows and page keys`);
}

function drawRays(lines) {
  const rays = $('rays'), pen = rays.getContext('2d'), scale = rays.width / frame.width;
  pen.clearRect(0, 0, rays.width, rays.height);
  pen.lineWidth = 1.5 * rays.width / rays.clientWidth;
  for (const [x, y, u, v, colour] of lines) {
    pen.strokeStyle = `rgb(${(colour >> 11) * 255 / 31} ${(colour >> 5 & 63) * 255 / 63} ${(colour & 31) * 255 / 31})`;
    pen.beginPath();
    pen.moveTo((x + .5) * scale, (y + .5) * scale);
    pen.lineTo((u + .5) * scale, (v + .5) * scale);
    pen.stroke();
  }
  picture.dataset.rays = lines.length;
}

function clearRays() {
  $('rays').getContext('2d').clearRect(0, 0, $('rays').width, $('rays').height);
  delete picture.dataset.rays;
}

function updateNote() {
  const whitted = !frame || frame.spp === 0, plain = $('arithmetic').value === '0', rays = plain && whitted && $('show-rays').checked;
  $('view').disabled = $('show-rays').disabled = !plain || !whitted;
  $('note').textContent = !plain ? 'Views show the rays of integers: choose q16 for them.'
    : !whitted ? 'Views show Whitted\u2019s rays: choose that integrator for them.' : '';
  const entries = rays ? RAYS : $('arithmetic').value === '2' ? ERRORS : [];
  if ($('legend').childElementCount !== entries.length) {
    $('legend').replaceChildren(...entries.map(([colour, text]) => {
      const item = document.createElement('li'), box = document.createElement('i');
      box.style.background = colour;
      item.append(box, text);
      return item;
    }));
  }
  $('legend').hidden = entries.length === 0;
}

// ---- keys ----

const code = key => KEYS[key] || (key.length === 1 && key >= ' ' && key <= '~' ? key.toLowerCase().charCodeAt(0) : 0);

// Sets `pose` to the key that has set the only light, or to null if the picture's checksum is no longer known.
function follow(key) {
  const own = bindings().includes(key);
  if (pose !== null && own && (!frame || frame.lights <= 1)) pose = key;
  else if (key !== 'Tab') pose = null;
}

function press(key, shift, time, repeat) {
  const value = code(key);
  if (!value) return;
  if (!frame && !scene) { early.push(key); return; }
  follow(key);
  if (!suspends) send([{kind: TAP, key: value, shift, time}]);
  else if (!repeat) {
    held.set(key, value);
    send([{kind: PRESS, key: value, shift, time}]);
  }
}

function release(key) {
  if (held.delete(key)) send([{kind: RELEASE, key: code(key)}]);
}

function releaseAll() { [...held.keys()].forEach(release); }

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
  drag = 'eye';
  picture.setPointerCapture(event.pointerId);
  point(event, true);
});
picture.addEventListener('pointermove', event => {
  if (!event.isPrimary || drag === 'light') return;
  if (drag === 'eye') pose = null;
  if (drag === 'eye' || $('show-rays').checked) point(event, drag === 'eye');
});
for (const over of ['pointerup', 'pointercancel'])
  picture.addEventListener(over, event => { if (drag === 'eye') point(event, false); drag = null; });
picture.addEventListener('contextmenu', event => { if (drag) event.preventDefault(); });

let last = null;
$('light').addEventListener('pointerdown', event => {
  drag = 'light';
  last = event;
  $('light').setPointerCapture(event.pointerId);
});
$('light').addEventListener('pointermove', event => {
  if (drag !== 'light') return;
  const box = picture.getBoundingClientRect(), inside = v => Math.min(Math.max(v, .03), .97) * 100 + '%';
  pose = null;
  $('light').style.left = inside((event.clientX - box.left) / box.width);
  $('light').style.top = inside((event.clientY - box.top) / box.height);
  send([{kind: POINT, key: DRAGGED, drag: 1, time: performance.timeOrigin + event.timeStamp,
    x: Math.round((event.clientX - last.clientX) / box.width * 65536), y: Math.round((event.clientY - last.clientY) / box.height * 65536)}]);
  last = event;
});
for (const over of ['pointerup', 'pointercancel']) $('light').addEventListener(over, () => { drag = null; placeLight(); });

// ---- the scene's text ----

const bindings = () => [...$('text').value.matchAll(/^\s*key\s+(\S)\s/gm)].map(match => match[1]);

function number() {
  const count = $('text').value.split('\n').length;
  if ($('gutter').childElementCount === count) return;
  $('gutter').replaceChildren(...Array.from({length: count}, (_, i) => {
    const line = document.createElement('span');
    line.textContent = i + 1 + '\n';
    return line;
  }));
}

function followScroll() {
  const mark = $('mark');
  $('gutter').scrollTop = $('text').scrollTop;
  mark.style.transform = `translateY(${-$('text').scrollTop}px)`;
}

// Shows an error, FILE:LINE:COLUMN: WHAT. Its line is marked only if FILE is the scene itself.
function showError(error) {
  const found = error && error.match(/^([^:]*):(?:(\d+):)?(?:(\d+):)? (.*)$/s), own = found && found[1] === scene;
  const line = own && found[2] ? +found[2] : 0, mark = $('mark');
  document.querySelectorAll('#gutter .at').forEach(at => at.classList.remove('at'));
  $('text').setAttribute('aria-invalid', String(Boolean(error)));
  $('error').hidden = !error;
  $('error').textContent = !error ? '' : line ? `line ${line}, column ${found[3]}: ${found[4]}` : error;
  mark.hidden = !line;
  mark.style.top = 10 + 20 * (line - 1) + 'px';
  if (line && $('gutter').children[line - 1]) $('gutter').children[line - 1].classList.add('at');
  followScroll();
}

function showBindings() {
  const own = [...new Set(bindings())];
  if ($('bindings').textContent === own.join('')) return;
  $('bindings').replaceChildren(...own.map(key => {
    const button = document.createElement('button');
    button.type = 'button';
    button.dataset.key = button.textContent = key;
    button.setAttribute('aria-label', `Key ${key} of this scene`);
    return button;
  }));
}

let typing = 0;
function edited() {
  number();
  showBindings();
  $('reset').hidden = $('text').value === texts.get(scene);
  clearTimeout(typing);
  typing = setTimeout(() => { pose = '-'; change(load()); }, 200);
}

async function open(name) {
  if (!texts.has(name)) {
    const answer = await fetch('scenes/' + name);
    if (!answer.ok) return fail(`scenes/${name}: ${answer.status}`);
    texts.set(name, await answer.text());
  }
  releaseAll();
  scene = name;
  frame = null;
  pose = '-';
  $('text').value = texts.get(name);
  $('text').scrollTop = 0;
  $('name').textContent = name;
  $('reset').hidden = true;
  number();
  showBindings();
  clearRays();
  change(load());
  const own = bindings();
  if (own.length && !/^\s*light\b/m.test($('text').value)) early.unshift(own[0]);
  for (const key of early.splice(0)) { press(key, false, 0); release(key); }
}

// ---- the page ----

function listen() {
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
  for (const id of ['view', 'arithmetic', 'integrator', 'samples', 'size', 'show-rays'])
    $(id).addEventListener('change', () => { clearRays(); updateNote(); change({goesOn: true}); });
  $('scene').addEventListener('change', () => open($('scene').value));
  $('text').addEventListener('input', edited);
  $('text').addEventListener('scroll', followScroll);
  $('reset').addEventListener('click', () => { $('text').value = texts.get(scene); edited(); $('text').focus(); });
}

async function compile() {
  const answer = await fetch('tia.wasm');
  return answer.headers.get('content-type') === 'application/wasm' ? WebAssembly.compileStreaming(answer)
    : WebAssembly.compile(await answer.arrayBuffer());
}

async function start() {
  listen();
  [gallery, module] = await Promise.all([fetch('gallery.json').then(answer => answer.json()), compile()]);
  $('version').textContent = `tia ${gallery.version}.`;
  for (const name of gallery.scenes) $('scene').add(new Option(name, name + '.tia'));
  const wanted = query.get('scene');
  $('scene').value = (gallery.scenes.includes(wanted) ? wanted : 'thesis') + '.tia';
  if ([...$('size').options].some(option => option.value === query.get('size'))) $('size').value = query.get('size');
  $('rays').width = 1280;
  $('rays').height = 960;
  begin();
  await open($('scene').value);
  picture.focus({preventScroll: true});
}

start().catch(error => fail(String(error)));
