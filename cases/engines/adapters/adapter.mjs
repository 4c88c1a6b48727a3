// What adapters in JavaScript share: reads the lines, gives each scene to the engine, writes the answers. A scene comes
// as the driver's `world` (asking/world.py, asking/space.py): everything in the axes of the scene; body 0 is the ground.
import { createInterface } from "node:readline";
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";
import { createRequire } from "node:module";

/** Why an engine cannot have a scene. */
export class Refused extends Error {}

const require = createRequire(pathToFileURL(`${process.cwd()}/`)); // packages are where the driver starts adapters

/** A package of npm: its module, or a file of it, and its version. */
export async function engine(name, file) {
  const root = `${process.cwd()}/node_modules/${name}`;
  const { version } = JSON.parse(readFileSync(`${root}/package.json`, "utf8"));
  const module = await import(pathToFileURL(file ? `${root}/${file}` : require.resolve(name)));
  return { version, module: module.default ?? module };
}

export const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/** The shortest turn, as x y z w, that brings one direction in space into another. */
export function turnBetween(from, to) {
  const w = 1 + dot(from, to);
  const other = Math.abs(from[0]) < 0.5 ? [1, 0, 0] : [0, 1, 0];
  const [x, y, z] = w > 1e-9 ? cross(from, to) : cross(from, other);
  const length = Math.hypot(x, y, z, w > 1e-9 ? w : 0);
  return [x / length, y / length, z / length, (w > 1e-9 ? w : 0) / length];
}

/** Whether a body is free, turns freely, or moves as prescribed, and how it moves after the step where prescribed. */
function withKind(body, step) {
  const free = "mass" in body, turns = "inertia" in body;
  const after = free ? body.velocity : body.velocity.map((v, i) => v + step * body.acceleration[i]);
  return { ...body, free, turns, prescribed: !free && !turns, velocity: body.velocity, velocityAfter: after,
           spinAfter: turns ? body.spin : Array.isArray(body.spin) ? body.spin.map((w, i) => w + step * body.turning[i]) :
             body.spin + step * body.turning };
}

function question(line) {
  const { step, iterations, world } = line.ask;
  const bodies = world.bodies.map((body) => withKind(body, step));
  const arm = (body, point) => point.map((p, i) => p - bodies[body].at[i]);
  // For engines that find contacts themselves: a disc of the contact's own radius, or a small one, touches a square of
  // `half` its width in the middle of its upper side. `overlap` is there so that binary32 sees no gap.
  const contacts = world.contacts.map((c) => {
    const radius = c.radius > 0 ? c.radius : Math.max(0.05 * world.size, 0.001);
    return { ...c, disc: radius, half: Math.max(radius, 0.01), overlap: 1e-6 * world.size, face: arm(c.on, c.at),
             centre: arm(c.of, c.at.map((p, i) => p + radius * c.normal[i])) };
  });
  return { ...world, step, iterations, impact: "impact" in line, watch: line.ask.watch, bodies, contacts, arm, inSpace: world.gravity.length === 3 };
}

/** Accelerations by the names of the unknowns, from the velocities after the step; of an impact these. */
function motion(q, velocities) {
  const named = q.bodies.slice(1).flatMap((body, i) => {
    const before = [...body.velocity, body.spin].flat();
    return body.names.flatMap((name, k) =>
      name ? [[name[0], name[1] * (q.impact ? velocities[i + 1][k] : (velocities[i + 1][k] - before[k]) / q.step)]] : []);
  });
  return Object.fromEntries(named);
}

/** Forces by their names, from [normal, tangential] of each contact, in space with two of these; null where the engine
 * tells none. */
function forces(q, pairs) {
  if (!pairs) return null;
  const scale = q.impact ? q.step : 1; // adapters tell impulses over the step
  return Object.fromEntries(q.contacts.flatMap((c, i) => c.forces.map((name, k) => [name, scale * pairs[i][k]])));
}

