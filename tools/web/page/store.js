// store.js - keeps texts that were edited in the browser, and packs a scene into a link.

const TEXTS = 'tia.texts', MOST = 4 << 20; // bytes of a text in a link, unpacked

function read(key, otherwise) {
  try { return JSON.parse(localStorage.getItem(key)) || otherwise; } catch { return otherwise; }
}

// Returns false if the browser keeps nothing, or no more.
function write(key, value) {
  try { localStorage.setItem(key, JSON.stringify(value)); return true; } catch { return false; }
}

export const keptTexts = () => read(TEXTS, {});

// Keeps the text of a scene; null: it is the one of the gallery again.
export function keepText(name, text) {
  const texts = keptTexts();
  if (text === null) delete texts[name];
  else texts[name] = text;
  return write(TEXTS, texts);
}

// ---- links ----

const through = (bytes, stream) => new Response(new Blob([bytes]).stream().pipeThrough(stream));

// Packs an object into letters for the part of an address after #, which browsers do not send to servers.
export async function pack(object) {
  const packed = new Uint8Array(await through(new TextEncoder().encode(JSON.stringify(object)), new CompressionStream('deflate-raw')).arrayBuffer());
  let letters = '';
  for (const byte of packed) letters += String.fromCharCode(byte);
  return 's=' + btoa(letters).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

async function unpackBytes(letters) {
  const bytes = Uint8Array.from(atob(letters.replaceAll('-', '+').replaceAll('_', '/')), letter => letter.charCodeAt(0));
  const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw')).getReader(), parts = [];
  let size = 0;
  for (;;) {
    const {done, value} = await reader.read();
    if (done) return new Blob(parts).text();
    size += value.length;
    if (size > MOST) throw new Error('too long');
    parts.push(value);
  }
}

// Returns the object of an address's part after #; null: there is none; throws if it is not valid.
export async function unpack(hash) {
  const found = hash.match(/^#s=([\w-]+)$/);
  if (!found) return null;
  const object = JSON.parse(await unpackBytes(found[1]));
  if (typeof object.name !== 'string' || typeof object.text !== 'string' || !/^[\w.-]{1,100}\.tia$/.test(object.name)) throw new Error('no scene');
  return object;
}
