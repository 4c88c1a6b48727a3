#!/usr/bin/env python3
"""Random impacts in space: Newton's method from random starts finds no outcome that `slipproof impact` does not tell.

    spatial.py SLIPPROOF [COUNT [SEED [LAW...]]]

One or two bodies, with any inertia and attitude, touch the ground and each other at one to three points, with random
velocities, by Newton's, Moreau's and Poisson's law in turn, or by those that are named: Poisson's takes nearly all
of the time, as a problem of two phases may be undecided after minutes. Masses and directions of contacts are derived
here in fractions; the solver is that of contact problems (../complete/independent), and for Poisson's law one of two
phases, which knows nothing of how they are one problem. Where all outcomes are told, each that is found must be one of
them, and of those that are told as single ones each should be found: the others are counted.
"""
import json
import random
import subprocess
import sys
import tempfile
from collections import Counter
from fractions import Fraction as Q
from importlib.util import find_spec
from pathlib import Path

if find_spec("numpy") is None:
    sys.exit(77)  # not asked

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "complete" / "independent"))
from newton import solutions_near
from problems import Problem, cross, dot

NEAR = 1e-6


def rotation(q):
    w, x, y, z = q
    n = Q(w * w + x * x + y * y + z * z)
    return [[(w * w + x * x - y * y - z * z) / n, 2 * (x * y - w * z) / n, 2 * (x * z + w * y) / n],
            [2 * (x * y + w * z) / n, (w * w - x * x + y * y - z * z) / n, 2 * (y * z - w * x) / n],
            [2 * (x * z - w * y) / n, 2 * (y * z + w * x) / n, (w * w - x * x - y * y + z * z) / n]]


def times(matrix, vector):
    return tuple(dot(row, vector) for row in matrix)


def transposed(matrix):
    return [list(column) for column in zip(*matrix)]


def inverse(matrix):
    (a, b, c), (d, e, f), (g, h, i) = matrix
    cofactors = [[e * i - f * h, c * h - b * i, b * f - c * e], [f * g - d * i, a * i - c * g, c * d - a * f],
                 [d * h - e * g, b * g - a * h, a * e - b * d]]
    size = a * cofactors[0][0] + b * cofactors[1][0] + c * cofactors[2][0]
    return [[x / size for x in row] for row in cofactors]


def plus(a, b):
    return tuple(x + y for x, y in zip(a, b))


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def vector(v):
    return "[" + ", ".join(f'"{x}"' for x in v) + "]"


def draw(rng, size, divisor=1):
    return tuple(Q(rng.randint(-size, size), divisor) for _ in range(3))


class Body:
    def __init__(self, rng, name):
        self.name, self.q = name, (rng.randint(1, 3), rng.randint(-2, 2), rng.randint(-2, 2), rng.randint(-2, 2))
        self.turn, self.at = rotation(self.q), draw(rng, 3)
        a, b, c = (Q(rng.randint(1, 4)) for _ in range(3))
        self.mass, self.own = Q(rng.randint(1, 6), 2), (b + c, a + c, a + b)  # sums of second moments: a body's
        self.velocity, self.spin = draw(rng, 4, 2), draw(rng, 2)
        back = transposed(self.turn)
        inertia = [[sum(self.turn[i][k] * self.own[k] * back[k][j] for k in range(3)) for j in range(3)] for i in range(3)]
        self.lightness = inverse(inertia)

    def text(self):
        return (f'[[body]]\nname = "{self.name}"\nmass = "{self.mass}"\ninertia = {vector(self.own)}\nat = {vector(self.at)}\n'
                f'turn = {vector(self.q)}\nvelocity = {vector(self.velocity)}\nspin = {vector(self.spin)}\n')


