#!/bin/sh
# layers.sh SRC: every include in SRC keeps to the order of rooms in SRC/layers.txt.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
cd "$1"
find . -mindepth 1 \( -name '*.hpp' -o -name '*.cpp' -o -name '*.h' -o -name '*.c' -o -name '*.inc' -o -name '*.ipp' \) \
  -exec awk -f "$here/layers.awk" layers.txt {} + || {
  echo "Includes go one way, from the later rooms of src/layers.txt to the earlier ones: move the code, or the room's line."
  exit 1
}
