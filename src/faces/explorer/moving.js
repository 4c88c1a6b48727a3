'use strict';
// The pictures in motion: their parts say how the bodies begin to move (data-about, data-velocity, data-acceleration;
// of a line between two bodies for either end), and how far an opening contact is drawn apart (data-opens).
const moving = (() => {
  const seconds = 0.5, slower = 4, pause = 700;      // of the scene; times; milliseconds at the end
  const farthest = 34;                               // pixels of the picture that the largest movement has
  const still = matchMedia('(prefers-reduced-motion: reduce)');
  let drawings = [], parts = [], scale = 1, on = false, started = 0, frame = 0;

  const numbers = text => text.split(' ').map(Number);
  const after = (part, t) => part.velocity.map((v, i) => scale * (v * t + part.acceleration[i] * t * t / 2));
  const movement = (data, end) => ({ about: numbers(data.about).slice(2 * end), velocity: numbers(data.velocity).slice(3 * end, 3 * end + 3),
    acceleration: numbers(data.acceleration).slice(3 * end, 3 * end + 3) });

  function place(part, [x, y], t) {  // of a point of the part's body
    const [dx, dy, turn] = after(part, t), [ax, ay] = part.about, [c, s] = [Math.cos(turn), Math.sin(turn)];
    return [ax + dx + c * (x - ax) - s * (y - ay), ay + dy + s * (x - ax) + c * (y - ay)];
  }

  function spoke(circle) {  // shows how it turns
    const [x, y, r] = ['cx', 'cy', 'r'].map(name => Number(circle.getAttribute(name)));
    const line = document.createElementNS('http://www.w3.org/2000/svg', 'path');
    for (const [name, text] of Object.entries({ class: 'chain spoke', d: `M${x},${y - r}V${y + r}M${x - r},${y}H${x + r}` })) line.setAttribute(name, text);
    for (const { name, value } of circle.attributes) if (name.startsWith('data-')) line.setAttribute(name, value);
    circle.after(line);
  }

  function read() {
    for (const drawing of drawings) {
      drawing.querySelectorAll('.spoke').forEach(line => line.remove());
      if (on) drawing.querySelectorAll('circle.body[data-about]').forEach(spoke);
      drawing.classList.toggle('moves-now', on);
    }
    parts.filter(part => part.end).forEach(part => part.element.setAttribute('d', part.still));
    parts = drawings.flatMap(drawing => [...drawing.querySelectorAll('[data-about]')]).map(element => {
      const part = { element, ...movement(element.dataset, 0) };
      if (part.about.length === 2) return part;
      const still = element.getAttribute('d'), [x, y, u, v] = still.match(/-?[\d.]+/g).map(Number);
      return { ...part, end: movement(element.dataset, 1), still, from: [x, y], to: [u, v] };
    });
    const surfaces = drawings.flatMap(drawing => [...drawing.querySelectorAll('[data-opens]')]);
    parts.push(...surfaces.map(element => ({ element, opens: numbers(element.dataset.opens) })));
    scale = 1;
    const far = Math.max(0, ...parts.filter(part => part.about).map(part => Math.hypot(...after(part, seconds).slice(0, 2))));
    scale = far > 0 ? Number((farthest / far).toPrecision(1)) : 1;
  }

  function put(t) {
    for (const part of parts) {
      if (part.opens) {
        const left = t === null ? 0 : 1 - (t / seconds) ** 2;
        part.element.setAttribute('transform', `translate(${part.opens.map(x => -x * left)})`);
        continue;
      }
      if (part.end) {
        part.element.setAttribute('d', t === null ? part.still : `M${place(part, part.from, t)}L${place(part.end, part.to, t)}`);
        continue;
      }
      const [x, y, turn] = t === null ? [0, 0, 0] : after(part, t);
      part.element.setAttribute('transform', `translate(${x} ${y}) rotate(${turn * 180 / Math.PI} ${part.about})`);
    }
  }

  function step(now) {
    frame = requestAnimationFrame(step);
    put(Math.min((now - started) % (1000 * seconds * slower + pause) / 1000 / slower, seconds));
  }

  function words() {
    if (!on) return '';
    const size = scale === 1 ? '' : scale > 1 ? `, drawn ${scale} times as large` : `, drawn ${scale} times as small`;
    return `Half a second of these accelerations${still.matches ? ', its end' : `, ${slower} times slower`}${size}. ` +
      'A contact that opens is drawn apart as in the picture at rest. In truth modes may change at any time.';
  }

  function show() {
    cancelAnimationFrame(frame);
    read();
    if (!on) return put(null);
    if (still.matches) return put(seconds);
    frame = requestAnimationFrame(step);
  }

  return {
    /// Takes the pictures that are shown now; false if none of them can move.
    take(all) {
      drawings = all;
      const can = drawings.some(drawing => drawing.querySelector('[data-about]'));
      if (on || parts.length) show();
      return can;
    },
    turn(to) {
      on = to;
      started = performance.now();
      show();
    },
    isOn: () => on,
    startsByItself: () => !still.matches,
    words,
  };
})();
