#!/usr/bin/env python3
"""How many scenes of others can rest, and must: imports each file in space, and asks `slipproof rest`.

    at_rest.py SLIPPROOF FILE...

A file that is not read with its meshes is read without. A line for each file, then the counts. URDF, and worlds without
a plane, get a level ground.
"""
import collections
import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

READ = ["--space", "--stand", "--mass", "1", "--without-overlaps", "--quiet"]
GROUND = ["--ground", "0", "--mu", "1"]
EFFORT = "3000000000"
LIMIT = 60  # seconds


def run(*command):
    try:
        return subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=LIMIT)
    except subprocess.TimeoutExpired:
        return None


def is_without_ground(file):
    return file.suffix == ".urdf" or (file.suffix in (".world", ".sdf") and "<plane>" not in file.read_text(errors="replace"))


def imported(slipproof, file, scene):
    options = READ + (GROUND if is_without_ground(file) else [])
    for more in ([], ["--without-meshes"]):
        done = run(slipproof, "import", file, *options, *more, "-o", scene)
        if done and done.returncode == 0:
            return True
    return False


def asked(slipproof, scene):
    """What is said, and why."""
    done = run(slipproof, "rest", scene, "--json", "--effort", EFFORT)
    if done is None:
        return f"no answer within {LIMIT} s", ""
    try:
        answer = json.loads(done.stdout)
    except json.JSONDecodeError:
        return "refused", done.stderr.strip().splitlines()[0][-150:]
    words = {True: "can rest", False: "cannot rest", None: "undecided"}[answer["can_rest"]]
    if answer["can_rest"]:
        words += {True: ", must", False: ", need not", None: ", whether it must is open"}[answer["must_rest"]]
    return words, answer["must_rest_because"]


def main():
    slipproof, *files = sys.argv[1:]
    counts, longest = collections.Counter(), 0.0
    with tempfile.TemporaryDirectory() as folder:
        for file in map(Path, files):
            scene = Path(folder) / "scene.toml"
            if not imported(slipproof, file, scene):
                counts["not read"] += 1
                continue
            start = time.monotonic()
            words, why = asked(slipproof, scene)
            seconds = time.monotonic() - start
            longest = max(longest, seconds)
            counts[words] += 1
            print(f"{file}: {words}; {why}; {seconds:.1f} s", flush=True)
    for words, count in counts.most_common():
        print(f"{count:4} {words}")
    print(f"at most {longest:.0f} s")


if __name__ == "__main__":
    main()
