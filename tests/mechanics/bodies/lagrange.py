#!/usr/bin/env python3
"""Random trees and loops of bodies that turn and slide: slipproof's accelerations are those of Lagrange's equations, which
an independent computer algebra system (SymPy) forms and solves, to the last digit.

    lagrange.py SLIPPROOF [COUNT [SEED]]

Each system is drawn as bodies with exact numbers: 1 to 6 bodies, pinned to the ground, to each other or to nothing, in
every third system closed to a loop by a rod, moved by gravity, a force that follows a body, a couple and a spring. Points
and discs near lines of the ground and of other bodies, and near discs, have gaps and slips, whose derivatives are compared,
too. Lagrange's side knows positions as functions of generalised coordinates, and nothing else.
"""
import json
import random
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import sympy as sp
except ImportError:
    sys.exit(77)  # not asked

t = sp.Symbol("t")


def number(rng, low=-3, high=3):
    return sp.Rational(rng.randint(4 * low, 4 * high), rng.choice([1, 2, 3, 4]) * 4)


def circle(rng):
    """A rational point of the circle: tan of half the angle is rational."""
    half = sp.Rational(rng.randint(-6, 6), rng.randint(1, 5))
    return (1 - half**2) / (1 + half**2), 2 * half / (1 + half**2)


def turn(angle, point):
    return (sp.cos(angle) * point[0] - sp.sin(angle) * point[1], sp.sin(angle) * point[0] + sp.cos(angle) * point[1])


class System:
    """Bodies with generalised coordinates; positions are functions of these."""

    def __init__(self, rng):
        self.rng, self.q, self.at_q, self.at_v = rng, [], {}, {}
        self.bodies, self.joints, self.text = [], [], []
        self.count = rng.randint(1, 6)
        for index in range(self.count):
            self.add_body(index)
        self.constraint, self.touched = None, set()

    def coordinate(self, name, value, velocity):
        q = sp.Function(name)(t)
        self.q.append(q)
        self.at_q[q], self.at_v[q] = value, velocity
        return q

    def add_body(self, index):
        rng = self.rng
        c, s = circle(rng)
        angle = self.coordinate(f"q{index}", sp.Symbol(f"theta{index}"), number(rng))
        own = number(rng), number(rng)  # of the joint, in the body's axes
        parent = None
        if index > 0 or rng.random() < 0.5:
            parent = rng.randrange(-1, index)  # -1: the ground
        if parent is None:
            at = self.coordinate(f"x{index}", number(rng), number(rng)), self.coordinate(f"y{index}", number(rng), number(rng))
            hinge = None
        else:
            hinge = number(rng), number(rng)
            place = hinge if parent < 0 else self.point(parent, hinge)
            arm = turn(angle, own)
            at = place[0] - arm[0], place[1] - arm[1]
        self.bodies.append(dict(angle=angle, at=at, mass=sp.Rational(rng.randint(1, 9), 2), inertia=sp.Rational(rng.randint(1, 9), 3),
                                circle=(c, s), parent=parent, own=own, hinge=hinge))

    def point(self, body, own):
        if body < 0:
            return own
        b = self.bodies[body]
        arm = turn(b["angle"], own)
        return b["at"][0] + arm[0], b["at"][1] + arm[1]

    def now(self, expression, accelerations=None):
        """The value at the instant, exactly."""
        e = sp.sympify(expression)
        for q in self.q:
            if accelerations is not None:
                e = e.subs(sp.diff(q, t, 2), accelerations[q])
        for q in self.q:
            e = e.subs(sp.diff(q, t), self.at_v[q])
        e = e.subs(self.at_q)
        for index, b in enumerate(self.bodies):
            theta = sp.Symbol(f"theta{index}")
            e = e.subs({sp.cos(theta): b["circle"][0], sp.sin(theta): b["circle"][1]})
        return sp.nsimplify(e) if e.is_Float else sp.simplify(e) if e.free_symbols else e


def name(body):
    return "ground" if body < 0 else f"b{body}"


def pair(values):
    return "[" + ", ".join(f'"{v}"' for v in values) + "]"


