"""numpy_of_debian.py FOLDER: makes in FOLDER a wheel of the NumPy of Debian's package python3-numpy, for a test in an
environment without system packages and without a network. It needs Debian's libblas3 and liblapack3."""

import subprocess
import sys
import zipfile
from pathlib import Path

SITE = "/usr/lib/python3/dist-packages/"
listing = subprocess.run(["dpkg", "-L", "python3-numpy"], check=True, capture_output=True, text=True).stdout.splitlines()
version = next(line for line in listing if line.endswith(".egg-info")).rpartition("numpy-")[2].removesuffix(".egg-info")
info = f"numpy-{version}.dist-info"
python = f"cp{sys.version_info.major}{sys.version_info.minor}"
with zipfile.ZipFile(Path(sys.argv[1], f"numpy-{version}-{python}-{python}-linux_x86_64.whl"), "w") as wheel:
    for line in listing:
        if line.startswith(SITE + "numpy/") and Path(line).is_file():
            wheel.write(line, line.removeprefix(SITE))
    wheel.writestr(f"{info}/METADATA", f"Metadata-Version: 2.1\nName: numpy\nVersion: {version}\n")
    wheel.writestr(f"{info}/WHEEL", f"Wheel-Version: 1.0\nRoot-Is-Purelib: false\nTag: {python}-{python}-linux_x86_64\n")
    wheel.writestr(f"{info}/RECORD", "".join(f"{name},,\n" for name in [*wheel.namelist(), f"{info}/RECORD"]))
