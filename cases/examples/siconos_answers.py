"""What Siconos answers, judged in the same process: linear complementarity problems, and friction in space.

Needs python3-siconos beside slipproof; ends with 77 where that is missing.
"""

import sys

import numpy as np

import slipproof

try:
    import siconos.numerics as sn
except ImportError:
    sys.exit(77)


def problems(count, size, seed=1):
    """Integer matrices: some have no solution, some have several."""
    r = np.random.default_rng(seed)
    return r.integers(-3, 8, (count, size, size)).astype(float), r.integers(-6, 7, (count, size)).astype(float)


def answers(solver, W, q):
    """What the solver gives, and whether it calls that a success."""
    z, info = np.zeros_like(q), np.zeros(len(q), dtype=int)
    for k in range(len(q)):
        options = sn.SolverOptions(solver)
        info[k] = sn.linearComplementarity_driver(sn.LCP(W[k], q[k]), z[k], np.zeros_like(q[k]), options)
    return z, info


def complementarity():
    """A line for each method: what is proved about the answers that it calls a success."""
    W, q = problems(200, 4)
    for name, solver in (("Lemke", sn.SICONOS_LCP_LEMKE), ("Bard", sn.SICONOS_LCP_BARD),
                         ("Newton-min", sn.SICONOS_LCP_NEWTONMIN)):
        z, info = answers(solver, W, q)
        success = info == 0
        verdicts = slipproof.certify(W[success], q[success], z[success])
        told = ", ".join(f"{n} {verdict}" for verdict, n in sorted(verdicts.counts().items()))
        print(f"{name}: {success.sum()} of {len(q)} called a success: {told}")


def friction():
    """Two contacts that slide, or stick, by the nonsmooth Gauss-Seidel method."""
    r = np.random.default_rng(2)
    B = r.integers(-2, 3, (6, 6)).astype(float)
    W, q, mu = B @ B.T + np.eye(6), np.array([-3.0, 1, 0, -2, 0.5, 1]), np.array([0.5, 0.3])
    options = sn.SolverOptions(sn.SICONOS_FRICTION_3D_NSGS)
    options.dparam[sn.SICONOS_DPARAM_TOL] = 1e-12
    forces, velocities = np.zeros(6), np.zeros(6)
    info = sn.fc3d_driver(sn.FrictionContactProblem(3, W, q, mu), forces, velocities, options)
    verdict = slipproof.certify(W, q, forces, mu, dimension=3)
    print(f"NSGS: info {info}, {verdict.words().splitlines()[1].strip()}")


if __name__ == "__main__":
    complementarity()
    friction()
