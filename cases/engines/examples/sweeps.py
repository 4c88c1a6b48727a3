"""A small engine of its own, as an example of an adapter: bodies, contacts, and sweeps over the contacts.

It has no joints. Each sweep gives every contact the force along its normal, then the one along its tangent, that stops
it, within Coulomb's bounds. What it answers is the acceleration itself: it needs no step.
"""

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parent.parent / "adapters"))
from adapter import Refused, run  # noqa: E402

SWEEPS = 2000


def arm(body, contact):
    return [p - q for p, q in zip(contact["at"], body["at"])]


def speed(body, along, r):
    a = body["a"]
    return along[0] * (a[0] - a[2] * r[1]) + along[1] * (a[1] + a[2] * r[0])


def inverse(body):
    return [1 / body["mass"] if "mass" in body else 0, 1 / body["inertia"] if "inertia" in body else 0]


def push(body, force, r):
    m, i = inverse(body)
    body["a"][0] += m * force[0]
    body["a"][1] += m * force[1]
    body["a"][2] += i * (r[0] * force[1] - r[1] * force[0])


def compliance(body, along, r):
    m, i = inverse(body)
    return m + i * (r[0] * along[1] - r[1] * along[0]) ** 2


def ask(line):
    world = line["ask"]["world"]
    if len(world["gravity"]) == 3:
        raise Refused("a scene in space")
    if world["joints"] or world["friction"]:
        raise Refused("it has contacts only")
    bodies = world["bodies"]
    for body in bodies:
        body["a"] = list(body.get("acceleration", world["gravity"])) + [body.get("turning", 0)]
        push(body, body["force"], [0, 0])
        body["a"][2] += inverse(body)[1] * body["torque"]
    forces = {c["name"]: [0, 0] for c in world["contacts"]}
    sweeps = line["ask"]["iterations"] or SWEEPS
    for _ in range(sweeps):
        for c in world["contacts"]:
            solve(bodies, c, forces[c["name"]])
    motion = {n[0]: n[1] * a for b in bodies for n, a in zip(b["names"], b["a"]) if n}
    named = {name: f for c in world["contacts"] for name, f in zip(c["forces"], forces[c["name"]])}
    return motion, named, {"sweeps": sweeps}


def solve(bodies, contact, force):
    of, on = bodies[contact["of"]], bodies[contact["on"]]
    r, s = arm(of, contact), arm(on, contact)
    for k, along in enumerate((contact["normal"], contact["tangent"])):
        given = compliance(of, along, r) + compliance(on, along, s)
        wanted = force[k] - (speed(of, along, r) - speed(on, along, s)) / given
        bound = contact["friction"] * force[0]
        change = (max(wanted, 0) if k == 0 else min(max(wanted, -bound), bound)) - force[k]
        force[k] += change
        push(of, [change * x for x in along], r)
        push(on, [-change * x for x in along], s)


if __name__ == "__main__":
    run("sweeps", "1", "cone, by sweeps over accelerations", ask)
