"""What adapters in Python share: reads the lines, gives each scene to the engine, writes the answers."""

import json
import sys


class Refused(Exception):
    """Why an engine cannot have a scene."""


def answer_to(engine, version, law, ask, line):
    head = {"schema": "slipproof/engine-answer/1", "engine": engine, "version": version, "scene": line["name"]}
    try:
        motion, forces, settings = ask(line)
        return head | {"settings": settings, "motion": motion, "forces": forces, "law": law}
    except Refused as reason:
        return head | {"refused": str(reason)}


def run(engine, version, law, ask):
    """Answers all lines of standard input. `ask(line)` gives accelerations by the names of the unknowns, forces by
    their names or None, and settings."""
    for line in sys.stdin:
        print(json.dumps(answer_to(engine, version, law, ask, json.loads(line))), flush=True)
