"""How long `slipproof certify` takes for piles, beside the solver: Siconos' Gauss-Seidel method (NSGS) to 1e-8.

    /usr/bin/python3 tests/contact/judge/piles.py build/slipproof            # all scenes: five minutes
    /usr/bin/python3 tests/contact/judge/piles.py build/slipproof tree1000 pile99

Each scene is a problem of bodies (M, H, f) in a file, with the solver's answer (`right`), with this answer off by at most
9e-3 of the largest force (`rough`), and with each force times 0.5 to 1.5 (`wrong`). Times are milliseconds of processor
time: of the solver's call, in which the matrix is there already; of `certify` with reading the file, less what it takes
to start. A * marks a solver that has not converged. Fails if an answer of a solver that has converged is `wrong`, or a
spoiled one certified. Needs python3-siconos, python3-numpy and python3-scipy; ends with 77 without them.
"""

import itertools
import json
import os
import resource
import subprocess
import sys
import tempfile
import time
import warnings
from pathlib import Path

os.environ["OPENBLAS_NUM_THREADS"] = "1"  # else its other threads, which nobody uses, turn for 50 ms when they start

try:
    import numpy as np
    import siconos.numerics as sn
    import scipy.sparse as sparse
except ImportError as missing:
    print(missing)
    sys.exit(77)

CERTIFIED = {"unique", "solution within rho", "velocities within rho", "velocities of a solution within rho", "ambiguous"}


class Scene:
    """Bodies of mass 1 with weight 10 and their contacts: rows of H^T are directions in velocities of bodies."""

    def __init__(self, dimension, bodies, inertia, mu):
        self.dimension, self.own = dimension, 3 * dimension - 3
        self.mass = np.tile(np.r_[np.ones(dimension), np.full(self.own - dimension, inertia)], bodies)
        self.push = np.zeros((bodies, self.own))
        self.push[:, dimension - 1] = -10
        self.mu, self.rows = mu, []

    def touch(self, body, other, normal, arm, other_arm=None):
        """A contact; `normal` is from the other one (None: what does not move) to the body, arms from their centres."""
        normal = np.asarray(normal, float)
        if self.dimension == 2:
            axes = [normal, np.array([-normal[1], normal[0]])]
        else:
            least = np.eye(3)[np.argmin(np.abs(normal))]
            first = np.cross(normal, least)
            first /= np.linalg.norm(first)
            axes = [normal, first, np.cross(normal, first)]
        for axis in axes:
            row = {}
            for which, sign, at in ((body, 1.0, arm), (other, -1.0, other_arm)):
                if which is None:
                    continue
                turn = np.cross(np.asarray(at, float), axis)
                for i, value in enumerate(np.r_[axis, turn]):
                    if value != 0:
                        row[self.own * which + i] = sign * value
            self.rows.append(row)

    @property
    def contacts(self):
        return len(self.rows) // self.dimension

    def matrix(self):
        entries = [(j, i, value) for i, row in enumerate(self.rows) for j, value in row.items()]
        j, i, value = zip(*entries)
        return sparse.csc_matrix((value, (j, i)), shape=(len(self.mass), len(self.rows)))


def ball(scene, body, other, normal):
    """Balls, or discs, of diameter 1 touch."""
    normal = np.asarray(normal, float)
    scene.touch(body, other, normal, -normal / 2, normal / 2)


def direction(random, dimension):
    """Within 60 degrees of upwards."""
    while True:
        v = random.normal(size=dimension)
        v /= np.linalg.norm(v)
        if v[-1] > 0.5:
            return v


def tree(n, random):
    """Each ball touches one before it: nothing is redundant."""
    scene = Scene(3, n, 0.1, 0.5)
    scene.push += 5 * random.normal(size=scene.push.shape)
    for k in range(n):
        ball(scene, k, int(random.integers(k)) if k > 0 else None, direction(random, 3))
    return scene


def chain(n, random):
    """Discs on the floor in a row, pushed together from one end."""
    scene = Scene(2, n, 0.125, 0.5)
    scene.push[0, 0] = 2 * n
    for k in range(n):
        ball(scene, k, None, (0, 1))
    for k in range(1, n):
        ball(scene, k, k - 1, (1, 0))
    return scene


