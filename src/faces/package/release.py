"""release.py OUT: makes OUT/slipproof-VERSION-release.tar.gz of what stands in build, build-explorer and build-wheel.

In it: the site, the wheel, the Debian packages, the sources of the commit, BUILT_FROM.json, and the checksums of all files.
Times are those of the commit ($SOURCE_DATE_EPOCH), names are sorted, owners are 0: the same files give the same bytes.
"""
import gzip
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
BEGIN = """slipproof {version}: exact, provable answers about dry friction.

site/index.html   open it in a browser: the explorer, the papers that were judged, all pages. It needs no network
packages/         for Debian 12: apt-get install ./packages/slipproof_*.deb ./packages/libslipproof*.deb
wheel/            for Python {python} on Linux: pip install wheel/*.whl
source/           the sources: ./run help says what builds what
BUILT_FROM.json   the commit, the compilers, and the packages and sources of Debian that each part was built from
SHA256SUMS        sha256sum --check SHA256SUMS
"""


def output(*command):
    return subprocess.run([str(part) for part in command], check=True, cwd=ROOT, stdout=subprocess.PIPE, text=True).stdout.strip()


def sha256(path):
    with open(path, "rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def write_tar(path, folder, time):
    """A tar.gz of `folder` under its own name, which depends on names and bytes alone."""

    def plain(entry):
        entry.mtime, entry.uid, entry.gid, entry.uname, entry.gname = time, 0, 0, "", ""
        entry.mode = 0o755 if entry.isdir() or entry.mode & 0o100 else 0o644
        return entry

    part = path.with_suffix(".part")
    with open(part, "wb") as file, gzip.GzipFile("", "wb", 6, file, mtime=0) as packed, tarfile.open(fileobj=packed, mode="w") as archive:
        archive.add(folder, folder.name, filter=plain)  # sorts the entries of a folder
    part.replace(path)


def write_sources(path, name):
    command = ["git", "archive", "--format=tar", f"--prefix={name}/", "HEAD"]
    text = subprocess.run(command, check=True, cwd=ROOT, stdout=subprocess.PIPE).stdout
    path.write_bytes(gzip.compress(text, 6, mtime=0))


def installed(*lists):
    """The binary packages of Debian, each with its version, that ./run names in these lists and this machine has."""
    script = (ROOT / "run").read_text(encoding="utf-8")
    wanted = set()
    for name in lists:
        entries = re.search(rf"^{name}=\((.*?)\)$", script, re.DOTALL | re.MULTILINE)[1]
        wanted.update(word for line in entries.splitlines() for word in line.partition("#")[0].split())
    listed = output("dpkg-query", "--show", "--showformat", "${db:Status-Status} ${Package}=${Version}\n").splitlines()
    return sorted(line.split()[1] for line in listed if line.startswith("installed ") and line.split()[1].partition("=")[0] in wanted)


def debian_sources(folder):
    """The source packages that were compiled."""
    return [{"file": dsc.name, "sha256": sha256(dsc)} for dsc in sorted((ROOT / folder / "sources").glob("*.dsc"))]


def version_of(*command):
    return output(*command, "--version").splitlines()[0]


def built_from(release, version, commit):
    def part(files, **inputs):
        return {"files": sorted(str(file.relative_to(release)) for file in release.glob(files) if file.is_file()), **inputs}

    return {
        "schema": "slipproof/release/1",
        "version": version,
        "commit": commit,
        "time": int(os.environ["SOURCE_DATE_EPOCH"]),
        "folder": str(ROOT),
        "system": f"Debian {pathlib.Path('/etc/debian_version').read_text(encoding='utf-8').strip()} {output('dpkg', '--print-architecture')}",
        "parts": {
            "source": part("source/*"),
            "packages": part("packages/*", compilers=[version_of("g++"), version_of("cmake")],
                             packages=installed("packages", "test_packages")),
            "wheel": part("wheel/*", compilers=[version_of("g++"), version_of("gcc")], packages=installed("packages", "wheel_packages"),
                          debian_sources=debian_sources("build-wheel")),
            "site": part("site/*.html", compilers=[version_of("clang-14"), version_of("em++")],
                         packages=installed("explorer_packages", "site_packages"),
                         debian_sources=debian_sources("build-explorer")),
        },
    }


def main(out):
    os.environ.setdefault("SOURCE_DATE_EPOCH", output("git", "log", "-1", "--format=%ct"))
    time = int(os.environ["SOURCE_DATE_EPOCH"])
    commit = output("git", "rev-parse", "HEAD")
    changed = output("git", "status", "--porcelain")
    if changed:
        sys.exit(f"release.py: found files that are not those of the commit {commit[:12]}, expected none:\n{changed}")
    version = re.search(r"project\(slipproof VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
    wheels = sorted((ROOT / "build-wheel").glob("slipproof-*.whl"))
    if len(wheels) != 1:
        sys.exit(f"release.py: found {len(wheels)} wheels in {ROOT}/build-wheel, expected one: ./run wheel")

    name = f"slipproof-{version}"
    release = out / f"{name}-release"
    shutil.rmtree(release, ignore_errors=True)
    for folder in ("source", "wheel"):
        (release / folder).mkdir(parents=True)
    write_sources(release / "source" / f"{name}.tar.gz", name)
    shutil.copy(wheels[0], release / "wheel")
    shutil.copytree(ROOT / "build" / "site", release / "site")
    output("cpack", "--config", "build/CPackConfig.cmake", "-G", "DEB", "-B", release / "packages")
    shutil.rmtree(release / "packages" / "_CPack_Packages")

    python = re.search(r"-cp(\d)(\d+)-", wheels[0].name)
    (release / "READ_ME.txt").write_text(BEGIN.format(version=version, python=f"{python[1]}.{python[2]}"), encoding="utf-8")
    (release / "BUILT_FROM.json").write_text(json.dumps(built_from(release, version, commit), indent=1) + "\n", encoding="utf-8")
    files = sorted(str(file.relative_to(release)) for file in release.rglob("*") if file.is_file())
    (release / "SHA256SUMS").write_text("".join(f"{sha256(release / file)}  {file}\n" for file in files), encoding="utf-8")
    archive = out / f"{release.name}.tar.gz"
    write_tar(archive, release, time)
    print(f"{archive}, {archive.stat().st_size} bytes, sha256 {sha256(archive)}")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve())
