#!/bin/sh
# size.sh CHECKER: the checker has at most 800 lines, and includes only itself, the standard library and GMP.
set -eu
cd "$1"
lines=$(cat ./*.cpp ./*.hpp | wc -l)
[ "$lines" -le 800 ] || {
  echo "$lines lines in the checker; at most 800, so that a person reads it over a coffee"
  exit 1
}
# Headers of the standard library have neither an extension nor a folder.
foreign=$(grep -nE '^[[:space:]]*#[[:space:]]*include' ./*.cpp ./*.hpp |
  grep -vE 'include ("check/[a-z]+\.hpp"|<[a-z_]+>|<gmp\.h>|<gmpxx\.h>)$') || exit 0
echo "the checker includes what is neither its own, nor of the standard library, nor GMP:"
echo "$foreign"
exit 1
