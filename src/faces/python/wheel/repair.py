"""repair.py WHEEL FOLDER [PACKAGE...]: writes into FOLDER the wheel with the shared libraries that it needs and with its
true manylinux tag, as auditwheel does, which Debian 12 lacks.

Libraries that a tag promises stay outside (PEP 600). Each other one that ldd finds goes into slipproof.libs under a name
with its hash, and is found there by RPATH. The tag is the oldest glibc that has all versions of symbols which are needed.
The copyright files of the Debian packages go into the wheel's licenses.
"""

from __future__ import annotations

import base64
import hashlib
import re
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path
from typing import Dict, List, Tuple

Version = Tuple[int, ...]
OUTSIDE = re.compile(r"(libc|libm|libdl|librt|libpthread|libstdc\+\+|libgcc_s|ld-linux-x86-64)\.so\.\d+")
# From which glibc on a tag promises versions of the compiler's libraries up to this one: auditwheel's policies for x86_64.
PROMISED: Dict[str, List[Tuple[Version, Version]]] = {
    "GLIBCXX": [((3, 4, 19), (2, 17)), ((3, 4, 22), (2, 24)), ((3, 4, 24), (2, 27)), ((3, 4, 28), (2, 31)), ((3, 4, 29), (2, 34)),
                ((3, 4, 30), (2, 35)), ((3, 4, 33), (2, 39))],
    "CXXABI": [((1, 3, 7), (2, 17)), ((1, 3, 10), (2, 24)), ((1, 3, 11), (2, 27)), ((1, 3, 12), (2, 31)), ((1, 3, 13), (2, 34)),
               ((1, 3, 15), (2, 39))],
    "GCC": [((4, 8, 0), (2, 17)), ((7, 0, 0), (2, 27)), ((12, 0, 0), (2, 35)), ((14, 0, 0), (2, 39))],
}


def run(*command: object) -> str:
    return subprocess.run([str(part) for part in command], check=True, capture_output=True, text=True).stdout


def least_glibc(symbols: str) -> Version:
    """The oldest glibc whose tag promises what `objdump -T` lists as undefined."""
    found: Version = (2, 17)
    for name, text in re.findall(r"\*UND\*.*\((GLIBC|GLIBCXX|CXXABI|GCC)_([0-9.]+)\)", symbols):
        version = tuple(int(part) for part in text.split("."))
        enough = [(version, version)] if name == "GLIBC" else PROMISED[name]
        fitting = [glibc for last, glibc in enough if version <= last]
        if not fitting:
            raise SystemExit(f"repair.py: no manylinux tag promises {name}_{text}")
        found = max(found, fitting[0])
    return found


def libraries(listing: str) -> Dict[str, Path]:
    """Those of `ldd -r` that no tag promises. All symbols must be found, but for Python's own."""
    missing = re.findall(r"(\S+) => not found", listing) + re.findall(r"undefined symbol: (?!_?Py)(\S+)", listing)
    if missing:
        raise SystemExit(f"repair.py: these are not found: {', '.join(missing)}")
    return {name: Path(path) for name, path in re.findall(r"(\S+) => (/\S+)", listing) if not OUTSIDE.fullmatch(name)}


def bundle(tree: Path) -> Version:
    """Copies libraries into the wheel, and returns the least glibc."""
    modules = sorted(tree.rglob("*.so"))
    needed = {name: path for module in modules for name, path in libraries(run("ldd", "-r", module)).items()}
    folder = tree / "slipproof.libs"
    names, copies = {}, []
    for name, path in sorted(needed.items()):
        content = path.read_bytes()
        stem, rest = name.split(".so", 1)
        names[name] = f"{stem}-{hashlib.sha256(content).hexdigest()[:8]}.so{rest}"
        folder.mkdir(exist_ok=True)
        copies.append(folder / names[name])
        copies[-1].write_bytes(content)
        run("strip", "--strip-unneeded", copies[-1])
        run("patchelf", "--set-soname", names[name], copies[-1])
    for file in modules + copies:
        for name in set(run("patchelf", "--print-needed", file).split()) & set(names):
            run("patchelf", "--replace-needed", name, names[name], file)
        up = "" if file in copies else "/" + "../" * (len(file.relative_to(tree).parts) - 1) + "slipproof.libs"
        run("patchelf", *(("--force-rpath", "--set-rpath", f"$ORIGIN{up}") if names else ("--remove-rpath",)), file)
    return max(least_glibc(run("objdump", "-T", file)) for file in modules + copies)


def write(tree: Path, wheel: Path) -> None:
    """The wheel, with its RECORD; the same bytes for the same files."""
    record = next(tree.glob("*.dist-info")) / "RECORD"
    lines = []
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for file in sorted(p for p in tree.rglob("*") if p.is_file() and p != record) + [record]:
            name = file.relative_to(tree).as_posix()
            content = file.read_bytes() if file != record else "".join([*lines, f"{name},,\n"]).encode()
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
            lines.append(f"{name},sha256={digest},{len(content)}\n")
            entry = zipfile.ZipInfo(name)
            entry.external_attr = (0o755 if ".so" in file.name else 0o644) << 16
            archive.writestr(entry, content, zipfile.ZIP_DEFLATED, 9)


def repair(wheel: Path, folder: Path, packages: List[str]) -> Path:
    with tempfile.TemporaryDirectory() as scratch:
        tree = Path(scratch)
        with zipfile.ZipFile(wheel) as archive:
            archive.extractall(tree)
        tag = "manylinux_{}_{}_x86_64".format(*bundle(tree))
        info = next(tree.glob("*.dist-info"))
        (info / "WHEEL").write_text(re.sub(r"(?m)^(Tag: .*-)linux_x86_64$", rf"\1{tag}", (info / "WHEEL").read_text()))
        (info / "licenses").mkdir(exist_ok=True)
        for package in packages:
            (info / "licenses" / package).write_bytes(Path("/usr/share/doc", package, "copyright").read_bytes())
        result = folder / wheel.name.replace("linux_x86_64", tag)
        write(tree, result)
    return result


if __name__ == "__main__":
    if len(sys.argv) < 3:
        raise SystemExit(__doc__)
    print(repair(Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3:]))
