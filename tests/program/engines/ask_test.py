"""ask_test.py SLIPPROOF CASES: asks a small engine whole scenes and a threshold, and what happens to one that crashes,
hangs or is not there. Where ODE is installed, its adapter is asked, too."""

import importlib.util
import json
import math
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction
from pathlib import Path

HERE = Path(__file__).resolve().parent
SLIPPROOF, CASES = sys.argv[1], Path(sys.argv[2]).resolve()
EVERY = int(os.environ.get("SLIPPROOF_ENGINES_EVERY", "8"))  # of the scenes in space
sys.path.insert(0, str(CASES))
from asking.scenes import scenes_of  # noqa: E402
from asking.space import WorldInSpace, cross, principal  # noqa: E402
from asking.threshold import Bisection, acceleration, quantity  # noqa: E402
from asking.world import Refused, step_of, world  # noqa: E402


def ask(*engines, table=HERE / "engines.toml", only="", limit=20, built=None):
    """What ask.py prints, and the lines that it writes for each engine, which may be `built` in a folder before."""
    with tempfile.TemporaryDirectory() as folder:
        told = subprocess.run([sys.executable, "-B", str(CASES / "ask.py"), *engines, "--slipproof", SLIPPROOF, "--folder", built or folder,
                               "--answers", folder, "--table", str(table), "--only", only, "--limit", str(limit)],
                              capture_output=True, text=True, check=False)
        lines = {file.stem: [json.loads(line) for line in file.read_text().splitlines()]
                 for file in Path(folder).glob("*.jsonl")}
        return told, lines


def middle(value):
    return value["double"] if "double" in value else (value["lower"]["double"] + value["upper"]["double"]) / 2


def width(value):
    ends = [value.get(end) for end in ("lower", "upper")]
    return 0 if "double" in value else math.inf if None in ends else ends[1]["double"] - ends[0]["double"]


def in_axes(turn, vector):
    """Of a vector of the scene its components along the axes that a quaternion turns."""
    w, axis = turn[0], [-x for x in turn[1:]]
    once = cross(axis, vector)
    return [v + 2 * (w * a + b) for v, a, b in zip(vector, once, cross(axis, once))]


def line_of(lines, asked):
    return next(line for line in lines if line["asked"] == asked)


