'use strict';
// The compiled library from the page's text: base64 of gzip.
async function unpacked(text) {
  const packed = await fetch('data:application/gzip;base64,' + text.trim());
  return new Response(packed.body.pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
}

// The library, opened with a scene: an object with answer(request), which returns what the library answers.
async function openLibrary(given, wasmBinary) {
  const library = await Library({ wasmBinary });
  const open = library.cwrap('slipproof_open', 'string', ['string', 'string']);
  const answer = library.cwrap('slipproof_answer', 'string', ['string']);
  const mistakes = open(JSON.stringify(given), given.file);
  if (mistakes) throw new Error(mistakes);
  return { answer: request => JSON.parse(answer(JSON.stringify(request))) };
}

// The scene in a link to a page that has none, as the report's pages have it: the part of the hash, and what it says.
const scenePart = hash => hash.slice(1).split('&').find(part => part.startsWith('scene:='));
function sceneOf(part) {
  if (!part) throw new Error('This is the explorer without a scene. `slipproof explore SCENE -o explorer.html` puts one into it.');
  try {
    const { scene, mechanism, along, file } = JSON.parse(decodeURIComponent(part.slice('scene:='.length)));
    if ([scene, mechanism, along, file].every(text => typeof text === 'string')) return { scene, mechanism, along, file };
  } catch { /* said below */ }
  throw new Error('The link has a scene that cannot be read. A part of the link is missing?');
}

// What the library answers, and in how many milliseconds.
function timed(library, request) {
  const start = performance.now(), answer = library.answer(request);
  return { answer, took: performance.now() - start };
}

// A worker answers, so that dragging stays smooth; where there are no workers, the page itself does.
function startWorker(given, compiled, library) {
  const code = ['library', 'asking'].map(id => document.getElementById(id).textContent).join('\n') + `
    let opened;
    onmessage = async ({ data }) => {
      try {
        if (data.given) opened = openLibrary(data.given, data.compiled);
        else postMessage({ id: data.id, ...timed(await opened, data.request) });
      } catch (error) {
        postMessage({ id: data.id, answer: { mistakes: [String(error.message ?? error)] } });
      }
    };`;
  try {
    const worker = new Worker(URL.createObjectURL(new Blob([code], { type: 'text/javascript' })));
    worker.postMessage({ given, compiled });
    return { post: message => worker.postMessage(message), listen: listener => { worker.onmessage = ({ data }) => listener(data); } };
  } catch {
    let listener;
    return { post: ({ id, request }) => listener({ id, ...timed(library, request) }), listen: other => { listener = other; } };
  }
}
