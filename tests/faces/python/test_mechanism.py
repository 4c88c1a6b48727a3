"""Mechanisms without a file: from a text, a dict, bodies."""

import os
import pickle
import subprocess
import sys
from fractions import Fraction

import pytest

import slipproof
from slipproof import Body, Contact, Force, Joint, Mechanism


def crate(**tables):
    feet = [Contact(name, "crate", [x, -1], normal=[0, 1], through=[0, 0], friction="mu") for name, x in (("left", -1), ("right", 1))]
    return Mechanism.of("crate", gravity=[0, "-g"], parameters={"mu": "mu >= 0", "g": {"domain": "g > 0"}}, load={"symbol": "F"},
                        bodies=[Body("crate", mass=2, inertia=Fraction(4, 3), at=[0, 1], shape={"box": [2, 2]})],
                        contacts=feet, forces=[Force("crate", ["F", 0], at=[-1, Fraction(1, 2)])], **tables)


TEXT = """
schema = "slipproof/mechanism/1"
name = "crate"
gravity = ["0", "-g"]
[parameters]
mu = "mu >= 0"
g = "g > 0"
[load]
symbol = "F"
[[body]]
name = "crate"
mass = "2"
inertia = "4/3"
at = ["0", "1"]
shape = { box = ["2", "2"] }
[[contact]]
name = "left"
of = "crate"
point = ["-1", "-1"]
normal = ["0", "1"]
through = ["0", "0"]
friction = "mu"
[[contact]]
name = "right"
of = "crate"
point = ["1", "-1"]
normal = ["0", "1"]
through = ["0", "0"]
friction = "mu"
[[force]]
on = "crate"
at = ["-1", "1/2"]
is = ["F", "0"]
"""


def test_bodies_a_dict_and_a_text_are_one_mechanism(program, tmp_path):
    path = tmp_path / "crate.toml"
    path.write_text(TEXT)
    values = {"mu": "1/2", "g": 10}
    expected = Mechanism.load(path).solve(values).to_dict()
    for mechanism in (crate(), Mechanism.parse(TEXT), Mechanism.parse(crate().to_dict())):
        assert mechanism.parameters == ("mu", "g") and mechanism.elements == ("left", "right")
        assert mechanism.solve(values).to_dict() == expected
        assert "Degrees of freedom" not in mechanism.show() and "box" not in mechanism.name
    scene = crate().scene(values, load=3)
    assert pickle.loads(pickle.dumps(scene)).solve().to_dict() == scene.solve().to_dict()
    assert scene.replace(F=40).solve().motions[0].modes != scene.solve().motions[0].modes
    scene_file = tmp_path / "scene.toml"
    scene_file.write_text(scene.to_toml())
    assert program("solve", "--json", scene_file)["motions"] == scene.solve().to_dict()["motions"]


def test_it_is_searched_and_followed_as_one_from_a_file():
    found = crate().search(samples=5)
    assert found.verdict in ("none found", "found", "unique")
    assert slipproof.search(TEXT, samples=5).verdict == slipproof.search(crate().to_dict(), samples=5).verdict == found.verdict
    assert slipproof.critical(crate().scene({"mu": "1/2", "g": 10}, load=3)).to_dict()["parameter"] == "mu"


def test_mistakes_name_the_part():
    with pytest.raises(slipproof.InputError, match="contact.*nobody"):
        Mechanism.of("x", gravity="none", bodies=[Body("b", mass=1, inertia=1)],
                     contacts=[Contact("c", "nobody", [0, 0], normal=[0, 1])])
    with pytest.raises(slipproof.InputError, match="foot.toml:3:"):
        Mechanism.parse('schema = "slipproof/mechanism/1"\nname = "x"\ngravty = "none"\n', "foot.toml")
    with pytest.raises(TypeError):
        Mechanism.parse(3)


def test_joints_and_prescribed_bodies():
    swing = Mechanism.of("swing", gravity=[0, -10], bodies=[
        Body("trolley", acceleration=[3, 0], at=[0, 2]), Body("bob", mass=1, inertia=0, at=[0, 1])],
        joints=[Joint("rod", "pin", ("trolley", "bob"), at=[0, 0])])
    motion = swing.solve({}).motions[0]
    assert motion.ax == 0 and motion.alpha == -3  # a point mass on a rod of length 1: it stays behind


def test_a_missing_table_of_units_is_told_once_and_no_unit_is_called_unknown():
    call = "import slipproof; print(slipproof.Mechanism.load('ladder').show())"
    shown = subprocess.run([sys.executable, "-c", call], capture_output=True, text=True, check=True,
                           env={**os.environ, "UDUNITS2_XML_PATH": "/no-such"}).stdout
    assert shown.count("udunits is not installed") == 1 and "libudunits2-0" in shown and "unknown" not in shown
