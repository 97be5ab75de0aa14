// reference.js - help about the word at the caret, with a link to its place in the reference; F1 opens it. The texts, and the words of
// the language, are made from the manual and the parser's tables (tools/generate/language.py).
import {$, element} from './page.js';
import {repaint, text} from './editor.js';
import {setWords} from './words.js';

const area = $('text'), box = $('word-help');
let loading = null, reference = null, shown = '';

// Returns the statement of the caret's line, the words before the one at the caret, and that word.
function atCaret() {
  const whole = text(), at = area.selectionStart, from = whole.lastIndexOf('\n', at - 1) + 1;
  const line = whole.slice(from, (whole + '\n').indexOf('\n', at)).replace(/#.*/, ''), before = line.slice(0, at - from);
  const words = before.split(/\s+/).filter(Boolean), inside = /\S$/.test(before), rest = line.slice(at - from).match(/^\S*/)[0];
  const word = (inside ? words.pop() : '') + rest;
  return {statement: words.length ? words[0] : word, before: words, word};
}

// Of the places where a statement has the word, the one whose path has most of the words before it. Returns null if there is none.
function property({statement, before, word}) {
  const count = row => row.of.split(' ').filter(one => before.includes(one)).length;
  const rows = (reference.properties[word] || []).filter(row => row.of.split(' ')[0] === statement);
  return rows.reduce((best, row) => !best || count(row) > count(best) ? row : best, null);
}

function showHelp() {
  if (!reference || document.activeElement !== area) return;
  const caret = atCaret(), found = caret.before.length && property(caret), entry = found || reference.statements[caret.statement];
  const name = found ? caret.word : entry ? caret.statement : '', key = `${caret.statement} ${name}`;
  if (key === shown) return;
  shown = key;
  if (!entry) return box.replaceChildren();
  box.replaceChildren(element('b', {textContent: name}), ` ${entry.help} `,
    element('a', {href: entry.place, target: 'tia-reference', rel: 'noopener', textContent: 'reference'}));
}

function take(found) {
  reference = found;
  setWords(found);
  repaint();
  showHelp();
}

// Fetches the words and their help, once; again if that has failed.
export function loadReference() {
  loading = loading || fetch('language.json').then(answer => answer.json()).then(take).catch(() => { loading = null; });
}

export function startReference() {
  area.addEventListener('focus', loadReference);
  document.addEventListener('selectionchange', showHelp);
  area.addEventListener('keydown', event => {
    const link = box.querySelector('a');
    if (event.key !== 'F1' || !link) return;
    event.preventDefault();
    link.click();
  });
}
