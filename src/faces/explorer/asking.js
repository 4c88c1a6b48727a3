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
