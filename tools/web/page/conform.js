// conform.js - the page conform.html: starts the comparison in a worker, and shows what it says.
import {$, stopWorker} from './page.js';

let worker = null;

function end(text, good) {
  stopWorker(worker);
  worker = null;
  $('start').textContent = 'compare';
  $('verdict').textContent = text;
  $('verdict').className = good ? 'good' : 'bad';
}

function hear({data}) {
  if (data.driver) $('driver').textContent = data.driver;
  if (data.drawn) $('progress').value = Math.min(data.drawn / $('trials').value, 1);
  if (data.why) end(data.why, false);
  if (data.found !== undefined) {
    const lines = data.found.trimEnd().split('\n'), last = lines.pop();
    $('found').textContent = lines.join('\n');
    $('progress').value = 1;
    end(last, data.same);
  }
}

function start() {
  if (worker) return end('stopped', false);
  const numbers = ['trials', 'step', 'seed'].map(id => $(id));
  if (!numbers.every(e => e.reportValidity())) return;
  $('found').textContent = $('verdict').textContent = '';
  $('progress').value = 0;
  $('start').textContent = 'stop';
  worker = new Worker('conform-worker.js');
  worker.onmessage = hear;
  worker.onerror = event => end(event.message || 'the worker failed', false);
  worker.postMessage(numbers.map(e => Number(e.value)));
}

$('start').onclick = start;
