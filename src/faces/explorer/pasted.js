'use strict';
// A solver's answers, pasted and judged: what the library says of each, in words.
const pasting = (() => {
  const by = id => document.getElementById(id);
  const examples = [
    ['right', '{"W": [[1, 0], [0, 1]], "q": [-9.81, 0.5], "mu": 0.3, "r": [9.81, -0.5]}'],
    ['wrong', '{"W": [[1, 0], [0, 1]], "q": [-9.81, 5], "mu": 0.3, "r": [9.81, -5], "mode": "stick"}'],
    ['one of several', '{"W": [[1, "-9/5"], ["-9/5", 4]], "q": [1, -6], "mu": 0.75, "r": [0, 0]}'],
  ];
  const said = {
    certified: one => `The answer is the one ${one}, within the tolerance.`,
    ambiguous: one => `The answer is right, and not the only one: there are other ${one}s.`,
    inaccurate: one => `The answer is near a ${one}, with an error above the tolerance.`,
    wrong: one => `No ${one} is near the answer.`,
    invalid: () => 'This is no answer that can be judged.',
    undecided: () => 'A verdict would take more work than the page allows.',
  };

  // A long fraction as a decimal; it stands in full in what certify prints.
  const short = text => text.length > 20 ? fraction(text).querySelector('small')?.textContent ?? shortened(text) : text;
  const listed = value => Array.isArray(value) ? `[${value.map(listed).join(', ')}]` : value === null ? '∞' : short(String(value));

  function reasons(line) {
    const mode = line.claimed ?? line.looks_like;
    const of = mode ? `${line.claimed ? 'It claims' : 'It looks like'} ${mode}` : '';
    const because = line.violated ? `${line.violated} is violated, by ${short(line.margin)}`
      : line.because ? `these exclude each other: ${line.because.join(', ')}` : line.reason ?? '';
    const error = line.max_relative_error ? `largest relative error ${line.max_relative_error}${line.worst ? `, of ${line.worst}` : ''}` : '';
    return [[of, because].filter(Boolean).join('; '), error].filter(Boolean);
  }

  const values = found => Object.entries(found).filter(([key]) => !['modes', 'boundary_modes', 'mode', 'status', 'margin'].includes(key))
    .map(([key, value]) => typeof value === 'object' && !Array.isArray(value)
      ? Object.entries(value).map(([name, x]) => `${name} = ${listed(x)}`).join(', ') : `${key} = ${listed(value)}`).join('; ');

  function lineShown(line) {
    const one = 'solutions' in line ? 'solution' : 'motion';
    const found = [...line.found ?? [], ...line.continua ?? []];
    const item = make('li', { className: 'verdict' },
      make('p', {}, make('strong', { className: `is-${line.verdict}`, textContent: line.verdict }), ` ${said[line.verdict](one)}`),
      ...reasons(line).map(text => make('p', { textContent: text + '.' })));
    if (found.length) {
      item.append(make('p', { textContent: `All ${one}s:` }), make('ul', {}, ...found.map(each =>
        make('li', { textContent: `${[...each.modes ?? [each.mode], ...each.boundary_modes ?? []].filter(Boolean).join(', ')}: ${values(each)}` }))));
    }
    item.append(make('details', {}, make('summary', { textContent: 'As certify prints it' }), make('code', { textContent: JSON.stringify(line) })));
    return item;
  }

  /// A record of the first motion, in decimals, as a solver would write it.
  function recordOf({ solve }) {
    const motion = solve.motions?.[0];
    if (!motion) return '';
    const numbers = Object.entries({ ...motion.accelerations, ...motion.forces });
    const decimals = numbers.map(([, text]) => text.split('/').map(Number)).map(([p, q = 1]) => String(p / q));
    return `${numbers.map(([name]) => name).join(',')}\n${decimals.join(',')}\n`;
  }

  return {
    /// `judge(text)` is what the library answers; `present()` the answer that the page shows.
    wire(judge, present) {
      const run = () => {
        const { judged, mistakes } = judge(by('pasted').value);
        by('pasted-mistakes').textContent = (mistakes ?? []).join('\n');
        by('judged').replaceChildren(...(judged ?? []).map(lineShown));
      };
      const offer = (name, text) => {
        const button = make('button', { type: 'button', textContent: name });
        button.addEventListener('click', () => {
          by('pasted').value = text();
          run();
        });
        by('examples').append(button);
      };
      for (const [name, text] of examples) offer(name, () => text);
      offer('a record of this scene', () => recordOf(present()));
      by('judge').addEventListener('click', run);
    },
  };
})();
