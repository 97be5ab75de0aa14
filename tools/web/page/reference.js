// reference.js - help about the word at the caret, with a link to its place in the reference; F1 opens it. The texts are
// made from the manual (tools/generate/language.py), and are fetched when the text is entered first.
import {$, element} from './page.js';
import {text} from './editor.js';

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

function enter() {
  loading = loading || fetch('language.json').then(answer => answer.json()).then(found => { reference = found; showHelp(); }, () => { loading = null; });
}

export function startReference() {
  area.addEventListener('focus', enter);
  document.addEventListener('selectionchange', showHelp);
  area.addEventListener('keydown', event => {
    const link = box.querySelector('a');
    if (event.key !== 'F1' || !link) return;
    event.preventDefault();
    link.click();
  });
}
