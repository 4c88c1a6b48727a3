#!/usr/bin/env python3
"""The scenes in space that people ask about: each is solved completely, with the motions that are recorded beside it.

    scenes.py SLIPPROOF CASES [--record]

A number that is recorded as one fraction must be that fraction; an enclosure must have a number in common with the
recorded one. Each motion must be proved to exist, and be of the recorded mode where that is a strict one.
"""
import json
import subprocess
import sys
import time
from fractions import Fraction
from pathlib import Path


def solved(program, scene):
    begin = time.monotonic()
    run = subprocess.run([program, "solve", scene, "--json"], capture_output=True, text=True)
    if run.stderr or not run.stdout:
        return None, f"{scene}: {run.stderr}", 0
    return json.loads(run.stdout), "", time.monotonic() - begin


def same(recorded, found):
    if recorded is None or found is None:
        return recorded == found
    low, high = map(Fraction, recorded)
    other_low, other_high = map(Fraction, found)
    if low == high:
        return other_low == other_high == low
    return other_low < other_high and low <= other_high and other_low <= high


def same_motion(recorded, found):
    """Forces that are open are any of theirs, and so is the mode of a motion at a border."""
    keys = ["accelerations", "slips"]
    if recorded["status"] == "strict":
        if recorded["modes"] != found["modes"] or recorded["open_directions"] != found["open_directions"]:
            return False
        keys += ["forces"] if recorded["open_directions"] == 0 else []
    names = {key: recorded[key].keys() & found[key].keys() if key == "slips" else recorded[key].keys() for key in keys}
    return found["exists"] and all(same(recorded[key][name], found[key].get(name)) for key in keys for name in names[key])


def mistakes(recorded, found):
    if not found["complete"] or found["undecided"]:
        return "it is not complete"
    if len(recorded["motions"]) != len(found["motions"]):
        return f"found {len(found['motions'])} motions, expected {len(recorded['motions'])}"
    left = list(found["motions"])
    for motion in recorded["motions"]:
        match = next((m for m in left if same_motion(motion, m)), None)
        if match is None:
            return f"found no motion that is the recorded {motion}, but {left}"
        left.remove(match)
    return ""


def main():
    program, cases, record = sys.argv[1], Path(sys.argv[2]), "--record" in sys.argv
    scenes = sorted(cases.glob("*.toml"))
    assert len(scenes) >= 10
    wrong = []
    for scene in scenes:
        found, message, seconds = solved(program, scene)
        answer = cases / "expected" / f"{scene.stem}.json"
        if found and record:
            found.pop("programs", None)
            answer.parent.mkdir(exist_ok=True)
            answer.write_text(json.dumps(found, indent=2) + "\n")
        message = message or mistakes(json.loads(answer.read_text()), found)
        print(f"{scene.stem}: {seconds:.2f} s", flush=True)
        if message:
            wrong.append(f"{scene.stem}: {message}")
    if wrong:
        sys.exit("\n".join(wrong))


main()
