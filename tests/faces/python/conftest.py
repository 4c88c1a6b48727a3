"""What the tests share: the project's folder, and the program to compare with."""

import json
import os
import subprocess
from pathlib import Path

import pytest

SOURCE = Path(__file__).resolve().parents[3]
PROGRAM = os.environ.get("SLIPPROOF_PROGRAM", str(SOURCE / "build" / "slipproof"))


@pytest.fixture(scope="session")
def source():
    """The top of the project."""
    return SOURCE


@pytest.fixture(autouse=True)
def at_the_top(monkeypatch):
    """Paths in tests and in doctests count from the top of the project."""
    monkeypatch.chdir(SOURCE)


@pytest.fixture(scope="session")
def program():
    """Runs the program; returns what it writes, as JSON where asked."""

    def run(*arguments, parse=True):
        alone = {name: value for name, value in os.environ.items() if name != "LD_PRELOAD"}  # it is not sanitized
        done = subprocess.run([PROGRAM, *map(str, arguments)], cwd=SOURCE, capture_output=True, check=False, env=alone)
        assert done.returncode in (0, 1, 4), done.stderr.decode()
        text = done.stdout.decode()
        return json.loads(text) if parse else text

    return run


@pytest.fixture(scope="session")
def random_scenes():
    """Many bicycles in double columns, some of them at the borders of modes; fixed seed."""
    import numpy as np

    def make(n, seed=1):
        r = np.random.default_rng(seed)
        c = dict(M=r.integers(60, 130, n), R=r.integers(20, 40, n) / 100, h=r.integers(20, 90, n) / 100,
                 b2=r.integers(30, 80, n) / 100, b3=r.integers(30, 80, n) / 100, I1=r.integers(0, 3, n) / 100,
                 I2=r.integers(5, 20, n) / 100, I3=r.integers(5, 20, n) / 100, r1=r.integers(5, 12, n) / 100,
                 r2=r.integers(3, 9, n) / 100, L=r.integers(15, 19, n) / 100, J=r.integers(5, 20, n),
                 f=r.integers(0, 12, n) / 10, g=np.full(n, 9.81), F=r.integers(-40, 40, n) * 50)
        return {name: values.astype(float) for name, values in c.items()}

    return make
