"""Scenes as questions: exported by slipproof at any value of a parameter."""

import contextlib
import functools
import json
import os
import shutil
import subprocess
import threading
from fractions import Fraction
from pathlib import Path

from .space import WorldInSpace, own_shapes
from .world import Refused, step_of, world


running = threading.local()  # the exporters of the scene that a thread asks about, by their form


class Exporter:
    """`slipproof export --each` of a scene, which starts once for all values at which the scene is asked."""

    def __init__(self, file, form, program):
        self.command, self.folder = [program, "export", file.name, *[form] * bool(form), "--each"], file.parent
        self.process = None

    def at(self, settings):
        """The scene at NAME=VALUE settings. Raises Refused."""
        if not self.process:
            self.process = subprocess.Popen(self.command, cwd=self.folder, stdin=subprocess.PIPE,
                                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        with contextlib.suppress(BrokenPipeError):  # it has refused the scene
            self.process.stdin.write(" ".join(settings) + "\n")
            self.process.stdin.flush()
        line = self.process.stdout.readline()
        if not line:
            raise Refused(f"slipproof export: {self.ended().strip()}")
        return json.loads(line)

    def ended(self):
        """What it says to standard error, at its end."""
        process, self.process = self.process, None
        with contextlib.suppress(BrokenPipeError):
            process.stdin.close()
        with process:
            return process.stderr.read()

    def __del__(self):
        if self.process:
            self.ended()


class Scene:
    def __init__(self, file, program, expected=None):
        self.file, self.program = Path(file), program
        self.name = f"{self.file.parent.name}/{self.file.stem}"
        self.expected = expected
        self.in_space = self.file.parent.name.startswith("space-")

    @property
    def rests(self):
        """Whether rest is its one motion, in space."""
        if not (self.in_space and self.expected and self.expected.get("can_rest") and self.expected["how_many"] == "one"):
            return False
        return all(value.get("double", 0) == 0 for value in self.expected["motions"][0]["accelerations"].values())

    @functools.cached_property
    def undriven(self):
        """Whether nothing but gravity, straight down, acts on bodies in space that touch or rest or fly: no push, no motor,
        no impact. Their energy never grows."""
        if not self.in_space or not self.expected or "impact" in self.expected:
            return False
        scene = self.bodies()
        pushes = [force["is"] for force in scene["forces"] + scene["torques"]]
        held = any("mass" not in body for body in scene["bodies"]) or any(j["kind"] == "spring" for j in scene["joints"])
        return not any(map(any, pushes)) and not any(scene["gravity"][:2]) and not held

    @property
    def stays(self):
        """Whether contacts stay where they are: it rests, or has none."""
        return self.rests or all(contact.get("state") == "open" for contact in self.bodies()["contacts"])

    def on_floor(self):
        """Whether it is one body on a level floor, with shapes that engines have."""
        try:
            self.question(None, shapes=True)
        except Refused:
            return False
        return True

    def bodies(self, *settings):
        """The scene in numbers, at NAME=VALUE settings. Raises Refused, with the words of slipproof."""
        return self.exported("--bodies", *settings)

    def problem(self, *settings):
        """Its contact problem, for solvers that have no bodies."""
        return self.exported("", *settings)

    @functools.lru_cache(maxsize=65536)
    def exported(self, form, *settings):
        if getattr(running, "file", None) != self.file:
            running.file, running.exporters = self.file, {}
        if form not in running.exporters:
            running.exporters[form] = Exporter(self.file, form, self.program)
        return running.exporters[form].at(settings)

    def question(self, iterations, *settings, shapes=False):
        """A line for an adapter, with the shapes of the body that stands on the floor. Raises Refused."""
        scene = self.bodies(*settings)
        built = WorldInSpace(scene).built() if len(scene["gravity"]) == 3 else world(scene)
        if shapes:
            built["shapes"] = own_shapes(scene, built)
        return scene | {"ask": {"step": step_of(built), "iterations": iterations, "world": built}}


def scenes_of(folder, program):
    """All scenes below a folder, sorted by class and name, with what is expected of them where that is recorded."""
    result, program = [], os.path.abspath(shutil.which(program) or program)
    for file in sorted((folder / "scenes").glob("*/*.toml")):
        expected = folder / "expected" / file.parent.name / f"{file.stem}.json"
        result.append(Scene(file, program, json.loads(expected.read_text()) if expected.exists() else None))
    return result


def exact(number):
    """A number of slipproof/expected/1: exactly, or, if it is algebraic, the nearest double."""
    return Fraction(number["exact"] if "exact" in number else number["double"])
