#!/bin/sh
# layers.sh SRC [SOLVERS]: every include in SRC keeps to the order of rooms in SRC/layers.txt, and none in SRC/report solves.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
solvers=${2:-$here/solvers.txt}
cd "$1"
find . -mindepth 1 \( -name '*.hpp' -o -name '*.cpp' -o -name '*.h' -o -name '*.c' -o -name '*.inc' -o -name '*.ipp' \) \
  -exec awk -f "$here/layers.awk" layers.txt "$solvers" {} + || {
  echo "Includes go one way, from the later rooms of src/layers.txt to the earlier ones: move the code, or the room's line."
  exit 1
}