class Contact:
    def __init__(self, rng, name, of, on):
        self.name, self.of, self.on = name, of, on
        self.point = draw(rng, 4, 2)
        self.arm = times(of.turn, self.point)
        self.place = plus(of.at, self.arm)
        frame = transposed(rotation((rng.randint(1, 3), rng.randint(-2, 2), rng.randint(-2, 2), rng.randint(-1, 1))))
        self.own_normal, self.own_tangent = frame[2], frame[0]
        self.through, first, normal = self.place, frame[0], frame[2]
        if on is not None:
            self.through = times(transposed(on.turn), minus(self.place, on.at))
            first, normal = times(on.turn, frame[0]), times(on.turn, frame[2])
        self.directions = (normal, first, cross(normal, first))
        self.mu, self.e = rng.choice((Q(1, 4), Q(1, 2), Q(1))), Q(rng.randint(0, 4), 4)

    def rows(self):
        """Of each direction: the body, its force and couple of a unit impulse."""
        for d in self.directions:
            yield [(self.of, d, cross(self.arm, d))] + ([] if self.on is None else [
                (self.on, tuple(-x for x in d), cross(minus(self.place, self.on.at), tuple(-x for x in d)))])

    def text(self):
        on = "" if self.on is None else f'on = "{self.on.name}"\n'
        return (f'[[contact]]\nname = "{self.name}"\nof = "{self.of.name}"\n{on}point = {vector(self.point)}\n'
                f'normal = {vector(self.own_normal)}\nthrough = {vector(self.through)}\ntangent = {vector(self.own_tangent)}\n'
                f'friction = "{self.mu}"\nrestitution = "{self.e}"\n')


def problem_of(contacts, law):
    """The contact problem, velocities before, and what the law restores."""
    rows = [row for c in contacts for row in c.rows()]

    def moved(row, other):
        total = Q(0)
        for body, force, couple in row:
            for pushed, push, turn in other:
                if pushed is body:
                    total += dot(force, push) / body.mass + dot(couple, times(body.lightness, turn))
        return total

    W = [[moved(row, other) for other in rows] for row in rows]
    before = [sum((dot(f, b.velocity) + dot(c, b.spin) for b, f, c in row), Q(0)) for row in rows]
    restored = [Q(0)] * len(rows)
    for i, contact in enumerate(contacts):
        opening = before[3 * i]
        if law == "poisson":
            continue
        restored[3 * i] = Q(0) if law == "newton" and opening > 0 else contact.e * opening
    return Problem(W, [b + r for b, r in zip(before, restored)], [c.mu for c in contacts]), before, restored


def drawn(rng, law):
    while True:
        bodies = [Body(rng, name) for name in "ab"[:rng.choice((1, 1, 2))]]
        contacts = []
        for k in range(rng.choice((1, 1, 2, 2, 3))):
            of = rng.choice(bodies)
            contacts.append(Contact(rng, f"c{k}", of, rng.choice([None] + [b for b in bodies if b is not of])))
        held = {c.of for c in contacts} | {c.on for c in contacts}
        problem, before, restored = problem_of(contacts, law)
        if all(b in held for b in bodies) and any(u < 0 for u in before[::3]):
            yield bodies, contacts, problem, before, restored


class Phase:
    """Impulses r of one phase from the velocities `start`, N at least `least` of each contact: solutions of
    N - max(least, N - u_N) = 0 and T - (the vector of length mu N at most that is nearest to T - u_T) = 0."""

    def __init__(self, problem, start, least):
        self.W, self.mu = np.array(problem.W, dtype=float), np.array(problem.mu, dtype=float)
        self.start, self.least = start, least
        self.unit = np.repeat(1 / np.diag(self.W)[::3], 3)

    def residual(self, r):
        u, unit = self.start + self.W @ r, self.unit
        F, J, own = unit * u, unit[:, None] * self.W, np.eye(len(r))
        for k, mu in enumerate(self.mu):
            n, t = 3 * k, slice(3 * k + 1, 3 * k + 3)
            if r[n] - unit[n] * u[n] <= self.least[k]:
                F[n], J[n] = r[n] - self.least[k], own[n]
            to, bound = r[t] - unit[t] * u[t], mu * max(r[n], 0)
            length = np.hypot(*to)
            if length > bound:
                d = to / length
                F[t] = r[t] - bound * d
                change = own[t] - unit[t][:, None] * self.W[t]
                J[t] = own[t] - mu * np.outer(d, own[n]) - bound / length * (np.eye(2) - np.outer(d, d)) @ change
        return F, J

    def solutions(self, rng, starts=40):
        scale = max(np.abs(self.unit * self.start).max(), self.least.max(initial=0), 1e-300)
        for _ in range(starts):
            r = rng.normal(0, scale, len(self.start))
            for _ in range(60):
                F, J = self.residual(r)
                if np.abs(F).max() < 1e-11 * scale:
                    yield r, self.start + self.W @ r
                    break
                r = r - np.linalg.lstsq(J, F, rcond=None)[0]