class Asking(unittest.TestCase):
    def expected(self, scene):
        return json.loads((CASES / "expected" / f"{scene}.json").read_text())

    def test_motion_and_threshold(self):
        scene = "thresholds/ball-rolls-on-slope"
        told, lines = ask("sweeps", only=scene)
        self.assertIn("threshold 1/1", told.stdout)
        exact = self.expected(scene)
        answer = line_of(lines["sweeps"], "default")
        for name, value in answer["motion"].items():
            self.assertAlmostEqual(value, exact["motions"][0]["accelerations"][name]["double"], 9, name)
        for name, value in answer["forces"].items():
            self.assertAlmostEqual(value, exact["motions"][0]["forces"][name]["double"], 9, name)
        found, at = line_of(lines["sweeps"], "threshold"), exact["threshold"]["changes"][0]["at"]["double"]
        self.assertLess(abs(found["changes_at"] - at), 2 * found["within"] + 1e-7)
        self.assertGreater(found["within"], 0)

    def test_what_gives_no_answer(self):
        scene = "one-motion/ball-at-rest"
        told, lines = ask(only=scene, limit=5)
        self.assertEqual(told.returncode, 0)
        self.assertIn("not asked: the library no-such-library is not installed", told.stdout)
        self.assertNotIn("not-there", lines)
        self.assertIn("ended with 1: assertion: no scene at all", lines["crashes"][0]["failed"])
        self.assertEqual(lines["hangs"][0]["failed"], "no answer in 5 s")
        self.assertIn("motion", lines["sweeps"][0])
        _, lines = ask("sweeps", only="space-cone/ball-pushed-at-31")
        self.assertEqual(lines["sweeps"][0]["refused"], "a scene in space")
        self.assertEqual(ask("nobody")[0].returncode, 2)
        self.assertEqual(ask("sweeps", only="no such scene")[0].returncode, 3)

    def test_engines_that_are_not_there(self):
        """Their adapters compile, and say which module is missing; what they share turns moments into the scene."""
        modules = {"newton": "newton", "genesis": "genesis", "drake": "pydrake", "chrono": "pychrono"}
        missing = [name for name, module in modules.items() if importlib.util.find_spec(module) is None]
        told, lines = ask(*missing, table=CASES / "engines.toml", only="space-cone/cube-pushed-at-37") if missing else (None, {})
        for name in missing:
            self.assertIn(f"not asked: the module {modules[name]} of Python is not installed", told.stdout)
        self.assertEqual(lines, {})
        for file in (CASES / "adapters").glob("*.py"):
            compile(file.read_text(), str(file), "exec")
        sys.path.append(str(CASES / "adapters"))
        from adapter import inertia
        scene = Scenes.scenes["space-stand/two-cubes-0-4-3-4"].bodies()
        for given, body in zip(scene["bodies"], WorldInSpace(scene).built()["bodies"][1:]):
            xx, yy, zz, xy, xz, yz = given["inertia"]
            turn, own = given["turn"], [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
            both = [[sum(a * b for a, b in zip(p, q)) for q in zip(*inertia(body, invert=True))] for p in inertia(body)]
            for i in range(3):
                for j in range(3):
                    exact = sum(turn[i][k] * own[k][m] * turn[j][m] for k in range(3) for m in range(3))
                    self.assertAlmostEqual(inertia(body)[i][j], exact, 12)
                    self.assertAlmostEqual(both[i][j], i == j, 12)

    @unittest.skipUnless(shutil.which("pkg-config") and shutil.which("c++") and
                         subprocess.run(["pkg-config", "--exists", "ode"], check=False).returncode == 0, "no ODE")
    def test_ode(self):
        with tempfile.TemporaryDirectory() as built:
            for scene, engines, places in (("one-motion/ball-at-rest", ["ode"], 5),
                                           ("space-cone/ball-pushed-at-31", ["ode", "ode-shapes"], 4)):
                _, lines = ask(*engines, table=CASES / "engines.toml", only=scene, built=built)
                exact = self.expected(scene)["motions"][0]
                for engine in engines:  # the contact of the scene, and the one that ODE finds
                    for name, value in lines[engine][0]["motion"].items():
                        self.assertAlmostEqual(value, exact["accelerations"][name]["double"], places, name)


class Scenes(unittest.TestCase):
    """Without any engine: what it is told, and how it is bisected."""

    scenes = {scene.name: scene for scene in scenes_of(CASES, SLIPPROOF)}

    def test_exact_motions_have_no_gap_and_slip_where_they_stick(self):
        for name in ("one-motion/crate-rides-on-sledge", "thresholds/ankle-torque-heel"):
            scene = self.scenes[name]
            built = world(scene.bodies())
            motion = scene.expected["motions"][0]
            values = {key: value["double"] for key, value in motion["accelerations"].items()}
            for i, contact in enumerate(built["contacts"]):
                for kind, word in (("gap", "gap"), (1, "slip")):
                    self.assertAlmostEqual(quantity(built, values, i, kind), values[f"{word}_{contact['name']}"], 9)

    def test_in_space_exact_motions_have_no_gap_and_slip_where_they_stick(self):
        """Also of bodies that are turned, on balls, and with moments about axes of their own."""
        for name in ("space-stand/cards-1-2-0-1-2", "space-stand/two-cubes-0-4-3-4", "space-rolling/groove-0-2-1-2",
                     "space-rolling/three-wheels-3-4-0-up-50-0-5", "space-grip/plate-in-fingers-0-17-10"):
            scene = self.scenes[name]
            built = WorldInSpace(scene.bodies()).built()
            motion = scene.expected["motions"][0]
            values = {key: value.get("double", 0) for key, value in motion["accelerations"].items()}
            for i, state in enumerate(motion["modes"][0].split("/")):
                if state != "lift":
                    self.assertAlmostEqual(quantity(built, values, i, "gap"), 0, 6, (name, i))
                if state == "stick":
                    self.assertAlmostEqual(quantity(built, values, i, "slip"), 0, 6, (name, i))

    def test_scenes_are_exported_at_any_values(self):
        """Also after one that is refused, in each form."""
        scene = self.scenes["thresholds/ball-rolls-on-slope"]
        for exported, friction in ((scene.bodies, lambda one: one["contacts"][0]["friction"]), (scene.problem, lambda one: one["mu"][0])):
            with self.assertRaisesRegex(Refused, "slipproof export: --set: unknown parameter 'no'"):
                exported("no=1")
            self.assertEqual([float(Fraction(friction(exported(f"mu={value}")))) for value in (0.25, 0.5)], [0.25, 0.5])

    def opposes(self, built, values, number, friction, largest):
        """Whether friction points against a slip from rest."""
        contact = built["contacts"][number]
        of, on = (acceleration(built["bodies"], values, contact[side], contact["at"]) for side in ("of", "on"))
        slip = [sum(d * (p - q) for d, p, q in zip(contact[along], of, on)) for along in ("tangent", "second")]
        size = math.hypot(*slip)
        self.assertAlmostEqual(friction[0] * slip[0] + friction[1] * slip[1], -math.hypot(*friction) * size,
                               delta=1e-5 * largest * size)

    def obeys(self, exact, built, motion):
        """Newton's, Euler's and Coulomb's laws, by the bodies alone."""
        values = {key: middle(value) for key, value in motion["accelerations"].items()}
        forces = {key: middle(value) for key, value in motion["forces"].items()}
        pushes = [[*body["force"], *body["torque"]] for body in built["bodies"]]
        largest = 1e-9 + max(map(abs, list(forces.values()) + [f for push in pushes for f in push]))
        for i, (contact, state) in enumerate(zip(built["contacts"], motion["modes"][0].split("/"))):
            n, t1, t2 = [forces[name] for name in contact["forces"]] + [0] * (3 - len(contact["forces"]))
            force = [n * contact["normal"][k] + t1 * contact["tangent"][k] + t2 * contact["second"][k] for k in range(3)]
            for side, sign in (("of", 1), ("on", -1)):
                arm = [p - q for p, q in zip(contact["at"], built["bodies"][contact[side]]["at"])]
                for k, f in enumerate(force + cross(arm, force)):
                    pushes[contact[side]][k] += sign * f
            self.assertGreaterEqual(n, -1e-6 * largest)
            self.assertLessEqual(math.hypot(t1, t2), contact["friction"] * n + 1e-6 * largest)
            if state == "slip":
                self.assertAlmostEqual(math.hypot(t1, t2), contact["friction"] * n, delta=1e-5 * largest)
                if "state" not in exact["contacts"][i]:
                    self.opposes(built, values, i, (t1, t2), largest)
        for body, push in zip(built["bodies"], pushes):
            if "mass" in body:
                own = [values[name] * sign for name, sign in body["names"]]
                for k in range(3):
                    self.assertAlmostEqual(body["mass"] * (own[k] - built["gravity"][k]), push[k], delta=1e-5 * largest)
                turn = [in_axes(body["turn"], v) for v in (own[3:], push[3:])]
                for moment, alpha, couple in zip(body["inertia"], *turn):
                    self.assertAlmostEqual(moment * alpha, couple, delta=1e-5 * largest * built["size"])

    def test_expected_motions_in_space_obey_the_laws_of_motion(self):
        held = 0
        for name in sorted(name for name, scene in self.scenes.items() if scene.in_space)[::EVERY]:
            scene = self.scenes[name]
            exact = scene.bodies()
            if exact["joints"] or "impact" in scene.expected:
                continue
            built = WorldInSpace(exact).built()
            for motion in scene.expected["motions"]:
                if all(value and width(value) < 1e-6 for value in motion["forces"].values()):
                    with self.subTest(scene=name):
                        self.obeys(exact, built, motion)
                    held += 1
        self.assertGreater(held, 80 // EVERY)

    def test_principal_axes_turn_moments_into_the_inertia(self):
        moments, axes = principal([3, 2, 1, 0.5, -0.25, 0.125])
        again = [[sum(axes[i][k] * moments[k] * axes[j][k] for k in range(3)) for j in range(3)] for i in range(3)]
        for row, given in zip(again, ([3, 0.5, -0.25], [0.5, 2, 0.125], [-0.25, 0.125, 1])):
            for value, expected in zip(row, given):
                self.assertAlmostEqual(value, expected, 12)

    def test_whole_shapes_are_those_of_one_body_on_the_floor(self):
        turned, tower = (self.scenes[f"space-{name}"] for name in ("cone/cube-turned-37", "stand/two-cubes-0-0-0"))
        shape = turned.question(None, shapes=True)["ask"]["world"]["shapes"][0]
        self.assertEqual(shape["box"], [0.2, 0.2, 0.2])
        for value, expected in zip(shape["turn"], (3 / math.sqrt(10), 0, 0, 1 / math.sqrt(10))):  # half of tan = 3/4
            self.assertAlmostEqual(value, expected, 12)
        self.assertTrue(turned.on_floor())
        self.assertFalse(tower.on_floor())
        self.assertFalse(self.scenes["space-several/leaning-rod-1-1"].on_floor())  # it has no shape

    def test_what_creeps_is_asked_where_rest_is_the_one_motion(self):
        asked = [name for name, scene in self.scenes.items() if scene.rests]
        self.assertIn("space-slope/tripod-on-slope", asked)
        self.assertNotIn("space-several/jammed-ball-12-1-0", asked)  # it comes out as well
        self.assertNotIn("space-rolling/ball-rolls-0-0-3-4-0", asked)  # it moves on
        self.assertGreater(len(asked), 40)

    def test_energy_is_asked_where_nothing_drives(self):
        asked = {name for name, scene in self.scenes.items() if scene.undriven}
        self.assertLessEqual({"space-energy/box-slides", "space-energy/box-in-flight", "space-stand/three-cubes-0-0-0"}, asked)
        for driven in ("space-cone/cube-held-at-37", "space-slope/tripod-on-slope", "space-impact/pair-e-1"):
            self.assertNotIn(driven, asked)
        self.assertTrue(self.scenes["space-energy/box-in-flight"].stays)
        self.assertFalse(self.scenes["space-energy/box-slides"].stays)

    def test_in_space_what_no_first_step_can_say_is_refused(self):
        scene = self.scenes["space-rolling/tripod-spins-10-1-0"].bodies()
        WorldInSpace(scene).built()
        tilted = scene["bodies"][0] | {"spin": [1, 0, 10]}
        for change in ({"bodies": [tilted]}, {"friction": [{}]}):
            with self.assertRaises(Refused):
                WorldInSpace(scene | change).built()

    def bisection(self, motion):
        """Of an engine in which a ball moves by this part of its natural acceleration, by how far mu is below the
        threshold. It rolls above."""
        scene = self.scenes["thresholds/ball-rolls-on-slope"]
        at = scene.expected["threshold"]["changes"][0]["at"]["double"]
        bisection = Bisection(scene, None)
        bisection.seen = lambda value: ([10 * motion(at - float(value))], 10)
        return bisection, at

    def test_bisection_finds_where_an_engine_changes(self):
        for motion, floor, off in ((lambda x: max(x, 0), 1e-6, 1e-9),  # exact
                                   (lambda x: max(x, 0) + x * x / 900, 1e-3, 1e-4),  # creeps, the more the farther it is
                                   (lambda x: max(x, 0) + x * x / 9 * (x > 0), 1e-6, 1e-9),  # curved
                                   (lambda x: max(x, 0) + 2e-3, 1e-2, 1e-9),  # a soft contact
                                   (lambda x: 1 if x > 0 else 0, 1e-6, 1e-7)):  # it jumps
            bisection, at = self.bisection(motion)
            found, within, used = bisection.run()
            self.assertLess(abs(found - at), off)
            self.assertLess(within, 1e-3)
            self.assertAlmostEqual(used, floor)

    def test_bisection_gives_no_threshold_where_there_is_no_kink(self):
        for motion in (lambda x: 1, lambda x: 0, lambda x: 0.5 + x / 2, lambda x: 0.2 + x / 4,
                       lambda x: (x + 0.8) ** 2 / 4):
            with self.assertRaises(Refused):
                self.bisection(motion)[0].run()

    def test_step_is_shorter_where_bodies_are_fast(self):
        built = world(self.scenes["one-motion/ball-at-rest"].bodies())
        slow = step_of(built)
        built["gravity"] = [0, -1e6]
        self.assertLess(step_of(built), slow / 50)

    def test_what_no_first_step_can_say_is_refused(self):
        scene = self.scenes["one-motion/ball-at-rest"].bodies()
        for change in ({"bilateral": True}, {"static_friction": 1}, {"rolling_force": "S"}):
            contact = scene["contacts"][0] | change
            with self.assertRaises(Refused):
                world(scene | {"contacts": [contact]})


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
