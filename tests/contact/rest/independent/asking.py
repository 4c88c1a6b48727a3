"""What both comparisons share: their options, how slipproof is asked, and how what was found is counted."""
import argparse
import json
import random
import subprocess
import sys
import tempfile
from pathlib import Path


def options(*flags):
    parser = argparse.ArgumentParser()
    parser.add_argument("slipproof")
    parser.add_argument("count", type=int)
    parser.add_argument("size", type=int, nargs="?", default=6)
    parser.add_argument("--seed", type=int, default=0)
    for flag in flags:
        parser.add_argument(flag, action="store_true")
    return parser.parse_args()


def ask(slipproof, scene, *more):
    run = subprocess.run([slipproof, "rest", str(scene), "--json", *more], capture_output=True, text=True)
    try:
        return json.loads(run.stdout)
    except json.JSONDecodeError:
        return {"failed": f"exit code {run.returncode}: {run.stderr or run.stdout}"}


def compare(chosen, structure_of, differences, *more):
    """Asks about structures with the seeds from `--seed` on, with more options; prints what differs, and ends with an error if anything does."""
    counts, bad = {}, 0
    for k in range(chosen.seed, chosen.seed + chosen.count):
        s = structure_of(random.Random(k), f"s{k}", chosen.size)
        with tempfile.TemporaryDirectory() as folder:
            answer = ask(chosen.slipproof, s.write(Path(folder)), *more)
        found = [answer["failed"]] if "failed" in answer else differences(s, answer)
        said = f"can_rest {answer.get('can_rest')}, touching {answer.get('touching')}"
        counts[said] = counts.get(said, 0) + 1
        for message in found:
            print(f"s{k}, {len(s.bodies)} bodies, {len(s.contacts)} contacts: {message}", flush=True)
        bad += bool(found)
    for said, n in sorted(counts.items()):
        print(f"{n:6} {said}")
    if bad or not any("True" in said for said in counts) or not any("can_rest False" in said for said in counts):
        sys.exit(f"{bad} of {chosen.count} differ, or the answers are all alike")