def differ(a, b):
    return np.abs(a - b).max() > 1e-6 * (np.abs(a).max() + np.abs(b).max())


def by_poisson(problem, before, restitution, rng):
    """Velocities after both phases; None where compression leaves impulses open, by which they depend on the choice."""
    compressed, found = [], []
    for r, u in Phase(problem, np.array(before, dtype=float), np.zeros(len(restitution))).solutions(rng):
        same = [s for s, v in compressed if not differ(u, v)]
        if any(differ(r, s) for s in same):
            return None
        if same:
            continue
        compressed.append((r, u))
        for _, v in Phase(problem, u, restitution * np.maximum(r[::3], 0)).solutions(rng):
            if all(differ(v, other) for other in found):
                found.append(v)
    return found


def told(program, bodies, contacts, law, folder):
    file = folder / "impact.toml"
    file.write_text('schema = "slipproof/mechanism/1"\nname = "random"\ndimension = 3\ngravity = "none"\n' +
                    "".join(b.text() for b in bodies) + "".join(c.text() for c in contacts))
    run = subprocess.run([program, "impact", file, "--law", law, "--json"], capture_output=True, text=True)
    return json.loads(run.stdout) if run.stdout.startswith("{") else run.stderr


def ends(value):
    return (float(Q(value)),) * 2 if isinstance(value, str) else tuple(
        np.inf * sign if end is None else float(Q(end)) for end, sign in zip(value, (-1, 1)))


def is_one(contacts, outcome, after):
    scale = 1 + np.abs(after).max()
    for i, contact in enumerate(contacts):
        for k, key in enumerate(("opening", "sliding", "sliding2")):
            lower, upper = ends(outcome["contacts"][contact.name][key])
            if not lower - NEAR * scale <= after[3 * i + k] <= upper + NEAR * scale:
                return False
    return True


def main():
    program, count = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 20
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else 67
    rng, starts, seen, wrong = random.Random(seed), np.random.default_rng(seed), Counter(), 0
    generators = [(law, drawn(rng, law)) for law in sys.argv[4:] or ("newton", "moreau", "poisson")]
    with tempfile.TemporaryDirectory() as folder:
        for index in range(count):
            law, generator = generators[index % len(generators)]
            bodies, contacts, problem, before, restored = next(generator)
            answer = told(program, bodies, contacts, law, Path(folder))
            if isinstance(answer, str):
                wrong += 1
                print(f"impact {index}: {answer}", flush=True)
                continue
            if not answer["complete"]:
                seen["undecided"] += 1
                continue
            if law == "poisson":
                found = by_poisson(problem, before, np.array([float(c.e) for c in contacts]), starts)
            else:
                found = [f.u - np.array(restored, dtype=float) for f in solutions_near(problem, starts, 60)]
            if found is None:
                seen["not compared, as compression may leave impulses open"] += 1
                continue
            missing = [u for u in found if not any(is_one(contacts, o, u) for o in answer["outcomes"])]
            if missing:
                wrong += 1
                print(f"impact {index}, {law}: not told: {[u.tolist() for u in missing]}", flush=True)
                print((Path(folder) / "impact.toml").read_text(), flush=True)
            seen[f"with {len(answer['outcomes'])} outcomes"] += 1
            seen["outcomes that Newton's method misses"] += sum(
                not any(is_one(contacts, o, u) for u in found) for o in answer["outcomes"])
            seen["of which some outcome gains energy"] += any(o["gains_energy"] for o in answer["outcomes"])
    print(", ".join(f"{n} {what}" for what, n in sorted(seen.items())))
    if wrong:
        sys.exit(f"{wrong} of {count} impacts differ")
    print(f"{count} impacts, and nothing was found that is not told")


main()
