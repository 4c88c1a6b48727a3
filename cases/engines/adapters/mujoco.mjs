// MuJoCo 3 in space, as WebAssembly: the accelerations of mj_forward, as mujoco.cpp asks an older one. By default its own:
// pyramidal cones, impedance 0.9 at gap 0. With many iterations elliptic cones, impedance 0.9999, tolerance 0. With the
// argument `shapes` contacts are those of the whole shapes of a body on the floor.
import { Refused, engine, inAxes, run, turnAfter, watch } from "./adapter.mjs";

const { module: load, version } = await engine("mujoco-js");
const mujoco = await load();
const words = (v) => v.join(" ");
const hard = (q) => (q.iterations ? " solimp='0.9999 0.9999 0.001 0.5 2'" : "");

function wholeShapes(q, index) {
  const friction = `friction='${q.contacts[0].friction}' condim='3'${hard(q)}`;
  if (index === 0) return `<geom type='plane' size='1 1 1' ${friction}/>`;
  return q.shapes.map((shape) => {
    if (shape.hull) throw new Refused("the adapter has no hulls");
    const size = shape.box ? `type='box' size='${words(shape.box.map((s) => s / 2))}'` : `type='sphere' size='${shape.sphere}'`;
    return `<geom ${size} pos='${words(shape.at)}' quat='${words(shape.turn)}' ${friction}/>`;
  }).join("");
}

/** A sphere on one body, and a box on the other, which touch in the contact's point; the sphere overlaps by a little. */
function touching(q, index) {
  return q.contacts.map((c, i) => {
    const sphere = `<geom name='disc${i}' type='sphere' size='${c.disc + 1e-9 * q.size}' pos='${words(c.centre)}' contype='0' conaffinity='0'/>`;
    const middle = c.face.map((p, k) => p - c.half * c.normal[k]);
    const box = `<geom name='box${i}' type='box' size='${words([c.half, c.half, c.half])}' pos='${words(middle)}' zaxis='${words(c.normal)}' contype='0' conaffinity='0'/>`;
    return (c.of === index ? sphere : "") + (c.on === index ? box : "");
  }).join("");
}

/** Bodies have the axes of the scene, so that spins and couples need no turning. */
function describe(q) {
  const geoms = q.shapes ? wholeShapes : touching;
  const bodies = q.bodies.map((body, i) => {
    if (i === 0) return geoms(q, i);
    if (body.prescribed && [body.velocity, body.spin, body.acceleration, body.turning].flat().some((x) => x !== 0)) {
      throw new Refused("a body that moves as prescribed");
    }
    const [x, y, z] = body.at; // a whole shape overlaps the floor by a little
    const inertia = body.prescribed ? "" : `<freejoint/><inertial pos='0 0 0' quat='${words(body.turn)}' mass='${body.mass}' diaginertia='${words(body.inertia)}'/>`;
    return `<body name='b${i}' pos='${words(q.shapes ? [x, y, z - 1e-9 * q.size] : body.at)}'>${inertia}${geoms(q, i)}</body>`;
  });
  const pairs = q.shapes ? [] : q.contacts.map((c, i) =>
    `<pair geom1='box${i}' geom2='disc${i}' friction='${c.friction} ${c.friction} 0 0 0'${hard(q)}/>`);
  const exact = q.iterations ? ` cone='elliptic' solver='Newton' tolerance='0' iterations='${q.iterations}'` : "";
  return `<mujoco><option gravity='${words(q.gravity)}' timestep='${q.step}'${exact}/><worldbody>${bodies.join("")}</worldbody><contact>${pairs.join("")}</contact></mujoco>`;
}

function ask(q) {
  if (q.joints.length > 0) throw new Refused("the adapter has no joints");
  mujoco.FS.writeFile("scene.xml", describe(q));
  const model = mujoco.MjModel.loadFromXML("scene.xml"), data = new mujoco.MjData(model);
  let next = 0; // free bodies stand in the order of the scene, with six velocities each
  const first = q.bodies.map((body) => (body.prescribed ? -1 : (next += 6) - 6));
  q.bodies.forEach((body, i) => {
    if (body.prescribed) return;
    data.qvel.set([...body.velocity, ...body.spin], first[i]);
    data.qfrc_applied.set([...body.force, ...body.torque], first[i]);
  });
  mujoco.mj_forward(model, data);
  const acceleration = Array.from(data.qacc);
  const velocities = q.bodies.map((body, i) => [...body.velocity, ...body.spin].map((v, k) =>
    (body.prescribed ? v : v + q.step * acceleration[first[i] + k])));
  const again = () => {
    mujoco.mj_step(model, data);
    mujoco.mj_kinematics(model, data); // where bodies are after it, not before
  };
  if (q.watch) again();
  const cut = (array, width, from) => Array.from(array.subarray(from, from + width));
  // The spins of a free body are in its own axes.
  const watched = watch(q, again, (i) => {
    const turned = cut(data.xquat, 4, 4 * i), [w, ...axis] = turned;
    return { at: cut(data.xpos, 3, 3 * i), turn: turnAfter(turned, q.bodies[i].turn), velocity: cut(data.qvel, 3, first[i]),
             spin: inAxes([w, ...axis.map((x) => -x)], cut(data.qvel, 3, first[i] + 3)) };
  });
  const settings = { cone: q.iterations ? "elliptic" : "pyramidal", iterations: model.opt.iterations, impedance: q.iterations ? 0.9999 : 0.9 };
  data.delete();
  model.delete();
  return { velocities, contacts: null, watched, settings };
}

const name = process.argv[2] === "shapes" ? "mujoco3-shapes" : "mujoco3";
const law = "associated, soft: by the impedance in the settings a contact gives way; a pyramid or an elliptic cone, as the settings say";
await run({ name, version: `${mujoco.mj_versionString()} (mujoco-js ${version})`, ask, law: "",
            lawInSpace: `${law}${name === "mujoco3" ? "" : ", at the contacts of whole shapes"}; the accelerations from rest` });