def grid(n, random):
    """n x n discs between two walls, in rows and columns."""
    scene = Scene(2, n * n, 0.125, 0.5)
    for row in range(n):
        for k in range(n):
            ball(scene, n * row + k, n * (row - 1) + k if row > 0 else None, (0, 1))
        for k in range(n):
            ball(scene, n * row + k, n * row + k - 1 if k > 0 else None, (1, 0))
        ball(scene, n * row + n - 1, None, (-1, 0))
    return scene


def towers(n, random, boxes=5):
    """n towers of boxes, each box on its four corners, a little aside of the one below, and pushed a little."""
    scene = Scene(3, boxes * n, 1 / 6, 0.5)
    scene.push[:, :2] = random.integers(-64, 65, (boxes * n, 2)) / 128
    for body in range(boxes * n):
        stands = body % boxes == 0
        aside = np.zeros(2) if stands else random.integers(-32, 33, 2) / 1024
        for x, y in itertools.product((-0.5, 0.5), repeat=2):
            scene.touch(body, None if stands else body - 1, (0, 0, 1), (x, y, -0.5), (x + aside[0], y + aside[1], 0.5))
    return scene


def on_three(a, b, c):
    """Where a ball of diameter 1 touches three from above; None where it would roll off."""
    ab, ac = b - a, c - a
    up = np.cross(ab, ac)
    if up[2] < 0:
        b, c, ab, ac, up = c, b, ac, ab, -up
    square = up @ up
    centre = (np.cross(up, ab) * (ac @ ac) + np.cross(ac, up) * (ab @ ab)) / (2 * square)
    height = 1 - centre @ centre
    if height <= 0.01:
        return None
    at = a + centre + up * np.sqrt(height / square)
    inside = (np.cross((q - p)[:2], (at - p)[:2]) > 0.02 for p, q in ((a, b), (b, c), (c, a)))
    return at if all(inside) else None


def pile(n, random):
    """Balls on balls on the floor, each on three that it touches: directions are not round, and forces are open."""
    side = round(np.sqrt(n / 3))
    balls = [np.array([1.2 * (i + j % 2 / 2), 1.04 * j, 0]) + random.uniform(-0.02, 0.02, 3) * [3, 1, 0]
             for i in range(side) for j in range(side)]
    contacts, places = [(k, None, (0, 0, 1)) for k in range(len(balls))], []

    def add_places(k):
        apart = np.linalg.norm(np.array(balls[:k + 1]) - balls[k], axis=1)
        near = np.flatnonzero((apart < 1.6) & (apart > 0))
        for i, j in itertools.combinations(near, 2):
            if np.linalg.norm(balls[i] - balls[j]) < 1.6 and (at := on_three(balls[i], balls[j], balls[k])) is not None:
                places.append((at, (i, j, k)))

    for k in range(len(balls)):
        add_places(k)
    while places and len(contacts) + 3 <= n:
        at, three = places.pop(random.integers(len(places)))
        if (np.linalg.norm(np.array(balls) - at, axis=1) < 1 - 1e-9).any():
            continue
        balls.append(at)
        contacts += [(len(balls) - 1, int(j), at - balls[j]) for j in three]
        add_places(len(balls) - 1)
    scene = Scene(3, len(balls), 0.1, 0.5)
    for k, j, normal in contacts:
        ball(scene, k, j, normal / np.linalg.norm(normal))
    return scene


