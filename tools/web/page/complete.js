// complete.js - completes words of the text: a list below the caret. Tab takes the first word, arrows choose, Escape closes the list,
// Ctrl and Space open it. While there is no list, Tab leaves the text as it leaves any field.
import {$, element, say} from './page.js';
import {metrics, text, type} from './editor.js';
import {completions} from './words.js';

const area = $('text'), box = $('completions'), MOST = 60;
let list = [], begin = 0, chosen = -1;

const isOpen = () => !box.hidden;

export function closeCompletions() {
  box.hidden = true;
  list = [];
  chosen = -1;
  area.removeAttribute('aria-activedescendant');
}

function choose(index) {
  chosen = index;
  [...box.children].forEach((one, i) => one.setAttribute('aria-selected', String(i === index)));
  if (index < 0) return;
  area.setAttribute('aria-activedescendant', box.children[index].id);
  box.children[index].scrollIntoView({block: 'nearest'});
}

// Width of a letter of the text, measured once for each size of the font.
const widths = new Map();
function letterWidth() {
  const font = getComputedStyle(area).font;
  if (!widths.has(font)) {
    const pen = document.createElement('canvas').getContext('2d');
    pen.font = font;
    widths.set(font, pen.measureText('0'.repeat(100)).width / 100);
  }
  return widths.get(font);
}

// Places the list below the word, or above it where there is no room.
function place(line, column) {
  const left = 12 + column * letterWidth() - area.scrollLeft, top = metrics.top + (line + 1) * metrics.line - area.scrollTop;
  box.style.left = Math.max(Math.min(left, area.clientWidth - box.offsetWidth - 4), 0) + 'px';
  box.style.top = (top + box.offsetHeight > area.clientHeight && top > box.offsetHeight ? top - metrics.line - box.offsetHeight : top) + 'px';
}

function open(all) {
  const at = area.selectionStart, whole = text(), from = whole.lastIndexOf('\n', at - 1) + 1, to = (whole + '\n').indexOf('\n', at);
  closeCompletions();
  if (at !== area.selectionEnd) return;
  const found = completions(whole.slice(from, to), at - from, whole, all);
  if (!found.list.length) return all ? say('no completions') : undefined;
  list = found.list.slice(0, MOST);
  begin = from + found.begin;
  box.replaceChildren(...list.map(([word, note], i) => {
    const one = element('li', {id: `completion-${i}`, role: 'option'}, element('b', {textContent: word}), element('span', {textContent: note}));
    one.addEventListener('pointerdown', event => { event.preventDefault(); take(i); });
    return one;
  }));
  box.hidden = false;
  place(whole.slice(0, from).split('\n').length - 1, found.begin);
  choose(-1);
  say(`${found.list.length} completions: ${list.slice(0, 3).map(([word]) => word).join(', ')}`);
}

function take(index) {
  const word = list[index][0], end = area.selectionStart;
  type(begin, end, word + ' ');
  closeCompletions();
}

function onKey(event) {
  const {key} = event;
  if (key === ' ' && event.ctrlKey) open(true);
  else if (!isOpen() || event.ctrlKey || event.altKey || event.metaKey) return;
  else if (key === 'ArrowDown') choose((chosen + 1) % list.length);
  else if (key === 'ArrowUp') choose((Math.max(chosen, 0) + list.length - 1) % list.length);
  else if (key === 'Escape') closeCompletions();
  else if (key === 'Tab' && !event.shiftKey) take(Math.max(chosen, 0));
  else if (key === 'Enter' && chosen >= 0) take(chosen);
  else {
    if (['Enter', 'ArrowLeft', 'ArrowRight', 'Home', 'End', 'PageUp', 'PageDown', 'Tab'].includes(key)) closeCompletions();
    return;
  }
  event.preventDefault();
  event.stopPropagation();
}

export function startCompletions() {
  area.addEventListener('keydown', onKey);
  area.addEventListener('input', event => { event.inputType === 'insertText' && /^\S$/.test(event.data || '') || event.inputType === 'deleteContentBackward' && isOpen() ? open(false) : closeCompletions(); });
  area.addEventListener('blur', closeCompletions);
  area.addEventListener('pointerdown', closeCompletions);
  area.addEventListener('scroll', closeCompletions);
}
