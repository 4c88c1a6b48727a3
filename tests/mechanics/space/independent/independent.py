#!/usr/bin/env python3
"""Random systems of bodies in space: the contact problem that `slipproof export` writes is that of Lagrange's equations
with multipliers, number by number.

    independent.py SLIPPROOF [COUNT [SEED]]

Each system has 1 to 5 bodies with any inertia and attitude, held by joints of all kinds in trees and loops, springs,
gears, spheres and points that touch planes and spheres of the ground, of other bodies and of one that moves as prescribed,
forces and couples, and random velocities that fit all of this. Lagrange's side knows where material points are as a
function of time, and the kinetic energy, and nothing else. M, f, H and w must be the same rationals; G and b must hold the
same accelerations, as the directions across a joint may be any. Where a contact slides, the forces of joints are eliminated
on both sides, and W and q must be the same.
"""
import json
import random
import subprocess
import sys
import tempfile
from collections import Counter
from importlib.util import find_spec
from pathlib import Path

if find_spec("sympy") is None:
    sys.exit(77)  # not asked

from draw import JOINTS, System
from kinetic import lagrange_of_turning, selfcheck
from motion import Body, Motion, Rates
from problem import Problem
from series import UNITS, Vector


def place(x, v, a, w, turning, arm):
    """For the check against SymPy's own derivatives: the series of a point's place."""
    body = Body("b", vector(x))
    return Motion({"b": Rates(vector(v), vector(w), vector(a), vector(turning))}).place(body, vector(arm))


def vector(matrix):
    return Vector(*(UNITS[0][0] * int(e) for e in matrix))


def exported(program, text, folder):
    """The problem, or what the program says against it."""
    (folder / "m.toml").write_text(text)
    (folder / "s.toml").write_text('name = "s"\nmechanism = "m.toml"\n[values]\n')
    run = subprocess.run([program, "export", folder / "s.toml", "-o", folder / "p.json"], capture_output=True, text=True)
    if run.returncode != 0:
        return run.stderr
    return json.loads((folder / "p.json").read_text())


def systems(rng, turning_equations):
    """With the problem of each; in turn, so that each joint comes often, and without those whose joints contradict each
    other, as they do where they lock."""
    index = 0
    while True:
        kinds = [JOINTS[index % len(JOINTS)]] + [rng.choice(JOINTS) for _ in range(rng.randint(0, 4))]
        system = System(rng, kinds, rng.choice((0, 1, 1, 2)))
        if not system.set_velocities():
            continue
        problem = Problem(system, turning_equations)
        if problem.links_fit():
            index += 1
            yield system, problem


def main():
    program, count = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 200
    rng = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 64)
    selfcheck(place)
    turning_equations = lagrange_of_turning()
    seen, wrong, sliding, armed = Counter(), 0, 0, 0
    with tempfile.TemporaryDirectory() as folder:
        for index, (system, problem) in zip(range(count), systems(rng, turning_equations)):
            seen.update(e.kind for e in system.elements if hasattr(e, "kind"))
            sliding += system.slides()
            armed += any(e.armatures for e in system.elements)
            found = exported(program, system.text(), Path(folder))
            differences = [found] if isinstance(found, str) else problem.differences(found)
            if differences:
                wrong += 1
                print(f"system {index}:\n{system.text()}\n" + "\n".join(differences), flush=True)
    print(f"{count} systems, {sliding} of which slide and {armed} have armatures: " + ", ".join(f"{n} {kind}" for kind, n in sorted(seen.items())))
    if wrong:
        sys.exit(f"{wrong} systems differ")
    print("every number is the same rational")


main()
