#!/usr/bin/env python3
"""Random slack ropes, discs apart and discs in rings, all of which move and turn: gap and slip are the derivatives that an
independent computer algebra system (SymPy) forms of distance and sliding velocity as functions of time, to the last digit.

    apart.py SLIPPROOF [COUNT [SEED]]

Two bodies fly freely. What starts open has no force, so that they move as gravity says: the positions are polynomials in
time, and angles turn evenly. The distance is rational at the instant, and of no other kind before or after.
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


def pair(values):
    return "[" + ", ".join(f'"{v}"' for v in values) + "]"


def plus(a, b, factor=1):
    return a[0] + factor * b[0], a[1] + factor * b[1]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


class Body:
    """At the instant t = 0, and as functions of time up to t^2, which is all that two derivatives see."""

    def __init__(self, rng, gravity):
        self.at = number(rng), number(rng)
        self.velocity, self.spin, self.axes = (number(rng), number(rng)), number(rng), circle(rng)
        self.gravity = gravity

    def place(self, own):
        c, s = self.axes
        turn = self.spin * t
        cosine, sine = c * sp.cos(turn) - s * sp.sin(turn), s * sp.cos(turn) + c * sp.sin(turn)
        centre = [x + v * t + g * t**2 / 2 for x, v, g in zip(self.at, self.velocity, self.gravity)]
        return plus(centre, (cosine * own[0] - sine * own[1], sine * own[0] + cosine * own[1]))

    def own(self, place):
        """The place of the scene at the instant, in the body's axes."""
        (c, s), arm = self.axes, plus(place, self.at, -1)
        return c * arm[0] + s * arm[1], c * arm[1] - s * arm[0]

    def text(self, name):
        return (f'[[body]]\nname = "{name}"\nmass = "1"\ninertia = "2"\nat = {pair(self.at)}\nangle = {pair(self.axes)}\n'
                f'velocity = {pair(self.velocity)}\nspin = "{self.spin}"\n')


class Still:
    """The ground."""
    spin = sp.Integer(0)

    def place(self, own):
        return own

    def own(self, place):
        return place


def draw(rng):
    """A scene as text, and its distance, minus its sliding velocity's derivative, at time t."""
    gravity = number(rng), number(rng)
    first, other = Body(rng, gravity), rng.choice([Still(), Body(rng, gravity)])
    kind, first_own = rng.choice(["rope", "discs", "ring"]), (number(rng), number(rng))
    apart, along = sp.Rational(rng.randint(1, 20), rng.randint(1, 6)), circle(rng)
    here = tuple(x.subs(t, 0) for x in map(sp.sympify, first.place(first_own)))
    other_own = other.own(plus(here, along, -apart))
    between = plus(first.place(first_own), other.place(other_own), -1)
    distance = sp.sqrt(dot(between, between))
    names = ["a", "ground"] if isinstance(other, Still) else ["a", "b"]
    text = ['schema = "slipproof/mechanism/1"', 'name = "apart"', f"gravity = {pair(gravity)}", first.text("a")]
    text += [other.text("b")] if names[1] == "b" else []
    if kind == "rope":
        length = apart + sp.Rational(rng.randint(0, 5), 3)
        text.append(f'[[joint]]\nname = "e"\nkind = "rope"\nbetween = ["a", "{names[1]}"]\nat = {pair(first_own)}\n'
                    f'to = {pair(other_own)}\nlength = "{length}"\nstate = "slack"\n')
        return "\n".join(text), length - distance, None
    share = sp.Rational(rng.randint(0, 4), 5)
    if kind == "discs":
        radius, on_radius, sign = share * apart, (1 - share) * apart * rng.choice([1, sp.Rational(1, 2)]), 1
        gap = distance - radius - on_radius
    else:
        radius = rng.choice([0, 1, 2]) * apart / 3
        on_radius, sign = -(radius + apart + sp.Rational(rng.randint(0, 3), 2)), -1
        gap = -on_radius - radius - distance
    # along the surface, clockwise of the normal: the velocity of one centre against the other, and both rims
    normal = sign * between[0] / distance, sign * between[1] / distance
    tangent = normal[1], -normal[0]
    sliding = dot(tangent, (sp.diff(between[0], t), sp.diff(between[1], t))) + radius * first.spin + on_radius * other.spin
    text.append(f'[[contact]]\nname = "e"\nof = "a"\npoint = {pair(first_own)}\n' + (f'radius = "{radius}"\n' if radius else "")
                + f'on = "{names[1]}"\non_point = {pair(other_own)}\non_radius = "{on_radius}"\nfriction = "1/2"\nstate = "open"\n')
    return "\n".join(text), gap, sliding


def solved(program, text, folder):
    (folder / "m.toml").write_text(text)
    run = subprocess.run([program, "solve", folder / "m.toml", "--json"], capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"{text}\n{run.stderr}")
    document = json.loads(run.stdout)
    assert len(document["motions"]) == 1, text
    return {key: sp.Rational(value) for key, value in document["motions"][0]["accelerations"].items()}


def now(expression):
    return sp.Rational(sp.sympify(expression).subs(t, 0))


def main():
    program, count = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 500
    rng = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 61)
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(count):
            text, gap, sliding = draw(rng)
            found = solved(program, text, Path(folder))
            expected = {"gap_e": now(sp.diff(gap, t, 2))}
            if sliding is not None:
                expected["slip_e"] = now(sp.diff(sliding, t))
            for key, value in expected.items():
                if found[key] != value:
                    sys.exit(f"{text}\n{key}: slipproof says {found[key]}, the derivative is {value}")
    print(f"{count} ropes, discs and rings that start open: every gap and slip is the same rational")


main()
