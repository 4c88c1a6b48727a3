'use strict';
// The library, opened with a scene: an object with answer(request), which returns what the library answers.
async function openLibrary(given) {
  const library = await Library();
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
