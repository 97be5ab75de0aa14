// picture.js - shows pictures, their checksums and verdicts, the ring of the light, and rays.
import {$, page, say} from './page.js';
import {settings} from './engine.js';
import {text} from './editor.js';
import {original} from './scenes.js';

const RAYS = [['#fff', 'primary'], ['#ff0', 'reflected'], ['#0ff', 'refracted'], ['#c6c3c6', 'past an opacity'],
  ['#0f0', 'light arrives'], ['#f00', 'light does not'], ['#f0f', 'normal']];
const ERRORS = [['#ffff00', 'one level apart'], ['#ff0000', 'more'], ['#00ffff', 'another path']];
const picture = $('picture'), canvas = $('canvas'), context = canvas.getContext('2d', {willReadFrequently: true});

// ---- checksums ----

const ms = us => us < 9950 ? (us / 1000).toFixed(1) + ' ms' : us < 1e6 ? Math.round(us / 1000) + ' ms' : (us / 1e6).toFixed(1) + ' s';
const hex = crc => crc.toString(16).padStart(8, '0');

// Returns the known checksum of this picture; undefined if there is none.
function pinned() {
  const {frame} = page, s = settings(), edited = original(page.scene) !== text();
  if (edited || page.pose === null || page.eye !== 'home' || page.technique !== 'own' || (frame && frame.plays) || s.arithmetic || s.view || s.rays || s.integrator !== -1 || s.samples) return undefined;
  return page.gallery.pinned[`${page.scene.replace('.tia', '')} ${page.pose} ${s.width}x${s.height}`];
}

function judge(crc) {
  const {frame} = page, known = pinned(), verdict = $('verdict');
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

function showIncomplete() {
  page.complete = false;
  $('crc').textContent = $('verdict').textContent = '\u2026';
  $('pinned').textContent = pinned() || '-';
  $('verdict').className = '';
}

function showComplete() {
  const crc = hex(page.frame.crc);
  page.complete = true;
  $('crc').textContent = crc;
  if (page.frame.announced) return;
  page.frame.announced = true;
  say(`${page.scene} drawn, CRC-32 ${crc}, ${judge(crc)}`);
  picture.dataset.complete = `${page.scene} ${crc}`;
}

export function show(now, pixels) {
  page.frame = now;
  if (canvas.width !== now.width || canvas.height !== now.height) {
    canvas.width = now.width;
    canvas.height = now.height;
  }
  context.putImageData(new ImageData(new Uint8ClampedArray(pixels), now.width, now.height), 0, 0);
  $('progress').value = now.block > 1 ? now.done / 65536 : now.spp ? now.samples / now.spp : 1;
  $('time').textContent = now.block > 1 ? '\u2026' : now.spp ? `${now.samples} of ${now.spp} samples` : ms(now.drawUs);
  if (now.keyUs) $('latency').textContent = ms(now.keyUs);
  if (now.settled && now.change === page.change) showComplete();
  else showIncomplete();
  placeLight();
  picture.dataset.light = `${now.x} ${now.y}`;
  picture.dataset.copied = now.copied;
  $('next-light').hidden = now.lights < 2;
  $('pause').hidden = !now.plays;
  updateNote();
}

// The picture stays as it is after the change of that number.
export function showAgain(change) {
  if (page.frame && !page.complete && change === page.change) showComplete();
}

export function placeLight() {
  const {frame} = page;
  if (!frame) return;
  const light = $('light');
  light.hidden = frame.light < 0;
  if (light.hidden || page.drag) return;
  const inside = v => Math.min(Math.max(v / 65536, .03), .97), x = inside(frame.x), y = inside(frame.y);
  light.style.left = 100 * x + '%';
  light.style.top = 100 * y + '%';
  light.classList.toggle('outside', x !== frame.x / 65536 || y !== frame.y / 65536);
  light.setAttribute('aria-label', `Light ${frame.light + 1} of ${frame.lights}: drag it, or move it by arrows and page keys`);
}

export function drawRays(lines) {
  const rays = $('rays'), pen = rays.getContext('2d'), scale = rays.width / page.frame.width;
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

export function clearRays() {
  $('rays').getContext('2d').clearRect(0, 0, $('rays').width, $('rays').height);
  delete picture.dataset.rays;
}

export function updateNote() {
  const {frame} = page, whitted = !frame || frame.spp === 0, plain = $('arithmetic').value === '0', rays = plain && whitted && $('show-rays').checked;
  $('view').disabled = $('show-rays').disabled = !plain || !whitted;
  $('note').textContent = !plain ? 'Views show the rays of integers: choose that arithmetic for them.'
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
