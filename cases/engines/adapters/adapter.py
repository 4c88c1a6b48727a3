"""What adapters in Python share: reads the lines, gives each scene to the engine, writes the answers."""

import json
import sys


class Refused(Exception):
    """Why an engine cannot have a scene."""


def on_floor(line):
    """The world of a scene in space, and the one body that stands on its floor by whole shapes."""
    world = line["ask"]["world"]
    if any("hull" in shape for shape in world["shapes"]):
        raise Refused("the adapter has no hulls")
    return world, world["bodies"][1]


def inertia(body, invert=False):
    """Row by row, about the axes of the scene; or its inverse."""
    moments = [1 / m if invert else m for m in body["inertia"]]
    w, x, y, z = body["turn"]
    axes = [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]
    return [[sum(a * m * b for a, m, b in zip(one, moments, other)) for other in axes] for one in axes]


def motion(line, body, after):
    """Accelerations by the names of the unknowns, from velocity and spin after the step; of an impact these."""
    before = body["velocity"] + body["spin"]
    changed = [a if "impact" in line else (a - b) / line["ask"]["step"] for a, b in zip(after, before)]
    return {name[0]: name[1] * value for name, value in zip(body["names"], changed) if name}


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