def solve(scene, sweeps=20_000):
    """Forces, seconds of processor time, and whether it has converged."""
    warnings.simplefilter("ignore")
    H = scene.matrix()
    scaled = sparse.diags(1 / scene.mass) @ H
    W = (H.T @ scaled).tocsc()
    W.sort_indices()
    q, d = scaled.T @ scene.push.ravel(), scene.dimension
    problem = sn.FrictionContactProblem(d, sn.SBM_from_csparse(d, W)[1], q, np.full(scene.contacts, scene.mu))
    options = sn.SolverOptions(sn.SICONOS_FRICTION_2D_NSGS if d == 2 else sn.SICONOS_FRICTION_3D_NSGS)
    options.dparam[sn.SICONOS_DPARAM_TOL] = 1e-8
    options.iparam[sn.SICONOS_IPARAM_MAX_ITER] = sweeps
    calls, seconds = 1 + copies(scene), 0
    for _ in range(calls):
        r, u = np.zeros(len(q)), np.zeros(len(q))
        start = time.process_time()
        failed = (sn.fc2d_driver if d == 2 else sn.fc3d_driver)(problem, r, u, options)
        seconds += time.process_time() - start
    return r, seconds / calls, not failed


def copies(scene):
    """How often a problem is judged after its first time: what takes a millisecond cannot be measured once."""
    return 40 if scene.contacts < 50 else 4 if scene.contacts < 200 else 0


def line_of(scene, r):
    """The problem with an answer."""
    H = scene.matrix().tocoo()
    n, m = H.shape
    entries = [[int(i), int(j), float(x)] for i, j, x in zip(H.row, H.col, H.data)]
    return json.dumps({"dimension": scene.dimension,
                       "M": {"rows": n, "columns": n, "entries": [[i, i, x] for i, x in enumerate(scene.mass)]},
                       "H": {"rows": n, "columns": m, "entries": entries},
                       "f": scene.push.ravel().tolist(), "w": [0.0] * m, "mu": scene.mu, "r": [float(x) for x in r]})


def certify(program, path, text):
    """Seconds of processor time for a file with this text, and the first line."""
    path.write_text(text)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([program, "certify", "--json", "--threads", "1", str(path)], capture_output=True, text=True,
                          check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    lines = [text for text in done.stdout.splitlines() if text.startswith('{"record"')]
    if not lines:
        raise RuntimeError(f"{path}: {done.stdout}{done.stderr}")
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, json.loads(lines[0])


MAKERS = {make.__name__: make for make in (tree, chain, grid, towers, pile)}
SCENES = ("tree5 tree20 tree100 tree1000 tree10000 chain3 chain12 chain50 chain150 grid2 grid3 grid7 grid12 grid22 "
          "towers1 towers49 pile12 pile30 pile99 pile999 pile3000").split()


def made(name, random):
    """A scene of any size: `chain12`."""
    kind = name.rstrip("0123456789")
    return MAKERS[kind](int(name[len(kind):]), random)


def spoiled(r, random):
    """Answers by name."""
    rough = 9e-3 * np.abs(r).max() * random.uniform(-1, 1, len(r))
    return {"right": r, "rough": r + rough, "wrong": r * random.uniform(0.5, 1.5, len(r))}


def main(program, names):
    path, failed = Path(tempfile.mkdtemp()) / "problem.jsonl", 0
    one = Scene(3, 1, 0.1, 0.5)
    ball(one, 0, None, (0, 0, 1))
    begin = min(certify(program, path, line_of(one, [10, 0, 0]) + "\n")[0] for _ in range(5))
    print(f"{'scene':>9} {'contacts':>8} {'NSGS':>8}  {'answer':<6} {'certify':>8} {'ratio':>6}  verdict")
    for name in names or SCENES:
        random = np.random.default_rng(7)
        scene = made(name, random)
        r, seconds, converged = solve(scene)
        for answer, forces in spoiled(r, random).items():
            line, more = line_of(scene, forces) + "\n", copies(scene)
            took, found = certify(program, path, line)
            took = (certify(program, path, line * (1 + more))[0] - took) / more if more else max(took - begin, 0)
            verdict = found["verdict"]
            bad = answer == "right" and converged and verdict == "wrong" or answer != "right" and verdict in CERTIFIED
            failed += bad
            print(f"{name:>9} {scene.contacts:8} {seconds * 1e3:8.2f}{' ' if converged else '*'} {answer:<6} "
                  f"{took * 1e3:8.1f} {took / seconds:6.1f}  {verdict} {found.get('rho', '')}{' FAILS' if bad else ''}",
                  flush=True)
    return failed > 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
