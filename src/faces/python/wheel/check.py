"""check.py SCENE: uses the installed package slipproof, and says what it is. Its libraries must be its own."""

import ctypes
import re
import sys
import tempfile
from pathlib import Path

import numpy as np
import slipproof

home = Path(slipproof.__file__).parent
assert home.is_relative_to(sys.prefix), f"slipproof is imported from {home}"

W, q = [[2, 1], [1, 2]], [-5, -6]
assert slipproof.certify(W, q, ["4/3", "7/3"], tolerance=0).verdict == "certified"
assert slipproof.certify(W, q, [2.5, 0]).margin == "-7/2"
many = 10_000  # on all threads
answers = slipproof.certify(np.array(W, dtype=float), np.tile(q, (many, 1)).astype(float), np.tile([4 / 3, 7 / 3], (many, 1)))
assert set(answers.verdicts) == {"certified"}
scene = slipproof.Scene.load(sys.argv[1])
assert [motion.modes for motion in scene.solve().motions] == [("stick/stick",), ("stick/slip+",), ("stick/lift",)]
assert str(slipproof.critical(scene).critical) == "21/25"
units = "libudunits2-0" not in slipproof.Mechanism.load("ladder").show()  # which says so where it is missing
try:
    ctypes.CDLL("libudunits2.so.0")
except OSError:
    assert not units
else:
    assert units
assert slipproof.prove("x^2 + y^2 >= 2*x*y").verdict == "proved"
assert slipproof.prove("x^2 + y^2 >= 3*x*y").verdict == "refuted"

with tempfile.NamedTemporaryFile(suffix=".hdf5") as file:
    file.write(b"\x89HDF\r\n\x1a\n" + bytes(500))
    file.flush()
    try:
        raise SystemExit(f"HDF5 was read: {slipproof.certify_file(file.name)}")
    except slipproof.InputError as error:
        assert "libhdf5-dev" in str(error), error

mapped = {line.split()[-1] for line in Path("/proc/self/maps").read_text().splitlines() if ".so" in line}
foreign = [path for path in mapped if re.search(r"/lib(flint|gmp|mpfr|tbb|fmt|pugixml|md|hdf5)\b", path) and not path.startswith(sys.prefix)]
assert not foreign, f"these libraries are not the wheel's: {foreign}"
print(f"slipproof {slipproof.__version__} with NumPy {np.__version__} in Python {sys.version.split()[0]}, {'with' if units else 'without'} units: used")
