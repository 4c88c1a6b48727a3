"""independent.py SLIPPROOF CASES [TEXT]: the expected motions of the scenes in space (of those that contain TEXT) against a
program of its own. It derives the Delassus matrix and the free accelerations from the bodies as engines read them, and looks
for motions by Newton's method from random starts in every pattern of lift, stick and slip. Each that it finds must be one
that is expected; nothing that it misses is wrong. Scenes with joints, or with more contacts than patterns can be tried of,
are counted and left out, and so are continua."""

import os
import sys
from collections import Counter
from pathlib import Path
from types import SimpleNamespace

cases = Path(sys.argv[2]).resolve()
sys.path[:0] = [str(cases), str(Path(__file__).resolve().parents[2] / "contact/complete/independent")]
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # matrices are small
try:
    import numpy as np
except ImportError:
    sys.exit(77)
from asking.scenes import scenes_of  # noqa: E402
from asking.world import Refused  # noqa: E402
from newton import solutions_near  # noqa: E402

MOST_CONTACTS = 6  # 3^6 patterns
NEAR = 1e-5  # of accelerations, relative to the largest


def matrix(turn):
    w, x, y, z = turn
    v, K = np.array([x, y, z]), np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return (w * w - v @ v) * np.eye(3) + 2 * np.outer(v, v) + 2 * w * K


def inverse_mass(body):
    result = np.zeros((6, 6))
    if "mass" in body:
        turn = matrix(body["turn"])
        result[:3, :3] = np.eye(3) / body["mass"]
        result[3:, 3:] = turn @ np.diag(1 / np.array(body["inertia"])) @ turn.T
    return result


def free_acceleration(body, gravity):
    if "mass" not in body:
        return np.array(body["acceleration"] + body["turning"], dtype=float)
    return inverse_mass(body) @ np.array(body["force"] + body["torque"]) + np.array(gravity + [0, 0, 0])


class Problem:
    """u = W r + q in accelerations; W = J M^-1 F. A contact that slides from the beginning pushes along one direction, its
    normal and friction against the slip, and is without friction otherwise."""

    def __init__(self, world, states):
        bodies, contacts = world["bodies"], world["contacts"]
        self.names, self.bodies = [name for body in bodies for name in body["names"]], bodies
        J = np.zeros((3 * len(contacts), 6 * len(bodies)))
        for k, contact in enumerate(contacts):
            axes = np.array([contact["normal"], contact["tangent"], contact["second"]])
            for side, sign in (("of", 1), ("on", -1)):
                number = contact[side]
                arm = np.array(contact["at"]) - bodies[number]["at"]
                J[3 * k:3 * k + 3, 6 * number:6 * number + 6] = sign * np.c_[axes, np.cross(arm, axes)]
        F, mu = J.T.copy(), [contact["friction"] for contact in contacts]
        velocity = J @ np.concatenate([body["velocity"] + body["spin"] for body in bodies])
        for k, state in enumerate(states):
            if state == "slides":
                slip = velocity[3 * k + 1:3 * k + 3]
                F[:, 3 * k] -= mu[k] * F[:, 3 * k + 1:3 * k + 3] @ slip / np.hypot(*slip)
            if state == "slides" or mu[k] == 0:
                F[:, 3 * k + 1:3 * k + 3], mu[k] = 0, 0
        self.free = np.concatenate([free_acceleration(body, world["gravity"]) for body in bodies])
        inverse = np.zeros((len(self.free), len(self.free)))
        for i, body in enumerate(bodies):
            inverse[6 * i:6 * i + 6, 6 * i:6 * i + 6] = inverse_mass(body)
        self.response = inverse @ F
        self.contacts = SimpleNamespace(W=J @ self.response, q=J @ self.free, mu=mu)

    def accelerations(self, r):
        a = self.free + self.response @ r
        return {name[0]: name[1] * value for name, value in zip(self.names, a) if name}


def ends(value):
    if "double" in value:
        return value["double"], value["double"]
    return [float("-inf" if end == "lower" else "inf") if value[end] is None else value[end]["double"] for end in ("lower", "upper")]


def is_told(found, expected, free):
    """`free`: the largest free acceleration."""
    scale = max([free, *map(abs, found.values())])
    for motion in expected["motions"]:
        limits = {name: ends(motion["accelerations"][name]) for name in found}
        size = max([scale] + [abs(x) for pair in limits.values() for x in pair if np.isfinite(x)])
        if all(lower - NEAR * size <= found[name] <= upper + NEAR * size for name, (lower, upper) in limits.items()):
            return True
    return False


def look(scene, rng, count):
    """What is found and not told."""
    if scene.expected["how_many"] == "a continuum":
        count["scenes with a continuum of motions"] += 1
        return []
    try:
        question = scene.question(None)
    except Refused:
        count["scenes that no first step can say"] += 1
        return []
    world = question["ask"]["world"]
    if world["joints"] or len(world["contacts"]) > MOST_CONTACTS:
        count["scenes with joints" if world["joints"] else f"scenes with more than {MOST_CONTACTS} contacts"] += 1
        return []
    problem = Problem(world, [c.get("state") for c in question["contacts"] if c.get("state") != "open"])
    forces = [near.r for near in solutions_near(problem.contacts, rng, 100)] if world["contacts"] else [np.zeros(0)]
    found = [problem.accelerations(r) for r in forces]
    count["scenes that were tried"] += 1
    count["motions that were found"] += len(found)
    count["scenes of which none was found"] += not found and bool(scene.expected["motions"])
    return [motion for motion in found if not is_told(motion, scene.expected, np.abs(problem.free).max())]


def main():
    text, rng, count, wrong = sys.argv[3] if len(sys.argv) > 3 else "", np.random.default_rng(68), Counter(), 0
    for scene in scenes_of(cases, sys.argv[1]):
        if not scene.in_space or text not in scene.name or "impact" in scene.expected:
            continue
        for motion in look(scene, rng, count):
            wrong += 1
            print(f"{scene.name}: not told: {motion}", flush=True)
    print("; ".join(f"{n} {what}" for what, n in sorted(count.items())))
    if wrong or not count["motions that were found"]:
        sys.exit(f"{wrong} motions are not told")


main()
