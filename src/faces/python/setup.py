"""Builds the package slipproof with CMake: pip install --no-build-isolation ./src/faces/python

The environment variable SLIPPROOF_BUILD names a build folder of the project to use, perhaps one that is built already;
without it a folder of its own is made, which compiles the library. SLIPPROOF_PACKAGE_BUILD names the folder in which the
package is put together, build-python of the project otherwise. Both are relative to where the caller stands.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

HERE = Path(__file__).resolve().parent
PROJECT = HERE.parents[2]


def folder_of(variable: str, otherwise: Path) -> Path:
    """What the variable names, relative to where the caller stands: pip changes the folder, but not PWD."""
    named = os.environ.get(variable)
    return Path(os.environ.get("PWD", os.getcwd()), named).resolve() if named else otherwise


BUILT = folder_of("SLIPPROOF_PACKAGE_BUILD", PROJECT / "build-python")
TREE = folder_of("SLIPPROOF_BUILD", BUILT / "cmake")


def version() -> str:
    """The project's."""
    found = re.search(r"project\(slipproof VERSION ([0-9.]+)", (PROJECT / "CMakeLists.txt").read_text())
    if found is None:
        raise SystemExit(f"{PROJECT}/CMakeLists.txt: found no version of the project")
    return found[1]


class CMakeBuild(build_ext):
    """Hands the extension module to the project's own build."""

    def build_extension(self, ext: Extension) -> None:
        if not (TREE / "CMakeCache.txt").exists():
            off = [f"-DSLIPPROOF_{part}=OFF" for part in ("TESTS", "BENCHMARKS", "INSTALL")]
            subprocess.run(["cmake", "-S", PROJECT, "-B", TREE, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                            "-DSLIPPROOF_READ_HEADERS_ONCE=ON", f"-DPython_EXECUTABLE={sys.executable}", *off], check=True)
        subprocess.run(["cmake", "--build", TREE, "--target", "slipproof_python"], check=True)
        modules = list((TREE / "python" / "slipproof").glob("_core*.so"))
        if len(modules) != 1:
            raise SystemExit(f"{TREE}: found {len(modules)} modules, expected one")
        target = Path(self.get_ext_fullpath(ext.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(modules[0], target)


BUILT.mkdir(parents=True, exist_ok=True)
setup(
    name="slipproof",
    version=version(),
    description="Exact, provable answers about dry friction",
    long_description=(HERE / "README.md").read_text(encoding="utf-8"),
    long_description_content_type="text/markdown",
    python_requires=">=3.11",
    install_requires=["numpy"],
    packages=["slipproof"],
    # Under the name by which `-p` and `pytest_plugins` ask for it: pytest refuses a plugin under two names.
    entry_points={"pytest11": ["slipproof.testing = slipproof.testing"]},
    package_data={"slipproof": ["py.typed", "*.pyi"]},
    ext_modules=[Extension("slipproof._core", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
    options={"build": {"build_base": str(BUILT / "build")}, "egg_info": {"egg_base": str(BUILT)}},
    zip_safe=False,
)
