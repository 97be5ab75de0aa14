// conform.js - the page conform.html: starts the comparison in a worker, and shows what it says.
'use strict';

const part = id => document.getElementById(id);
let worker = null;

function end(text, good) {
  worker.terminate();
  worker = null;
  part('start').textContent = 'compare';
  part('verdict').textContent = text;
  part('verdict').className = good ? 'good' : 'bad';
}

function hear({data}) {
  if (data.driver) part('driver').textContent = data.driver;
  if (data.drawn) part('progress').value = Math.min(data.drawn / part('trials').value, 1);
  if (data.why) end(data.why, false);
  if (data.found !== undefined) {
    const lines = data.found.trimEnd().split('\n'), last = lines.pop();
    part('found').textContent = lines.join('\n');
    part('progress').value = 1;
    end(last, data.same);
  }
}

function start() {
  if (worker) return end('stopped', false);
  const numbers = ['trials', 'step', 'seed'].map(id => part(id));
  if (!numbers.every(e => e.reportValidity())) return;
  part('found').textContent = part('verdict').textContent = '';
  part('progress').value = 0;
  part('start').textContent = 'stop';
  worker = new Worker('conform-worker.js');
  worker.onmessage = hear;
  worker.onerror = event => end(event.message || 'the worker failed', false);
  worker.postMessage(numbers.map(e => Number(e.value)));
}

part('start').onclick = start;
