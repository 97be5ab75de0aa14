// editor.js - the scene's text: a plain <textarea>, so that undo, keys and screen readers work as everywhere, over a copy of
// its visible lines in colour; line numbers with a mark at each mistake, and the message at its line.
import {$, element} from './page.js';
import {tokens} from './words.js';

const LINE = 20, TOP = 10, MARGIN = 4; // as in style.css: height of a line, padding above the first one; lines drawn beyond the edges
const area = $('text');
let lines = [''], mistakes = [], chosen = 0, general = '';

export const text = () => area.value;
export const caretLine = () => area.value.slice(0, area.selectionStart).split('\n').length;

// ---- the visible lines ----

function coloured(line, mistake) {
  const box = element('span', {className: 'line'});
  let at = 0;
  for (const [begin, end, kind] of tokens(line)) {
    const wrong = mistake && mistake.column - 1 >= begin && mistake.column - 1 < end;
    box.append(line.slice(at, begin), element('span', {className: `is-${kind}${wrong ? ' wrong' : ''}`, textContent: line.slice(begin, end)}));
    at = end;
  }
  box.append(line.slice(at) + '\n');
  return box;
}

function paint() {
  const first = Math.max(Math.floor((area.scrollTop - TOP) / LINE) - MARGIN, 0);
  const last = Math.min(first + Math.ceil(area.clientHeight / LINE) + 2 * MARGIN, lines.length);
  const at = new Map(mistakes.map(mistake => [mistake.line, mistake])), numbers = [], shown = [];
  for (let i = first; i < last; i++) {
    const wrong = at.get(i + 1);
    numbers.push(element('span', {className: wrong ? 'at' : '', textContent: i + 1}));
    shown.push(coloured(lines[i], wrong));
    if (wrong) shown[shown.length - 1].classList.add('at');
  }
  $('gutter').replaceChildren(...numbers);
  $('backdrop').replaceChildren(...shown);
  const down = TOP + first * LINE - area.scrollTop, under = $('backdrop').parentElement;
  under.style.width = area.clientWidth + 'px'; // without its scroll bars
  under.style.height = area.clientHeight + 'px';
  $('gutter').style.transform = `translateY(${down}px)`;
  $('backdrop').style.transform = `translate(${-area.scrollLeft}px, ${down}px)`;
}

// Places the message below its line, or above it when the caret is below or there is no room; at the edge if the line is out of sight.
function placeMessage() {
  const one = mistakes[chosen], box = $('error');
  if (box.hidden) return;
  const top = one ? TOP + (one.line - 1) * LINE - area.scrollTop : 0, below = top + LINE;
  box.classList.toggle('away', Boolean(one) && (top < -LINE / 2 || top > area.clientHeight - LINE / 2)); // with its button it may be higher
  const room = Math.max(area.clientHeight - box.offsetHeight, 0), covered = document.activeElement === area && one && caretLine() > one.line;
  const wanted = !one ? room : (covered || below > room) && top >= box.offsetHeight ? top - box.offsetHeight : below;
  box.style.top = Math.min(Math.max(wanted, 0), room) + 'px';
}

function redraw() {
  paint();
  placeMessage();
}

let waiting = false;
function redrawSoon() {
  if (waiting) return;
  waiting = true;
  requestAnimationFrame(() => { waiting = false; redraw(); });
}

// ---- mistakes ----

function showMessage() {
  const one = mistakes[chosen], box = $('error'), message = one ? `line ${one.line}, column ${one.column}: ${one.what}` : general;
  area.setAttribute('aria-invalid', String(Boolean(message)));
  box.hidden = !message;
  if ($('error-text').textContent !== message) $('error-text').textContent = message;
  $('go-to').hidden = !one;
  $('next-mistake').hidden = mistakes.length < 2;
  $('next-mistake').textContent = `${chosen + 1} of ${mistakes.length}: next`;
  redraw();
}

// Shows messages: lines FILE:LINE:COLUMN: WHAT. Those of the scene's own text are marked there; of others the first is shown.
export function showMistakes(message, scene) {
  const found = [...(message || '').matchAll(/^([^:\n]*):(\d+):(\d+): (.*)$/gm)];
  mistakes = found.filter(one => one[1] === scene).map(([, , line, column, what]) => ({line: +line, column: +column, what}));
  chosen = Math.max(mistakes.findIndex(one => one.line === caretLine()), 0);
  general = mistakes.length ? '' : (message || '').split('\n')[0];
  showMessage();
}

function goTo() {
  const {line, column} = mistakes[chosen], at = lines.slice(0, line - 1).reduce((sum, one) => sum + one.length + 1, 0) + column - 1;
  area.focus();
  area.setSelectionRange(at, at);
  area.scrollTop = Math.max(TOP + (line - 1) * LINE - area.clientHeight / 2, 0);
  redraw();
}

// ---- changes ----

// Replaces a part of the text as typing does, so that undo takes it back.
export function type(begin, end, replacement) {
  area.focus();
  area.setSelectionRange(begin, end);
  if (!document.execCommand(replacement ? 'insertText' : 'delete', false, replacement)) {
    area.setRangeText(replacement, begin, end, 'end');
    area.dispatchEvent(new Event('input'));
  }
}

// Sets another text, of which there is nothing to undo.
export function setText(value) {
  area.value = value;
  area.scrollTop = area.scrollLeft = 0;
  area.setSelectionRange(0, 0);
  changed();
}

function changed() {
  lines = area.value.split('\n');
  redraw();
}

export function startEditor(edited) {
  area.addEventListener('input', () => { changed(); edited(); });
  area.addEventListener('scroll', redrawSoon);
  document.addEventListener('selectionchange', redrawSoon);
  new ResizeObserver(redrawSoon).observe(area);
  $('go-to').addEventListener('click', goTo);
  $('next-mistake').addEventListener('click', () => { chosen = (chosen + 1) % mistakes.length; showMessage(); goTo(); });
}

export const repaint = redraw;
export const metrics = {line: LINE, top: TOP};
