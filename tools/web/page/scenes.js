// scenes.js - the scenes of the gallery and the user's own: opens them, keeps what was edited, shows thumbnails.
import {$, element, fail, notice, page, say} from './page.js';
import {change, load} from './engine.js';
import {setText, showMistakes, text, type} from './editor.js';
import {bindings, pressEarly, releaseAll} from './input.js';
import {clearRays} from './picture.js';
import {keepText, keptTexts, pack, unpack} from './store.js';

const texts = new Map(); // texts of the gallery's scenes by name, as they were fetched

// Returns the text of a scene of the gallery as it was fetched; undefined for others.
export const original = name => texts.get(name);

const inGallery = name => page.gallery.scenes.includes(name.replace(/\.tia$/, ''));

async function fetched(name) {
  if (texts.has(name)) return texts.get(name);
  const answer = await fetch('scenes/' + name);
  if (!answer.ok) throw new Error(`scenes/${name}: ${answer.status}`);
  texts.set(name, await answer.text());
  return texts.get(name);
}

// ---- the scene that is shown ----

function showBindings() {
  const own = [...new Set(bindings())];
  if ($('bindings').textContent === own.join('')) return;
  $('bindings').replaceChildren(...own.map(key => {
    const button = element('button', {type: 'button', textContent: key});
    button.dataset.key = key;
    button.setAttribute('aria-label', `Key ${key} of this scene`);
    return button;
  }));
}

function addOwn(name) {
  if ([...$('scene').options].some(option => option.value === name)) return;
  let group = $('own-scenes');
  if (!group) $('scene').prepend(group = element('optgroup', {id: 'own-scenes', label: 'your own'}));
  group.append(new Option(name.replace(/\.tia$/, ''), name));
}

function showName(name) {
  if (!inGallery(name)) addOwn(name);
  $('scene').value = name;
  $('name').textContent = name;
  for (const one of $('gallery').children) one.toggleAttribute('aria-current', one.dataset.scene === name);
}

function begin(name, value) {
  releaseAll();
  Object.assign(page, {scene: name, frame: null, complete: false, pose: '-', eye: 'home', technique: 'own'});
  showName(name);
  setText(value);
  showMistakes(null, name);
  $('reset').hidden = texts.get(name) === undefined || value === texts.get(name);
  showBindings();
  clearRays();
  change(load());
  pressEarly();
}

// Opens a scene of the gallery or one that is kept.
export async function open(name) {
  const first = inGallery(name) ? await fetched(name) : undefined, kept = keptTexts()[name];
  const value = kept === undefined ? first : kept;
  if (value === undefined) return fail(`${name}: there is no such scene`);
  history.replaceState(null, '', location.pathname + location.search);
  begin(name, value);
  if (kept !== undefined && first !== undefined) notice('Your edited text.');
  else $('notice').textContent = '';
}

// Opens a text from a file or a link; it gets a name of its own if it is not that of the gallery.
export async function openText(name, value) {
  const first = inGallery(name) ? await fetched(name) : undefined;
  if (first !== undefined && first !== value) name = 'my-' + name;
  begin(name, value);
  keepNow();
}

// ---- edits ----

function keepNow() {
  const value = text(), same = value === texts.get(page.scene);
  if (!keepText(page.scene, same ? null : value)) notice('This browser keeps no more text: save it as a file.');
}

let typing = 0;
export function edited() {
  showBindings();
  $('reset').hidden = texts.get(page.scene) === undefined || text() === texts.get(page.scene);
  if (location.hash) history.replaceState(null, '', location.pathname + location.search);
  clearTimeout(typing);
  typing = setTimeout(flush, 200);
}

function flush() {
  clearTimeout(typing);
  typing = 0;
  keepNow();
  Object.assign(page, {pose: '-', eye: 'home', technique: 'own'});
  change(load());
}

// ---- links ----

async function share() {
  const url = new URL(location.href);
  url.hash = await pack({name: page.scene, text: text()});
  url.searchParams.delete('scene');
  history.replaceState(null, '', url.href);
  const copied = await navigator.clipboard.writeText(url.href).then(() => true, () => false);
  notice(copied ? `Link copied: ${url.href.length} letters, with the whole text.` : 'The address of this page now has the whole text.');
}

async function openLink() {
  try {
    const shared = await unpack(location.hash);
    if (shared) await openText(shared.name, shared.text);
    return shared !== null;
  } catch {
    notice('The link is damaged: it has no scene.');
    return false;
  }
}

// ---- start ----

function fillGallery() {
  const tile = name => {
    const image = element('img', {alt: '', width: 160, height: 120, loading: 'lazy'});
    const button = element('button', {type: 'button'}, image, element('span', {textContent: name}));
    button.dataset.scene = name + '.tia';
    button.addEventListener('click', () => { open(name + '.tia'); scrollTo({top: 0, behavior: 'instant'}); say(`${name} opened`); });
    return button;
  };
  $('gallery').replaceChildren(...page.gallery.scenes.map(tile));
}

// Loads the thumbnails, which would delay the first picture on a slow line.
export function showThumbnails() {
  for (const image of document.querySelectorAll('#gallery img:not([src])'))
    image.src = `thumbnails/${image.nextSibling.textContent}.png`;
}

export async function startScenes() {
  for (const name of page.gallery.scenes) $('scene').add(new Option(name, name + '.tia'));
  const kept = keptTexts(), wanted = page.query.get('scene');
  $('scene').addEventListener('change', () => open($('scene').value));
  $('reset').addEventListener('click', () => { type(0, text().length, texts.get(page.scene)); $('text').scrollTop = 0; });
  $('share').addEventListener('click', share);
  addEventListener('hashchange', openLink);
  addEventListener('pagehide', () => { if (typing) flush(); });
  if (!await openLink()) {
    const last = wanted ? wanted + '.tia' : '';
    await open(inGallery(last) || kept[last] !== undefined ? last : 'thesis.tia');
  }
  Object.keys(kept).filter(name => !inGallery(name)).forEach(addOwn);
  $('scene').value = page.scene;
  fillGallery();
  showName(page.scene);
}