def body_text(system, index):
    b = system.bodies[index]
    at = [system.now(x) for x in b["at"]]
    velocity = [system.now(sp.diff(x, t)) for x in b["at"]]
    return (f'[[body]]\nname = "{name(index)}"\nmass = "{b["mass"]}"\ninertia = "{b["inertia"]}"\nat = {pair(at)}\n'
            f'angle = {pair(b["circle"])}\nvelocity = {pair(velocity)}\nspin = "{system.at_v[b["angle"]]}"\n')


def draw(system):
    """The scene as text, with the generalised forces and the quantities that are compared."""
    rng, n = system.rng, system.count
    rod = loop(system)
    gravity = number(rng), number(rng)
    text = ['schema = "slipproof/mechanism/1"', 'name = "random bodies"', f"gravity = {pair(gravity)}"]
    text += [body_text(system, i) for i in range(n)]
    for i, b in enumerate(system.bodies):
        if b["parent"] is not None:
            text.append(f'[[joint]]\nname = "pin{i}"\nkind = "pin"\nbetween = ["{name(b["parent"])}", "{name(i)}"]\n'
                        f'at = {pair(b["hinge"])}\nto = {pair(b["own"])}\n')
    forces = []  # (point as a function of q, force): generalised forces are force . d point / d q
    for i, b in enumerate(system.bodies):
        forces.append((b["at"], (b["mass"] * gravity[0], b["mass"] * gravity[1])))
    pushed, own, force = rng.randrange(n), (number(rng), number(rng)), (number(rng), number(rng))
    text.append(f'[[force]]\non = "{name(pushed)}"\nat = {pair(own)}\nis = {pair(force)}\naxes = "body"\n')
    forces.append((system.point(pushed, own), turn(system.bodies[pushed]["angle"], force)))
    turned, couple = rng.randrange(n), number(rng)
    text.append(f'[[torque]]\non = "{name(turned)}"\nis = "{couple}"\n')
    couples = [(system.bodies[turned]["angle"], couple)]
    text += [rod] if rod else []
    quantities = contacts(system, text)
    held = {i for i, b in enumerate(system.bodies) if b["parent"] is not None} | {b["parent"] for b in system.bodies}
    held |= {system.count - 1} if rod else set()
    if not set(range(n)) <= held | system.touched:
        return None  # slipproof refuses a body that nothing holds
    return "\n".join(text), forces, couples, quantities


def loop(system):
    """A rod from the last body to the ground, of rational length and direction; the spin of that body, which nothing else
    depends on, is such that the rod's ends do not move apart."""
    rng = system.rng
    if rng.randrange(3) != 0 or len(system.q) < 3:
        return None
    last = system.count - 1
    angle = system.bodies[last]["angle"]
    own, length, along = (number(rng), number(rng)), sp.Rational(rng.randint(2, 9), 2), circle(rng)
    end = system.point(last, own)
    per_spin = sum(e * system.now(sp.diff(x, angle)) for e, x in zip(along, end))
    if per_spin == 0:
        return None
    system.at_v[angle] = sp.Integer(0)
    system.at_v[angle] = -sum(e * system.now(sp.diff(x, t)) for e, x in zip(along, end)) / per_spin
    fixed = [system.now(x) - length * e for x, e in zip(end, along)]
    system.constraint = ((end[0] - fixed[0]) ** 2 + (end[1] - fixed[1]) ** 2) / 2
    return (f'[[joint]]\nname = "rod"\nkind = "rod"\nbetween = ["{name(last)}", "ground"]\nat = {pair(own)}\n'
            f'to = {pair(fixed)}\nlength = "{length}"\n')


