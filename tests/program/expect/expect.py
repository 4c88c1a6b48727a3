"""expect.py PROGRAM CASES FOLDER: what `slipproof expect` writes for pytest is run by pytest, with an engine that is
right and with one that is not."""

import json
import pathlib
import subprocess
import sys

program, cases, folder = sys.argv[1:]
folder = pathlib.Path(folder)
folder.mkdir(parents=True, exist_ok=True)
scenes = pathlib.Path(cases) / "engines" / "scenes"
files = [str(scenes / f"{name}.toml") for name in (
    "one-motion/cube-tips", "one-motion/two-boxes-move-together", "several-or-none/painleve-rod-inconsistent",
    "several-or-none/rod-lifted-and-pushed", "several-or-none/box-in-slot-flat", "undetermined/drum-in-rough-corner",
    "thresholds/friction-that-holds-a-drum", "extremes/gravity-10-km-slides", "space-cone/tripod-pushed-at-37",
    "space-stand/two-cubes-0-0-0", "space-several/leaning-rod-1-1")]
files += [str(pathlib.Path(cases) / "space" / f"{name}.toml") for name in ("domino", "stool-tipping", "ball-on-belt")]


def expect(form):
    return subprocess.run([program, "expect", *files, "--format", form], check=True, capture_output=True, text=True).stdout


def nearest(number):
    return number["double"] if "double" in number else number["lower"]["double"]


# In space the ends of a range are next to each other.
answers = {answer["scene"]: answer for answer in json.loads(expect("json"))}
assert len(answers) == len(files)

# pytest: the last motion that is expected is right, and so is None where there is none; anything else is not.
try:
    import pytest
except ImportError:
    print("not tried: there is no pytest")
    pytest = None
if pytest:
    text = expect("pytest")
    before, after = text.split("def accelerations(scene):")
    body = '    pytest.skip("accelerations(scene) is not written yet")\n'
    assert body in after

    def run(name, off):
        answered = {}
        for answer in answers.values():
            told = answer["motions"] + answer.get("continua", [])
            answered[answer["name"]] = (
                {u: nearest(told[-1]["accelerations"][u]) + off for u in answer["unknowns"]} if told
                else None if not off else {"ax": 0.0})
        engine = f"    return {answered!r}[scene['name']]\n"
        file = folder / f"test_{name}.py"
        file.write_text(before + "def accelerations(scene):" + after.replace(body, engine))
        end = subprocess.run([sys.executable, "-B", "-m", "pytest", "-q", "-p", "no:cacheprovider", str(file)], capture_output=True, text=True)
        return end.stdout.strip().splitlines()[-1]

    right, wrong = run("right", 0), run("wrong", 0.5)
    assert right.startswith(f"{len(files)} passed"), right
    assert wrong.startswith(f"{len(files)} failed"), wrong
