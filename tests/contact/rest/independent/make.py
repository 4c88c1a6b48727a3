#!/usr/bin/env python3
"""Larger structures, for `slipproof rest` at size: writes FOLDER/NAME.toml, and its mechanism beside it.

    make.py arch STONES THICKNESS FOLDER      a semicircular arch of radius 1, in the plane
    make.py wall COURSES BRICKS FOLDER        a wall in running bond
    make.py cards LEVELS FOLDER               a house of cards, 26 of them in 4 levels
    make.py heap BOXES FOLDER                 boxes in space, each on others
"""
import math
import sys
from fractions import Fraction
from pathlib import Path

from structure import Body, Contact, Structure, minus, times

HALF = Fraction(1, 2)
UP = (Fraction(0), Fraction(1))


def point_near(angle, denominator=1000):
    """A rational point of the circle near this angle, by the tangent of half of it."""
    t = Fraction(math.tan(angle / 2)).limit_denominator(denominator)
    return ((1 - t * t) / (1 + t * t), 2 * t / (1 + t * t))


def joints(stones):
    """Rational directions of the joints of a semicircle, the same on both sides."""
    angles = [math.pi * k / stones for k in range(stones // 2 + 1)]
    right = [(Fraction(1), Fraction(0)) if a == 0 else (Fraction(0), Fraction(1)) if 4 * a == 2 * math.pi else point_near(a) for a in angles]
    left = [(-p, q) for p, q in reversed(right)]
    return right + (left[1:] if stones % 2 == 0 else left)


def corners(points):
    return ", ".join(f'["{x}", "{y}"]' for x, y in points)


def arch(stones, thickness, mu=Fraction(7, 10)):
    """Stones with straight edges between radial joints; mean radius 1, gravity 10, stone weighs 1 for each unit of area."""
    s = Structure(f"arch-{stones}", 2, (Fraction(0), Fraction(-10)))
    inner, outer = 1 - thickness / 2, 1 + thickness / 2
    cuts = joints(stones)
    for k, (p, q) in enumerate(zip(cuts, cuts[1:])):
        area = (outer**2 - inner**2) / 2 * (p[0] * q[1] - p[1] * q[0])
        scale = (outer**3 - inner**3) / (outer**2 - inner**2) / 3
        at = (scale * (p[0] + q[0]), scale * (p[1] + q[1]))
        shape = corners(minus(times(r, d), at) for r, d in ((inner, p), (outer, p), (outer, q), (inner, q)))
        s.bodies.append(Body(f"s{k}", area, at, f"{{ polygon = [{shape}] }}"))
    for k, d in enumerate(cuts):
        of, on, normal = f"s{k}", f"s{k - 1}" if k else None, (-d[1], d[0])
        if k == stones:
            of, on, normal = f"s{stones - 1}", None, (d[1], -d[0])
        for name, r in (("in", inner), ("out", outer)):
            s.contacts.append(Contact(f"{name}{k}", of, on, times(r, d), normal, mu))
    return s


def wall(courses, bricks, mu=HALF):
    """Running bond: every second course is shifted by half a brick, with half bricks at its ends."""
    s = Structure(f"wall-{courses}x{bricks}", 2, (Fraction(0), Fraction(-10)))
    below = [(None, Fraction(0), Fraction(2 * bricks))]
    for row in range(courses):
        cuts = [Fraction(2 * k) for k in range(bricks + 1)]
        if row % 2:
            cuts = [Fraction(0)] + [Fraction(2 * k + 1) for k in range(bricks)] + [Fraction(2 * bricks)]
        course = []
        for k, (left, right) in enumerate(zip(cuts, cuts[1:])):
            name = f"b{row}_{k}"
            s.bodies.append(Body(name, right - left, ((left + right) / 2, row + HALF), f'{{ box = ["{right - left}", "1"] }}'))
            for on, a, b in below:
                for x in sorted({max(a, left), min(b, right)}) if max(a, left) < min(b, right) else []:
                    s.contacts.append(Contact(f"c{len(s.contacts)}", name, on, (x, Fraction(row)), UP, mu))
            course.append((name, left, right))
        below = course
    return s


def cards(levels, mu=Fraction(4, 5)):
    """Pairs of leaning cards, at 65 degrees nearly, flat ones over neighbouring pairs; all without thickness."""
    s = Structure(f"cards-{levels}", 2, (Fraction(0), Fraction(-10)))
    dx, dy = Fraction(72, 85), Fraction(154, 85)
    for level in range(levels):
        for k in range(levels - level):
            middle, foot = (2 * k + level - levels + 1) * dx, level * dy
            top = (middle, foot + dy)
            for side, sign in (("l", -1), ("r", 1)):
                name, low = f"{side}{level}_{k}", (middle + sign * dx, foot)
                at = ((low[0] + top[0]) / 2, (low[1] + top[1]) / 2)
                s.bodies.append(Body(name, Fraction(1), at, f"{{ line = [{corners([minus(low, at), minus(top, at)])}] }}"))
                on = None if level == 0 else f"f{level}_{k}"
                s.contacts.append(Contact(f"foot_{name}", name, on, low, UP, mu))
            s.contacts.append(Contact(f"top{level}_{k}", f"l{level}_{k}", f"r{level}_{k}", top, (Fraction(-1), Fraction(0)), mu))
        for k in range(levels - level - 1):  # the flat cards on which the next level stands, each on two tops
            left, right = (2 * k + level - levels + 1) * dx, (2 * k + level - levels + 3) * dx
            at, name = ((left + right) / 2, foot + dy), f"f{level + 1}_{k}"
            s.bodies.append(Body(name, Fraction(1), at, f"{{ line = [{corners([(-dx, Fraction(0)), (dx, Fraction(0))])}] }}"))
            for x, pair in ((left, k), (right, k + 1)):
                for side in "lr":
                    s.contacts.append(Contact(f"lid_{name}_{side}{pair}", name, f"{side}{level}_{pair}", (x, foot + dy), UP, mu))
    return s


def heap(boxes, mu=HALF):
    """Boxes of 2 x 2 x 1 in a pyramid's order, each on the four below it, in the corners of what they share; as many as
    are asked for, level by level."""
    s = Structure(f"heap-{boxes}", 3, (Fraction(0), Fraction(0), Fraction(-10)))
    side = next(n for n in range(1, boxes + 1) if n * (n + 1) * (2 * n + 1) // 6 >= boxes)
    up, right = (Fraction(0), Fraction(0), Fraction(1)), (Fraction(1), Fraction(0), Fraction(0))
    for level in range(side):
        n = side - level
        for i in range(n):
            for j in range(n):
                if len(s.bodies) == boxes:
                    return s
                name, x, y = f"b{level}_{i}_{j}", Fraction(2 * i + level), Fraction(2 * j + level)
                s.bodies.append(Body(name, Fraction(1), (x, y, level + HALF), '{ box = ["2", "2", "1"] }'))
                for di, dj in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                    on = f"b{level - 1}_{i + (di + 1) // 2}_{j + (dj + 1) // 2}" if level else None
                    point = (x + di * Fraction(3, 4), y + dj * Fraction(3, 4), Fraction(level))
                    s.contacts.append(Contact(f"c{len(s.contacts)}", name, on, point, up, mu, right))
    return s


def main():
    kind, *numbers, folder = sys.argv[1:]
    made = {"arch": lambda n, t: arch(int(n), Fraction(t)), "wall": lambda c, b: wall(int(c), int(b)),
            "cards": lambda n: cards(int(n)), "heap": lambda n: heap(int(n))}[kind](*numbers)
    Path(folder).mkdir(parents=True, exist_ok=True)
    print(made.write(Path(folder)), f"{len(made.bodies)} bodies, {len(made.contacts)} contacts")


if __name__ == "__main__":
    main()
