#!/usr/bin/env python3
"""Tops, wheels and coins whose accelerations and forces a page of paper gives.

    by_hand.py SLIPPROOF
"""
import json
import subprocess
import sys
import tempfile
from fractions import Fraction as F
from pathlib import Path


def vector(*values):
    return "[" + ", ".join(f'"{v}"' for v in values) + "]"


def body(name, mass, inertia, at, velocity, spin, turn=None):
    return (f'[[body]]\nname = "{name}"\nmass = "{mass}"\ninertia = {vector(*inertia)}\nat = {vector(*at)}\n'
            f'velocity = {vector(*velocity)}\nspin = {vector(*spin)}\n' + (f"turn = {vector(*turn)}\n" if turn else ""))


def contact(name, of, point, radius=None, friction=None):
    return (f'[[contact]]\nname = "{name}"\nof = "{of}"\npoint = {vector(*point)}\nnormal = ["0", "0", "1"]\n'
            'through = ["0", "0", "0"]\n' + (f'radius = "{radius}"\n' if radius else "")
            + (f'friction = "{friction}"\ntangent = ["1", "0", "0"]\n' if friction else ""))


def top():
    """A top with its foot on rough ground, in steady precession.

    Its axis e leans by theta, tan(theta/2) = 1/2, so e = (4/5, 0, 3/5), and turns with W about the upright while the top
    spins with S about e. About the foot the moments are A = I + m l^2 across the axis and C along it. The angular
    momentum's level part, (C (S + W cos) sin - A W sin cos), turns with W, which takes the moment m g l sin of gravity:
    C S W + (C - A) W^2 cos = m g l. The centre of mass runs on a circle of radius l sin.
    """
    m, length, g, A, C, W = F(1, 2), F(1, 5), F(10), F(3, 100), F(1, 100), F(2)
    sine, cosine = F(4, 5), F(3, 5)
    S = (m * g * length - (C - A) * W**2 * cosine) / (C * W)
    spin = (S * sine, 0, S * cosine + W)
    text = 'schema = "slipproof/mechanism/1"\nname = "top"\ndimension = 3\ngravity = ["0", "0", "-10"]\n'
    I = A - m * length**2
    text += body("top", m, (I, I, C), (length * sine, 0, length * cosine), (0, W * length * sine, 0), spin, (2, 0, 1, 0))
    text += contact("foot", "top", (0, 0, -length), friction=10)
    inward = -W**2 * length * sine
    return text, {"ax": inward, "ay": 0, "az": 0, "alphax": 0, "alphay": W * S * sine, "alphaz": 0}, {
        "N_foot": m * g, "T1_foot": m * inward, "T2_foot": 0}


def coin():
    """An upright coin that rolls along x and turns about the upright: it begins to lean.

    Its spin is (0, w, W). With moments A about a diameter and C about its axis, Euler's equation about x is
    A alpha_x + (A - C) w W = R T2, rolling says ay = -R alpha_x, and T2 = m ay. A sphere stands for the edge: the same
    while the coin is upright and does not yet lean.
    """
    m, R, A, C, w, W = F(1, 100), F(1, 50), F(1, 10**6), F(2, 10**6), F(10), F(3)
    text = 'schema = "slipproof/mechanism/1"\nname = "coin"\ndimension = 3\ngravity = ["0", "0", "-10"]\n'
    text += body("coin", m, (A, C, A), (0, 0, R), (R * w, 0, 0), (0, w, W)) + contact("edge", "coin", (0, 0, 0), R, 1)
    lean = (C - A) * w * W / (A + m * R**2)
    return text, {"ax": 0, "ay": -R * lean, "az": 0, "alphax": lean, "alphay": 0, "alphaz": 0}, {
        "N_edge": m * 10, "T1_edge": 0, "T2_edge": -m * R * lean}


def wheel():
    """A wheel that is steered while it rolls, held upright by a stand with one outrigger on smooth ground.

    Steered with W it moves aside with v W, v = R w, which takes T2 = (M + m) v W. The axle turns with W, so the wheel's
    angular momentum C w does, too: about x, -C w W = R T2 - d N of the outrigger, which is d to the right.
    """
    m, M, R, C, A, w, W, d, g = F(2), F(3), F(3, 10), F(1, 5), F(1, 10), F(8), F(1, 2), F(1), F(10)
    v = R * w
    text = 'schema = "slipproof/mechanism/1"\nname = "wheel"\ndimension = 3\ngravity = ["0", "0", "-10"]\n'
    text += body("wheel", m, (A, C, A), (0, 0, R), (v, 0, 0), (0, w, W))
    text += body("stand", M, (1, 1, 1), (0, 0, R), (v, 0, 0), (0, 0, W))
    text += ('[[joint]]\nname = "axle"\nkind = "hinge"\nbetween = ["stand", "wheel"]\nat = ["0", "0", "0"]\n'
             'axis = ["0", "1", "0"]\n')
    text += contact("tyre", "wheel", (0, 0, 0), R, 1) + contact("foot", "stand", (0, -d, -R))
    aside = (M + m) * v * W
    foot = (C * w * W + R * aside) / d
    return text, {"ay_wheel": v * W, "ay_stand": v * W, "ax_wheel": 0, "alphax_stand": 0, "alphax_wheel": -w * W,
                  "alphay_wheel": 0, "alphaz_wheel": 0}, {
        "N_foot": foot, "N_tyre": (M + m) * g - foot, "T1_tyre": 0, "T2_tyre": aside}


def main():
    program = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        for example in (top, coin, wheel):
            text, accelerations, forces = example()
            file = Path(folder) / "s.toml"
            file.write_text(text)
            run = subprocess.run([program, "solve", file, "--json"], capture_output=True, text=True)
            if run.returncode != 0:
                sys.exit(f"{text}\n{run.stderr}")
            document = json.loads(run.stdout)
            assert document["complete"] and len(document["motions"]) == 1, run.stdout
            motion = document["motions"][0]
            for expected, found in ((accelerations, motion["accelerations"]), (forces, motion["forces"])):
                for name, value in expected.items():
                    if [F(x) for x in found[name]] != [value, value]:
                        sys.exit(f"{text}\n{name}: found {found[name]}, expected {value}")
            print(f"{example.__name__}: as by hand")


main()
