#!/bin/sh
# house.sh PROJECT: at most nine wings; layers.txt says what each room holds; in src and in tests no folder with more than
# 20 source files, no source file above 350 lines; and the drawing in CONTRIBUTING.md is that of drawing.sh.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
cd "$1"
status=0
wrong() {
  printf '%s\n' "$1"
  status=1
}

wings=$(find src -mindepth 1 -maxdepth 1 -type d | wc -l)
[ "$wings" -le 9 ] || wrong "src has $wings wings, at most 9 are told apart at a glance"
awk '/^[a-z_]+\// { if (room != "") print room; room = $1; next } /^#   / { room = "" } END { if (room != "") print room }' \
  src/layers.txt | while read -r room; do echo "src/layers.txt does not say what $room holds: a line \"#   ...\" below it"; done |
  grep . && status=1

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
find src tests -name '*.hpp' -o -name '*.cpp' -o -name '*.h' -o -name '*.c' -o -name '*.inc' -o -name '*.py' | sort >"$scratch/sources"
sed 's#/[^/]*$##' "$scratch/sources" | uniq -c |
  awk '$1 > 20 { print $2 " has " $1 " source files, at most 20 are one idea" }' >"$scratch/wrong"
# slipproof_record.h is copied into engines, so it is one file. A test whose table is one idea may be named here, too.
grep -v '/slipproof_record\.h$' "$scratch/sources" | xargs wc -l |
  awk '$1 > 350 && $2 != "total" { print $2 " has " $1 " lines, at most 350 are read as one" }' >>"$scratch/wrong"
[ ! -s "$scratch/wrong" ] || wrong "$(cat "$scratch/wrong")"

sed -n '/^<!-- the house -->$/,/^<!-- end -->$/p' CONTRIBUTING.md | sed '1d;$d' | sed '/^```/d' >"$scratch/drawing"
sh "$here/drawing.sh" src | diff "$scratch/drawing" - ||
  wrong "the drawing in CONTRIBUTING.md is another one: sh tests/repository/house/drawing.sh src prints it"
exit "$status"
