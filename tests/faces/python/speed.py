"""Python against C++ in one run, on one core: the batch filter, and the solution of a scene.

    cmake --build build --target slipproof_python_speed
    PYTHONPATH=build/python python3 tests/faces/python/speed.py build/tests/faces/python/slipproof_python_speed
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


if __name__ == "__main__":
    main(sys.argv[1])
