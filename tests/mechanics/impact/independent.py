#!/usr/bin/env python3
"""Random impacts in the plane: all outcomes of `slipproof impact` are those of an enumeration in fractions.

    independent.py SLIPPROOF [COUNT [SEED]]

One or two bodies touch the ground and each other at one to three points, with random velocities, by each law in turn. Here
the impulses of each mode are a polyhedron, whose corners are found by trying all sets of conditions that hold with
equality. Velocities after, their energies, and whether a mode leaves velocities open must be the same. Poisson's law is
solved in two problems; where compression leaves impulses open, it is not compared, but counted.
"""
import json
import random
import subprocess
import sys
import tempfile
from collections import Counter
from fractions import Fraction as Q
from itertools import combinations, product
from pathlib import Path

UNITS = [(Q(1), Q(0)), (Q(3, 5), Q(4, 5)), (Q(4, 5), Q(-3, 5)), (Q(5, 13), Q(12, 13)), (Q(-7, 25), Q(24, 25)), (Q(0), Q(1))]


def dot(a, b):
    return sum((x * y for x, y in zip(a, b)), Q(0))


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def turned(angle, own):
    c, s = angle
    return (c * own[0] - s * own[1], s * own[0] + c * own[1])


class Body:
    def __init__(self, rng, name):
        self.name, self.angle = name, rng.choice(UNITS)
        self.mass, self.inertia = Q(rng.randint(1, 6), 2), Q(rng.randint(1, 6), 3)
        self.at = (Q(rng.randint(-3, 3)), Q(rng.randint(-3, 3)))
        self.velocity = (Q(rng.randint(-4, 4), 2), Q(rng.randint(-4, 4), 2))
        self.spin = Q(rng.randint(-3, 3))

    def text(self):
        pair = lambda p: f'["{p[0]}", "{p[1]}"]'
        return (f'[[body]]\nname = "{self.name}"\nmass = "{self.mass}"\ninertia = "{self.inertia}"\nat = {pair(self.at)}\n'
                f'angle = {pair(self.angle)}\nvelocity = {pair(self.velocity)}\nspin = "{self.spin}"\n')


class Contact:
    """A point of one body on a line of the ground (None) or of the other."""

    def __init__(self, rng, name, of, on):
        self.name, self.of, self.on = name, of, on
        own = (Q(rng.randint(-4, 4), 2), Q(rng.randint(-4, 4), 2))
        arm = turned(of.angle, own)
        place = (of.at[0] + arm[0], of.at[1] + arm[1])
        own_normal = rng.choice(UNITS)
        through, normal = place, own_normal
        if on is not None:
            apart = (place[0] - on.at[0], place[1] - on.at[1])
            through = turned((on.angle[0], -on.angle[1]), apart)
            normal = turned(on.angle, own_normal)
        self.normal, self.tangent = normal, (normal[1], -normal[0])
        self.arms = [arm, None if on is None else (place[0] - on.at[0], place[1] - on.at[1])]
        self.e, self.et = Q(rng.randint(0, 4), 4), rng.choice((Q(0), Q(0), Q(1, 2), Q(1)))
        self.mu = rng.choice((Q(0), Q(1, 4), Q(1, 2), Q(1), Q(3)))
        self.own, self.own_normal, self.through = own, own_normal, through

    def row(self, bodies, direction):
        row = []
        for body in bodies:
            factor = 1 if body is self.of else -1 if body is self.on else 0
            arm = self.arms[0] if body is self.of else self.arms[1] or (Q(0), Q(0))
            row += [factor * direction[0], factor * direction[1], factor * cross(arm, direction)]
        return row

    def text(self, law):
        pair = lambda p: f'["{p[0]}", "{p[1]}"]'
        text = f'[[contact]]\nname = "{self.name}"\nof = "{self.of.name}"\npoint = {pair(self.own)}\n'
        if self.on is not None:
            text += f'on = "{self.on.name}"\n'
        text += f'normal = {pair(self.own_normal)}\nthrough = {pair(self.through)}\nrestitution = "{self.e}"\n'
        if self.mu:
            text += f'friction = "{self.mu}"\n'
            if law != "poisson":
                text += f'tangential_restitution = "{self.et}"\n'
        return text


