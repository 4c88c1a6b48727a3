#!/bin/sh
# size.sh CHECKER LINES: what decides on a certificate is all of CHECKER but files.* and theorem_file.*, which find, load
# and part the texts, and main.cpp. It has at most LINES lines, empty ones and comments aside, and opens no files; and all of CHECKER includes only
# itself, the standard library and GMP.
set -eu
cd "$1"
name=proofs/$(basename "$PWD")
deciding=$(ls ./*.cpp ./*.hpp | grep -vE '^\./((theorem_)?files?\.[ch]pp|main\.cpp)$')
# shellcheck disable=SC2086
lines=$(cat $deciding | grep -cvE '^[[:space:]]*(//.*)?$')
[ "$lines" -le "$2" ] || {
  echo "$lines lines of code decide in the checker; at most $2, so that a person reads them over a coffee"
  exit 1
}
# shellcheck disable=SC2086
if grep -nE '^[[:space:]]*#[[:space:]]*include.*(files|filesystem|fstream|iostream|cstdio|unistd)' $deciding; then
  echo "what decides opens no files"
  exit 1
fi
# Headers of the standard library have neither an extension nor a folder.
foreign=$(grep -nE '^[[:space:]]*#[[:space:]]*include' ./*.cpp ./*.hpp |
  grep -vE "include (\"$name/[a-z_]+\.hpp\"|<[a-z_]+>|<gmp\.h>|<gmpxx\.h>)\$") || exit 0
echo "the checker includes what is neither its own, nor of the standard library, nor GMP:"
echo "$foreign"
exit 1