def contacts(system, text):
    """Open contacts of points and discs with lines and discs: name, gap, sliding velocity as functions of time."""
    rng, result = system.rng, []
    for k in range(3):
        of = rng.randrange(system.count)
        on = rng.choice([-1] + [i for i in range(system.count) if i != of])
        system.touched |= {of, on}
        own, radius = (number(rng), number(rng)), rng.choice([0, sp.Rational(rng.randint(1, 4), 4)])
        centre = system.point(of, own)
        spin_of = sp.diff(system.bodies[of]["angle"], t)
        spin_on = 0 if on < 0 else sp.diff(system.bodies[on]["angle"], t)
        on_angle = sp.Integer(0) if on < 0 else system.bodies[on]["angle"]
        normal = circle(rng)
        n = turn(on_angle, normal)
        along = n[1], -n[0]
        through = [number(rng), number(rng)]
        base = system.point(on, through)
        distance = n[0] * (centre[0] - base[0]) + n[1] * (centre[1] - base[1]) - radius
        if system.now(distance) <= 0:  # the line moves back until there is room
            shift = system.now(distance) - 1
            through = [through[0] + shift * normal[0], through[1] + shift * normal[1]]
            base = system.point(on, through)
            distance = n[0] * (centre[0] - base[0]) + n[1] * (centre[1] - base[1]) - radius
        # as an observer on the line's body sees the centre; the rim of the disc turns beside that
        seen = along[0] * (centre[0] - base[0]) + along[1] * (centre[1] - base[1])
        sliding = sp.diff(seen, t) + radius * (spin_of - spin_on)
        text.append(f'[[contact]]\nname = "c{k}"\nof = "{name(of)}"\npoint = {pair(own)}\n'
                    + (f'radius = "{radius}"\n' if radius else "")
                    + f'on = "{name(on)}"\nnormal = {pair(normal)}\nthrough = {pair(through)}\nfriction = "1/2"\nstate = "open"\n')
        result.append((f"c{k}", distance, sliding))
    return result


def lagrange(system, forces, couples):
    """The second derivatives of the coordinates."""
    kinetic = 0
    for b in system.bodies:
        v = [sp.diff(x, t) for x in b["at"]]
        kinetic += b["mass"] * (v[0] ** 2 + v[1] ** 2) / 2 + b["inertia"] * sp.diff(b["angle"], t) ** 2 / 2
    unknown = {q: sp.Symbol(f"dd_{q.func}") for q in system.q}
    multiplier = sp.Symbol("multiplier")
    equations = []
    for q in system.q:
        rate = sp.diff(q, t)
        force = sum(f[0] * sp.diff(p[0], q) + f[1] * sp.diff(p[1], q) for p, f in forces)
        force += sum(m for angle, m in couples if angle == q)
        if system.constraint is not None:
            force += multiplier * sp.diff(system.constraint, q)
        equations.append(system.now(sp.diff(sp.diff(kinetic, rate), t) - sp.diff(kinetic, q) - force, unknown))
    unknowns = list(unknown.values())
    if system.constraint is not None:
        equations.append(system.now(sp.diff(system.constraint, t, 2), unknown))
        unknowns.append(multiplier)
    matrix, right = sp.linear_eq_to_matrix([sp.expand(e) for e in equations], unknowns)
    if matrix.det() == 0:
        return None
    solution = matrix.LUsolve(right)
    return {q: solution[i] for i, q in enumerate(system.q)}


def solved(program, text, folder):
    (folder / "m.toml").write_text(text)
    (folder / "s.toml").write_text('name = "s"\nmechanism = "m.toml"\n[values]\n')
    run = subprocess.run([program, "solve", folder / "s.toml", "--json"], capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"{text}\n{run.stderr}")
    document = json.loads(run.stdout)
    assert len(document["motions"]) == 1, text
    return {key: sp.Rational(value) for key, value in document["motions"][0]["accelerations"].items()}


def main():
    program, count = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 200
    rng = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 38)
    done = loops = 0
    with tempfile.TemporaryDirectory() as folder:
        while done < count:
            system = System(rng)
            drawn = draw(system)
            if drawn is None:
                continue
            text, forces, couples, quantities = drawn
            accelerations = lagrange(system, forces, couples)
            if accelerations is None:
                continue
            found = solved(program, text, Path(folder))
            expected = {}
            for i, b in enumerate(system.bodies):
                suffix = "" if system.count == 1 else f"_{name(i)}"
                expected["ax" + suffix] = system.now(sp.diff(b["at"][0], t, 2), accelerations)
                expected["ay" + suffix] = system.now(sp.diff(b["at"][1], t, 2), accelerations)
                expected["alpha" + suffix] = system.now(sp.diff(b["angle"], t, 2), accelerations)
            for contact, gap, sliding in quantities:
                expected["gap_" + contact] = system.now(sp.diff(gap, t, 2), accelerations)
                expected["slip_" + contact] = system.now(sp.diff(sliding, t), accelerations)
            for key, value in expected.items():
                if found[key] != value:
                    sys.exit(f"{text}\n{key}: slipproof says {found[key]}, Lagrange's equations say {value}")
            done += 1
            loops += system.constraint is not None
    print(f"{done} systems, {loops} of them loops: every acceleration, gap and slip is the same rational")


main()
