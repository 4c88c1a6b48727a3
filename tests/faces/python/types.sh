#!/bin/sh
# types.sh FOLDER: mypy accepts the package's types, where it is installed.
set -eu
/usr/bin/env mypy --version >/dev/null 2>&1 || exit 77
exec mypy --strict --cache-dir=/dev/null "$1/slipproof"
