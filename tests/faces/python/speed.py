"""Python against C++ in one run, on one core: the batch filter, and the solution of a scene.

    cmake --build build --target slipproof_python_speed
    PYTHONPATH=build/python python3 tests/faces/python/speed.py build/tests/faces/python/slipproof_python_speed

Without an argument: many contact problems in space in one call, on one core and on all, against a loop over calls, and
against the solver, Siconos' Gauss-Seidel method to 1e-12 (python3-siconos). A row for each number of contacts of a body:
microseconds of processor time a problem, and how much faster all cores are by the clock.
"""

import subprocess
import sys
import tempfile
import time

import numpy as np

import slipproof

SCENE = "cases/ambiguous.toml"


def best_of(repeats, work):
    """The least time that it takes."""
    best = float("inf")
    for _ in range(repeats):
        start = time.perf_counter()
        work()
        best = min(best, time.perf_counter() - start)
    return best


def columns(n):
    """A city bicycle on roads and under forces of all kinds."""
    r = np.random.default_rng(1)
    base = dict(M=94, R=0.3, h=0.56, b2=0.34, b3=0.68, I1=0.01, I2=0.12, I3=0.2, r1=0.09, r2=0.036, L=0.17, f=0.8,
                g=9.81, F=0, J=15.7)
    given = {name: value * r.uniform(0.9, 1.1, n) for name, value in base.items()}
    return {**given, "F": r.uniform(-9000, 9000, n)}


def cpp(program, given):
    """(scenes a second, seconds for a solution)."""
    with tempfile.NamedTemporaryFile(suffix=".columns") as file:
        np.concatenate(list(given.values())).tofile(file)
        file.flush()
        return map(float, subprocess.run([program, file.name, SCENE], capture_output=True, check=True).stdout.split())


def main(program, n=10**6):
    given = columns(n)
    cpp_rate, cpp_solution = cpp(program, given)
    rate = n / best_of(7, lambda: slipproof.consistent_modes(**given, threads=1))
    scene = slipproof.Scene.load(SCENE)
    solution = best_of(300, scene.solve)
    with_number = best_of(300, lambda: scene.solve().motions[0].a)
    document = best_of(300, lambda: scene.solve().to_dict())
    print(f"batch filter, {n} scenes: C++ {cpp_rate / 1e6:.2f}, Python {rate / 1e6:.2f} million a second, "
          f"{rate / cpp_rate:.3f} of it")
    for what, seconds in (("solve", solution), ("solve().motions[0].a", with_number), ("solve().to_dict()", document)):
        print(f"{what}: C++ {cpp_solution * 1e6:.0f}, Python {seconds * 1e6:.0f} us, {seconds / cpp_solution:.3f} times")


def problems(count, contacts, seed=1):
    """A body of random inertia that stands, slides or lifts on contacts at random places of its lower side."""
    r = np.random.default_rng(seed)
    places = r.uniform(-1, 1, (count, contacts, 3))
    places[:, :, 2] = -1
    H = np.zeros((count, 6, 3 * contacts))
    for axis, direction in enumerate(([0, 0, 1], [1, 0, 0], [0, 1, 0])):
        H[:, :3, axis::3] = np.array(direction, float)[None, :, None]
        H[:, 3:, axis::3] = np.cross(places, direction).transpose(0, 2, 1)
    W = H.transpose(0, 2, 1) @ H
    push = r.normal(size=(count, 6)) * [3, 3, 1, 1, 1, 1] - [0, 0, 10, 0, 0, 0]
    return W, np.einsum("kij,ki->kj", H, push), np.full(contacts, 0.5)


def answers(W, q, mu):
    import siconos.numerics as sn  # noqa: PLC0415 - not needed for anything else

    forces = np.zeros_like(q)
    for k in range(len(q)):
        options = sn.SolverOptions(sn.SICONOS_FRICTION_3D_NSGS)
        options.dparam[sn.SICONOS_DPARAM_TOL] = 1e-12
        options.iparam[sn.SICONOS_IPARAM_MAX_ITER] = 2000
        sn.fc3d_driver(sn.FrictionContactProblem(3, W[k], q[k], mu), forces[k], np.zeros_like(q[k]), options)
    return forces


def timed(work, count):
    """Microseconds a problem, by the processor and by the clock, and the result."""
    processor, clock = time.process_time(), time.perf_counter()
    result = work()
    return (time.process_time() - processor) / count * 1e6, (time.perf_counter() - clock) / count * 1e6, result


def batches():
    print(f"{'contacts':>8} {'solver':>8} {'loop':>8} {'one call':>8} {'all cores':>9}  verdicts")
    for contacts, count in ((1, 2000), (2, 300), (3, 100), (4, 60)):
        W, q, mu = problems(count, contacts)
        solver, _, z = timed(lambda: answers(W, q, mu), count)
        loop, _, _ = timed(lambda: [slipproof.certify(W[k], q[k], z[k], mu, dimension=3).verdict for k in range(count)], count)
        alone, by_clock, verdicts = timed(lambda: slipproof.certify(W, q, z, mu, dimension=3, threads=1), count)
        _, every, _ = timed(lambda: slipproof.certify(W, q, z, mu, dimension=3), count)
        print(f"{contacts:8} {solver:8.0f} {loop:8.0f} {alone:8.0f} {by_clock / every:9.1f}  {verdicts.counts()}", flush=True)


if __name__ == "__main__":
    main(sys.argv[1]) if len(sys.argv) > 1 else batches()
