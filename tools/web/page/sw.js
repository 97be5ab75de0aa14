// sw.js - the service worker: keeps all files of the page, of one version together, and answers from them, so that the page works
// offline and never mixes versions. `make web` fills in the version, a hash of the files, and their names.
'use strict';

const VERSION = 'tia-@VERSION@', FILES = ['./', '@FILES@'];

self.addEventListener('install', event => event.waitUntil((async () => {
  const cache = await caches.open(VERSION);
  await cache.addAll(FILES.map(name => new Request(name, {cache: 'no-cache'})));
  if (!self.registration.active) await self.skipWaiting();
})()));

// Caches of other paths of this server are not ours: only those of this name are deleted.
self.addEventListener('activate', event => event.waitUntil((async () => {
  for (const name of await caches.keys()) if (name.startsWith('tia-') && name !== VERSION) await caches.delete(name);
  await self.clients.claim();
})()));

self.addEventListener('message', event => { if (event.data === 'use') self.skipWaiting(); });

self.addEventListener('fetch', event => {
  const url = new URL(event.request.url);
  if (event.request.method !== 'GET' || url.origin !== location.origin) return;
  event.respondWith((async () => {
    const cache = await caches.open(VERSION);
    return await cache.match(event.request, {ignoreSearch: true}) || fetch(event.request);
  })());
});