def eliminated(rows):
    """The solutions of rows . (x, 1) = 0: one of them, and a basis of differences; None without any."""
    rows = [r[:] for r in rows]
    width, pivots, at = len(rows[0]) - 1, [], 0
    for column in range(width):
        found = next((i for i in range(at, len(rows)) if rows[i][column]), None)
        if found is None:
            continue
        rows[at], rows[found] = rows[found], rows[at]
        rows[at] = [x / rows[at][column] for x in rows[at]]
        for i in range(len(rows)):
            if i != at and rows[i][column]:
                rows[i] = [x - rows[i][column] * y for x, y in zip(rows[i], rows[at])]
        pivots.append(column)
        at += 1
    if any(r[-1] for r in rows[at:]):
        return None
    free = [c for c in range(width) if c not in pivots]
    start = [Q(0)] * width
    for row, column in zip(rows, pivots):
        start[column] = -row[-1]
    basis = []
    for c in free:
        direction = [Q(0)] * width
        direction[c] = Q(1)
        for row, column in zip(rows, pivots):
            direction[column] = -row[c]
        basis.append(direction)
    return start, basis


def value(row, x):
    return dot(row[:-1], x) + row[-1]


def corners(equations, conditions, width):
    """All corners of equations = 0 <= conditions, which holds no line."""
    zero = [Q(0)] * width + [Q(0)]
    solved = eliminated(equations or [zero])
    if solved is None:
        return []
    found = []
    for held in combinations(conditions, len(solved[1])):
        point = eliminated(list(equations) + list(held) or [zero])
        if point is None or point[1]:
            continue
        if all(value(c, point[0]) >= 0 for c in conditions) and point[0] not in found:
            found.append(point[0])
    return found


class Impact:
    def __init__(self, bodies, contacts, law):
        self.law, self.contacts, width = law, contacts, 2 * len(contacts)
        masses = [m for b in bodies for m in (b.mass, b.mass, b.inertia)]
        self.masses = masses
        self.before = [v for b in bodies for v in (*b.velocity, b.spin)]
        self.rows = [c.row(bodies, d) for c in contacts for d in (c.normal, c.tangent)]
        self.u_before = [dot(r, self.before) for r in self.rows]
        self.width = width

    def velocity_rows(self, start):
        """Of each velocity of a contact, over the impulses (N, S of each contact, 1)."""
        return [[dot(r, [x / m for x, m in zip(s, self.masses)]) for s in self.rows] + [dot(r, start)] for r in self.rows]

    def after(self, start, impulses):
        pushed = [sum((p * r[i] for p, r in zip(impulses, self.rows)), Q(0)) for i in range(len(start))]
        return tuple(v + p / m for v, p, m in zip(start, pushed, self.masses))

    def modes(self, start, restored, given):
        """Of each mode: equations and conditions over the impulses. `given` is P_N without which N is not: at 0 of them
        a contact may open."""
        u = self.velocity_rows(start)
        per_contact = []
        for i, c in enumerate(self.contacts):
            add = lambda row, constant: row[:-1] + [row[-1] + constant]
            opening, sliding = add(u[2 * i], restored[2 * i]), add(u[2 * i + 1], restored[2 * i + 1])
            unit = lambda k: [Q(1) if j == k else Q(0) for j in range(self.width)] + [Q(0)]
            extra, s = add(unit(2 * i), -given[i]), unit(2 * i + 1)
            limit = [c.mu * x for x in unit(2 * i)]
            minus = lambda a, b: [x - y for x, y in zip(a, b)]
            plus = lambda a, b: [x + y for x, y in zip(a, b)]
            rubs = [([s], [])] if c.mu == 0 else [
                ([sliding], [minus(limit, s), plus(limit, s)]),
                ([plus(s, limit)], [sliding]),
                ([minus(s, limit)], [[-x for x in sliding]]),
            ]
            states = []
            for equations, conditions in rubs:
                states.append(([opening] + equations, [extra] + conditions))
                if given[i]:
                    states.append(([extra] + equations, [opening] + conditions))
            if not given[i]:
                states.append(([extra, s], [opening]))
            per_contact.append(states)
        for choice in product(*per_contact):
            yield [e for one in choice for e in one[0]], [c for one in choice for c in one[1]]

    def solve(self, start, restored, given):
        """Pairs of velocities and impulses; whether velocities, and impulses, of some mode are open."""
        found, open_velocities, open_impulses = [], False, False
        for equations, conditions in self.modes(start, restored, given):
            points = corners(equations, conditions, self.width)
            if not points:
                continue
            velocities = {self.after(start, p) for p in points}
            flat = lambda rows: [r[:-1] + [Q(0)] for r in rows]
            total = [Q(1)] * self.width
            for k in range(1, self.width, 2):
                total[k] = Q(0)
            rays = corners(flat(equations) + [total + [Q(-1)]], flat(conditions), self.width)
            for ray in rays:
                open_impulses = True
                open_velocities |= any(self.after([Q(0)] * len(start), ray))
            open_velocities |= len(velocities) > 1
            open_impulses |= len(points) > 1
            found += [(v, p) for v in velocities for p in points if self.after(start, p) == v]
        return found, open_velocities, open_impulses

    def outcomes(self):
        """The velocities after; whether some are open; None where they are not known here."""
        zero = [Q(0)] * self.width
        nothing = [Q(0)] * len(self.contacts)
        if self.law != "poisson":
            restored = []
            for i, c in enumerate(self.contacts):
                opening, sliding = self.u_before[2 * i:2 * i + 2]
                restored += [Q(0) if self.law == "newton" and opening > 0 else c.e * opening, c.et * sliding if c.mu else Q(0)]
            found, are_open, _ = self.solve(self.before, restored, nothing)
            return {v for v, _ in found}, are_open
        compressed, open_velocities, open_impulses = self.solve(self.before, zero, nothing)
        if open_velocities or open_impulses:
            return None
        result, are_open = set(), False
        for start, impulses in {(v, tuple(p)) for v, p in compressed}:
            given = [c.e * impulses[2 * i] for i, c in enumerate(self.contacts)]
            found, more, _ = self.solve(list(start), zero, given)
            result |= {v for v, _ in found}
            are_open |= more
        return result, are_open

    def energy(self, velocities):
        return sum((m * v * v for m, v in zip(self.masses, velocities)), Q(0)) / 2


