#!/bin/sh
# types.sh FOLDER USE: mypy accepts the package's types, and the types in a file that uses them, where it is installed.
set -eu
/usr/bin/env mypy --version >/dev/null 2>&1 || exit 77
mypy --strict --cache-dir=/dev/null "$1/slipproof"
MYPYPATH=$1 exec mypy --strict --cache-dir=/dev/null "$2"
