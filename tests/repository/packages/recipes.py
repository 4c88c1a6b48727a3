"""recipes.py SOURCES: the recipes for conda-build and vcpkg have the version, the libraries and options of CMakeLists.txt."""

import json
import re
import sys
from pathlib import Path

SOURCES = Path(sys.argv[1])
PACKAGE = SOURCES / "src/faces/package"
# What CMakeLists.txt looks for, and the packages that have it; None: from the system, as vcpkg.json cannot say.
NAMES = {
    "Boost": ("libboost-headers", "boost-multiprecision"), "Eigen3": ("eigen", "eigen3"), "fmt": ("fmt", "fmt"),
    "nlohmann_json": ("nlohmann_json", "nlohmann-json"), "CLI11": ("cli11", "cli11"), "TBB": ("tbb-devel", "tbb"),
    "pugixml": ("pugixml", "pugixml"), "gmp": ("gmp", "gmp"), "mpfr": ("mpfr", "mpfr"), "libmd": ("libmd", "libmd"),
    "udunits": ("udunits2", None), "FLINT": ("libflint", "flint"), "hdf5": ("hdf5", "hdf5"), "Clp": ("coin-or-clp", "coin-or-clp"),
    "PkgConfig": ("pkg-config", None),
}


def dependencies_of_conda(text):
    """The packages of `build` and `host`, one a line."""
    part = text.split("requirements:")[1].split("\ntest:")[0]
    return set(re.findall(r"^    - ([a-z][\w-]*)", part, re.M))


def dependencies_of_vcpkg(port):
    listed = port["dependencies"] + [one for feature in port["features"].values() for one in feature["dependencies"]]
    return {one if isinstance(one, str) else one["name"] for one in listed}


def main():
    cmake = (SOURCES / "CMakeLists.txt").read_text()
    conda = (PACKAGE / "conda/meta.yaml").read_text()
    portfile = (PACKAGE / "vcpkg/portfile.cmake").read_text()
    port = json.loads((PACKAGE / "vcpkg/vcpkg.json").read_text())
    problems = []

    version = re.search(r"project\(slipproof VERSION (\S+)", cmake)[1]
    for where, found in ("meta.yaml", re.search(r'version: "(.*)"', conda)[1]), ("vcpkg.json", port["version"]):
        if found != version:
            problems.append(f"{where}: version {found}; CMakeLists.txt has {version}")

    sought = re.findall(r"(?:find_package|pkg_check_modules)\((\w+)", cmake)
    here = dependencies_of_conda(conda), dependencies_of_vcpkg(port)
    for library in sought:
        if library not in NAMES:
            problems.append(f"CMakeLists.txt looks for {library}, which no recipe has")
            continue
        for where, name, has in zip(("meta.yaml", "vcpkg.json"), NAMES[library], here):
            if name and name not in has:
                problems.append(f"{where}: {name} is missing, for {library}")

    options = set(re.findall(r"option\((SLIPPROOF_\w+)", cmake))
    given = [set(re.findall(r"-D (SLIPPROOF_\w+=\w+)", text)) for text in (conda, portfile)]
    if given[0] != given[1] or not given[0]:
        problems.append(f"the recipes differ in {sorted(given[0] ^ given[1])}")
    for option in {word.partition("=")[0] for word in given[0] | given[1]} | set(re.findall(r"\w+ (SLIPPROOF_(?:CLP|HDF5))", portfile)):
        if option not in options:
            problems.append(f"CMakeLists.txt has no option {option}")

    print("\n".join(problems) or f"{len(sought)} libraries and {len(given[0])} options agree")
    return 1 if problems else 0


sys.exit(main())