/** The product of two turns, w x y z: first `b`, then `a`. */
export function turnAfter(a, b) {
  const [v, w] = [a.slice(1), b.slice(1)], across = cross(v, w);
  return [a[0] * b[0] - dot(v, w), ...across.map((x, i) => x + a[0] * w[i] + b[0] * v[i])];
}

/** A vector of the scene in axes that `turn`, w x y z, brings there. */
export function inAxes([w, ...axis], vector) {
  const once = cross(vector, axis), twice = cross(once, axis);
  return vector.map((x, i) => x + 2 * (w * once[i] + twice[i]));
}

/** Kinetic energy and potential energy above the place at the start. */
function energy(q, body, { at, turn, velocity, spin }) {
  const turning = inAxes(turn, spin).reduce((sum, w, i) => sum + body.inertia[i] * w * w, 0);
  return (body.mass * dot(velocity, velocity) + turning) / 2 - body.mass * dot(q.gravity, at.map((p, i) => p - body.at[i]));
}

/** Over steps of which the first is made. `drift`: how far a body is from where it began after 1, 10 and 100 steps, over
 * the size. `energy`: by how much it has risen at most above that of an earlier step or the start, up to 1, 10, 100 and
 * 1,000 steps, over that at the start and what would lift all bodies by the size. `again()` makes one more step, pushes
 * included, and `pose(i)` gives `at`, `turn` (w x y z, which brings the principal axes into the scene), `velocity` and
 * `spin` of a body. Nothing unless it is asked. */
export function watch(q, again, pose) {
  if (!q.watch) return null;
  const ofEnergy = q.watch === "energy", watched = {}, bodies = q.bodies.slice(1);
  const total = (poseOf) => bodies.reduce((sum, body, i) => sum + energy(q, body, poseOf(i + 1)), 0);
  const before = ofEnergy ? total((i) => q.bodies[i]) : 0;
  const lift = bodies.reduce((sum, body) => sum + (body.mass ?? 0), 0) * Math.hypot(...q.gravity) * q.size;
  const moved = () => Math.max(...bodies.map((body, i) => Math.hypot(...pose(i + 1).at.map((p, k) => p - body.at[k])))) / q.size;
  for (let n = 1, lowest = before, rise = 0; n <= (ofEnergy ? 1000 : 100); n += 1) {
    if (n > 1) again();
    const now = ofEnergy ? total(pose) : 0;
    [rise, lowest] = [Math.max(rise, now - lowest), Math.min(lowest, now)];
    if ([1, 10, 100, 1000].includes(n)) watched[n] = ofEnergy ? rise / (before + lift) : moved();
  }
  return watched;
}

function answer({ name, version, law, lawInSpace, ask }, line) {
  const head = { schema: "slipproof/engine-answer/1", engine: name, version, scene: line.name };
  const q = question(line);
  try {
    if (q.inSpace && !lawInSpace) throw new Refused("a scene in space");
    const { velocities, contacts, settings, watched } = ask(q);
    if (q.watch && !watched) throw new Refused("the adapter makes one step only");
    if (q.watch) return { ...head, settings: { ...settings, step: q.step }, [q.watch]: watched, law: q.inSpace ? lawInSpace : law };
    return { ...head, settings: { ...settings, step: q.step }, motion: motion(q, velocities),
             forces: forces(q, contacts), law: q.inSpace ? lawInSpace : law };
  } catch (error) {
    if (error instanceof Refused) return { ...head, refused: error.message };
    throw error;
  }
}

/** Answers all lines of standard input. `ask(q)` gives `velocities`, [x, y, spin] of each body after the step, in space
 * [x, y, z] and the spin about these; `contacts`, [normal, tangential] force of each contact or null, and `settings`. */
export async function run(adapter) {
  for await (const line of createInterface({ input: process.stdin })) {
    process.stdout.write(`${JSON.stringify(answer(adapter, JSON.parse(line)))}\n`);
  }
}
