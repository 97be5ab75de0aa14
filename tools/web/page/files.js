// files.js - opens files, and saves the text, the picture and its record.
import {$, element, notice, page} from './page.js';
import {addFile, change, load, order, pause} from './engine.js';
import {text} from './editor.js';
import {openText} from './scenes.js';
import {png, withoutAlpha} from './png.js';

const MOST = 32 << 20; // bytes of a file
const base = () => page.scene.replace(/\.tia$/, '');

// The time of the picture, with as many digits as it takes to read it again exactly.
const seconds = () => String(+(page.frame.time / 65536).toFixed(6));

function save(name, blob, more = '') {
  const url = URL.createObjectURL(blob), link = element('a', {href: url, download: name});
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 60000);
  notice(`${name} saved, ${blob.size} bytes.${more}`);
}

const savePicture = (name, blob) => save(name, blob, page.frame.plays ? ` The scene is paused at ${seconds()} s.` : '');

// Opens a scene; other files are those that scenes name: images, models, included text.
async function openFiles(list) {
  const files = [...list], scene = files.find(file => /\.tia$/i.test(file.name)), large = files.find(file => file.size > MOST);
  if (large) return notice(`${large.name} is too large: at most ${MOST >> 20} MiB.`);
  for (const file of files) if (file !== scene) addFile(file.name, new Uint8Array(await file.arrayBuffer()));
  if (scene) await openText(scene.name.replace(/[^\w.-]/g, '_').slice(-100), (await scene.text()).replaceAll('\r\n', '\n'));
  else change(load());
  notice(`${files.map(file => file.name).join(', ')} opened.`);
}

// Pauses a scene that plays, so that all that is saved shows the same moment. Returns false, and says so, if there is no picture to save.
async function ready() {
  await pause();
  if (!page.complete) notice('The picture is not complete yet.');
  return page.complete;
}

async function savePng8() {
  if (!await ready()) return;
  const {width, height} = $('canvas'), {data} = $('canvas').getContext('2d').getImageData(0, 0, width, height);
  savePicture(base() + '.png', await png(width, height, withoutAlpha(data), {significant: [5, 6, 5]}));
}

async function savePng16() {
  if (!await ready()) return;
  if ($('arithmetic').value === '2' || ($('view').value !== '0' && !$('view').disabled)) return notice('16 bits are for colours: views and error maps have none.');
  notice('Drawing with 16 bits a channel\u2026');
  const {width, height, colours} = await order({colours: true});
  savePicture(base() + '-16.png', await png(width, height, colours, {linear: page.frame.spp > 0}));
}

// Returns why there is no record of this picture; '' if there can be one.
function unrecorded() {
  if ($('arithmetic').value === '2') return 'an error map has no record';
  if ($('show-rays').checked) return 'a picture with rays has no record';
  if (page.eye !== 'home') return 'the eye was moved (the key home takes it back)';
  if (page.technique !== 'own') return 'the key t has chosen another technique for shadows';
  return page.pose === null ? 'the light was moved: a record needs the scene\u2019s own, or one that a key of the scene sets' : '';
}

// The options that draw this picture by the command.
function options() {
  const list = [], value = id => $(id).value, sampled = page.frame.spp > 0;
  if (value('arithmetic') === '1') list.push('arithmetic=f64');
  if (page.pose !== '-') list.push('keys=' + page.pose);
  if (value('view') !== '0' && !$('view').disabled) list.push('view=' + $('view').selectedOptions[0].dataset.name);
  if (value('integrator') !== '-1') list.push('integrator=' + ['whitted', 'ao', 'path'][value('integrator')]);
  if (sampled) list.push('colour=565', 'spp=' + page.frame.spp);
  else if (value('samples') !== '0') list.push('samples=' + Math.min(value('samples'), 16));
  if (page.frame.plays) list.push('time=' + seconds());
  return list;
}

async function saveRecord() {
  if (!await ready()) return;
  const why = unrecorded();
  if (why) return notice('No record: ' + why + '.');
  const {record} = await order({record: {picture: base() + '.png', options: options()}});
  savePicture(base() + '.record', new Blob([record], {type: 'text/plain'}));
}

export function startFiles() {
  const on = (id, does) => $(id).addEventListener('click', () => Promise.resolve(does()).catch(error => notice(error.message)));
  on('open', () => $('file').click());
  $('file').addEventListener('change', () => { openFiles($('file').files).catch(error => notice(error.message)); $('file').value = ''; });
  on('save', () => save(page.scene, new Blob([text()], {type: 'text/plain'})));
  on('png8', savePng8);
  on('png16', savePng16);
  on('record', saveRecord);
  addEventListener('dragover', event => event.preventDefault());
  addEventListener('drop', event => {
    event.preventDefault();
    if (event.dataTransfer.files.length) openFiles(event.dataTransfer.files).catch(error => notice(error.message));
  });
}