def drawn(rng, law):
    while True:
        bodies = [Body(rng, name) for name in "ab"[:rng.choice((1, 1, 2))]]
        contacts = []
        for k in range(rng.choice((1, 2, 2, 3))):
            of = rng.choice(bodies)
            others = [None] + [b for b in bodies if b is not of]
            contacts.append(Contact(rng, f"c{k}", of, rng.choice(others)))
        held = {c.of for c in contacts} | {c.on for c in contacts}
        impact = Impact(bodies, contacts, law)
        if all(b in held for b in bodies) and any(u < 0 for u in impact.u_before[::2]):
            text = 'schema = "slipproof/mechanism/1"\nname = "random"\ngravity = "none"\n'
            yield bodies, impact, text + "".join(b.text() for b in bodies) + "".join(c.text(law) for c in contacts)


def told(program, text, law, bodies, folder):
    file = folder / "impact.toml"
    file.write_text(text)
    run = subprocess.run([program, "impact", file, "--law", law, "--json"], capture_output=True, text=True)
    if run.returncode != 0:
        return run.stderr or run.stdout
    answer = json.loads(run.stdout)
    suffixes = [""] if len(bodies) == 1 else ["_" + b.name for b in bodies]
    names = [n + s for s in suffixes for n in ("vx", "vy", "omega")]
    found, energies = set(), {}
    for outcome in answer["outcomes"]:
        if outcome["continuum"]:
            continue
        velocities = tuple(Q(outcome["velocities"][n]) for n in names)
        found.add(velocities)
        energies[velocities] = Q(outcome["energy"])
    return found, any(o["continuum"] for o in answer["outcomes"]), energies, Q(answer["before"]["energy"])


def main():
    program, count = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 60
    rng = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 67)
    seen, wrong = Counter(), 0
    generators = {law: drawn(rng, law) for law in ("newton", "moreau", "poisson")}
    with tempfile.TemporaryDirectory() as folder:
        for index in range(count):
            law = ("newton", "moreau", "poisson")[index % 3]
            bodies, impact, text = next(generators[law])
            expected = impact.outcomes()
            if expected is None:
                seen["not compared, as compression leaves impulses open"] += 1
                continue
            found = told(program, text, law, bodies, Path(folder))
            difference = None
            if isinstance(found, str):
                difference = found
            elif expected[1] != found[1]:
                difference = f"a continuum: {expected[1]} here, {found[1]} there"
            elif not expected[1] and expected[0] != found[0]:
                difference = f"{len(expected[0])} outcomes here, {len(found[0])} there: {sorted(map(str, expected[0] ^ found[0]))}"
            elif any(impact.energy(v) != e for v, e in found[2].items()) or impact.energy(impact.before) != found[3]:
                difference = "another energy"
            if difference:
                wrong += 1
                print(f"impact {index}, {law}:\n{text}\n{difference}", flush=True)
                continue
            seen["with a continuum" if expected[1] else f"with {len(expected[0])} outcomes"] += 1
            seen[f"{law}, of which some outcome gains energy"] += any(e > found[3] for e in found[2].values())
    print(", ".join(f"{n} {what}" for what, n in sorted(seen.items())))
    if wrong:
        sys.exit(f"{wrong} of {count} impacts differ")
    print(f"{count} impacts, and no difference")


main()
