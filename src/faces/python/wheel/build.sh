#!/usr/bin/env bash
# build.sh FOLDER: builds the wheel of the Python package in FOLDER, with a manylinux tag, and prints its name and size.
# GMP, MPFR, and of FLINT the folders that are needed, are compiled from Debian's sources as archives for a module. What is there
# is kept: after a change only what depends on it is compiled again.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
src=$(cd "$here/../../.." && pwd)
mkdir -p "$1"
folder=$(cd "$1" && pwd)
jobs=${JOBS:-$(nproc)}
python=/usr/bin/python3
source "$src/faces/package/debian_sources.sh"

sources() { fetch gmp mpfr4 flint; }

# Debian's archives of GMP and MPFR are compiled for programs; a module needs others. The code is for any x86-64, as Debian's.
archive_flags=(--disable-shared --with-pic CFLAGS="-O2 -fPIC -ffunction-sections -fdata-sections" "--prefix=$folder/installed")
gmp() {
  unpack gmp gmp
  cd "$folder/sources/gmp"
  mkdir -p doc  # Debian leaves the manual out
  printf 'all install:\n' >doc/Makefile.in
  ./configure -q --build=x86_64-linux-gnu --host=x86_64-linux-gnu --disable-cxx "${archive_flags[@]}"
  make -s -j "$jobs" install
}
mpfr() {
  unpack mpfr4 mpfr
  cd "$folder/sources/mpfr"
  ./configure -q "--with-gmp=$folder/installed" "${archive_flags[@]}"
  make -s -j "$jobs" -C src install
}

flint_config() { cat /usr/include/flint/flint-config.h; }  # of libflint-dev, whose headers the library is compiled with
compile() {  # FILE...
  printf '%s\0' "$@" | xargs -0 -n 20 -P "$jobs" gcc -O2 -w -fPIC -fvisibility=hidden -ffunction-sections -fdata-sections \
    "-ffile-prefix-map=$folder/sources/=" "-I$folder/sources/flint" -c
}
archive() {  # NAME FILE...; names of members may be alike
  rm -f "$folder/installed/lib/lib$1.a"
  ar qcs "$folder/installed/lib/lib$1.a" "${@:2}"
}
flint() { flint_of_debian 64; }

configure() {
  local part off=()
  for part in TESTS BENCHMARKS INSTALL IMPORT VERIFIED; do off+=("-DSLIPPROOF_$part=OFF"); done
  cmake -S "$src/.." -B "$folder/cmake" -G Ninja -DCMAKE_BUILD_TYPE=Release -DSLIPPROOF_WHEEL=ON -DSLIPPROOF_READ_HEADERS_ONCE=ON \
    "-DPython_EXECUTABLE=$python" "-DFLINT_LIBRARY=$folder/installed/lib/libflint.a" -DFLINT_INCLUDE_DIR=/usr/include \
    "-DSLIPPROOF_ARCHIVES=$folder/installed/lib" "${off[@]}"
}

# In an environment of its own, which has pip, setuptools and wheel from Debian's packages and nothing from a network.
wheel() {
  rm -rf "$folder/package" "$folder/built"
  env PIP_NO_INDEX=1 PIP_FIND_LINKS=/usr/share/python-wheels "SLIPPROOF_BUILD=$folder/cmake" "SLIPPROOF_PACKAGE_BUILD=$folder/package" \
    "CMAKE_BUILD_PARALLEL_LEVEL=$jobs" "$python" -m build --wheel --outdir "$folder/built" "$here/.."
}

# What becomes part of the module, or stands beside it.
parts=(libflint-dev libgmp-dev libmpfr-dev libtbb12 libmd-dev libpugixml-dev libfmt-dev libeigen3-dev libboost-dev
  nlohmann-json3-dev libtomlplusplus-dev libfast-float-dev pybind11-dev)
repair() {
  rm -f "$folder"/slipproof-*.whl
  "$python" "$here/repair.py" "$folder"/built/slipproof-*.whl "$folder" "${parts[@]}"
}

mkdir -p "$folder/done" "$folder/installed/lib"
for step in sources gmp mpfr flint; do once "$step"; done
rm -f "$folder"/done/{configure,wheel,repair}
for step in configure wheel repair; do once "$step"; done
for built in "$folder"/slipproof-*.whl; do echo "$built, $(stat -c %s "$built") bytes"; done
