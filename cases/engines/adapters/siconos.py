"""Siconos: the contact problem that `slipproof export` writes, by the nonsmooth Gauss-Seidel method or, with the argument
lemke, by Lemke's. Joints are eliminated first, in binary64. Default is what solver options come with."""

import subprocess
import sys
from fractions import Fraction

sys.path.append(sys.path.pop(0))  # this file has the name of the module
import numpy as np  # noqa: E402
import siconos.numerics as sn  # noqa: E402

from adapter import Refused, run  # noqa: E402

LEMKE = sys.argv[1:] == ["lemke"]


def numbers(given):
    return np.array([[float(Fraction(x)) for x in row] if isinstance(row, list) else float(Fraction(row)) for row in given])


def reduced(problem):
    """v = P r + p by M v = H r + G lambda + f, G^T v + b = 0."""
    M, H, f = (numbers(problem[key]) for key in ("M", "H", "f"))
    if "G" not in problem:
        return H, np.linalg.solve(M, H), np.linalg.solve(M, f)
    G, b = numbers(problem["G"]), numbers(problem["b"])
    n, k = G.shape
    K = np.block([[M, -G], [G.T, np.zeros((k, k))]])
    right = np.block([[H, f[:, None]], [np.zeros((k, H.shape[1])), -b[:, None]]])
    solved = np.linalg.lstsq(K, right, rcond=None)[0][:n]
    return H, solved[:, :-1], solved[:, -1]


def ask(line):
    problem = line["ask"]["problem"]
    if not problem:
        raise Refused("slipproof exports no contact problem of the scene at these values")
    names = [name for body in line["bodies"] for name, _ in body["unknowns"]]
    contacts = [c for c in line["contacts"] if c.get("state") != "open"]
    in_space = len(line["gravity"]) == 3
    if in_space and any(c.get("state") == "slides" for c in contacts):
        raise Refused("a contact that slides already: the problem is one from rest")
    if in_space and LEMKE:
        raise Refused("a scene in space: Lemke's method is for the plane")
    H, P, p = reduced(problem)
    if problem["contacts"] != [c["name"] for c in contacts] or len(names) != len(p):
        raise Refused("elements that a planar contact problem does not have")
    r, u = np.zeros(H.shape[1]), np.zeros(H.shape[1])
    options = sn.SolverOptions(sn.SICONOS_FRICTION_2D_LEMKE if LEMKE else
                               sn.SICONOS_FRICTION_3D_NSGS if in_space else sn.SICONOS_FRICTION_2D_NSGS)
    if line["ask"]["iterations"] and not LEMKE:
        options.iparam[sn.SICONOS_IPARAM_MAX_ITER] = line["ask"]["iterations"]
        options.dparam[sn.SICONOS_DPARAM_TOL] = 1e-14
    settings = {"solver": "lemke" if LEMKE else "nsgs", "iterations": int(options.iparam[sn.SICONOS_IPARAM_MAX_ITER]),
                "tolerance": float(options.dparam[sn.SICONOS_DPARAM_TOL])}
    q = H.T @ p + numbers(problem["w"])
    if len(r):
        size = 3 if in_space else 2
        given = sn.FrictionContactProblem(size, H.T @ P, q, numbers(problem["mu"]))
        settings["info"] = int((sn.fc3d_driver if in_space else sn.fc2d_driver)(given, r, u, options))
    forces = {name: float(r[(3 if in_space else 2) * i + k]) for i, c in enumerate(contacts) for k, name in enumerate(c["forces"])}
    return dict(zip(names, map(float, P @ r + p))), forces, settings


def version():
    """Debian's, which its Python package does not know."""
    told = subprocess.run(["dpkg-query", "-Wf", "${Version}", "python3-siconos"], capture_output=True, text=True)
    return told.stdout or "unknown"


run("siconos-lemke" if LEMKE else "siconos", version(), "cone; the acceleration problem itself", ask)
