// offline.js - registers the service worker (sw.js), which keeps the page's files for use without a network. Browsers allow it for
// https and for localhost.
import {$, say} from './page.js';

function offer(waiting) {
  $('update').hidden = false;
  $('update').onclick = () => waiting.postMessage('use');
  say('A newer version of this page is ready.');
}

export async function startOffline() {
  const {serviceWorker} = navigator;
  if (!serviceWorker) return;
  const had = serviceWorker.controller;
  serviceWorker.addEventListener('controllerchange', () => { if (had) location.reload(); });
  const registration = await serviceWorker.register('sw.js').catch(() => null);
  if (!registration) return;
  if (registration.waiting) offer(registration.waiting);
  registration.addEventListener('updatefound', () => {
    const next = registration.installing;
    next.addEventListener('statechange', () => { if (next.state === 'installed' && serviceWorker.controller) offer(next); });
  });
  await serviceWorker.ready;
  document.documentElement.dataset.offline = 'ready';
}
