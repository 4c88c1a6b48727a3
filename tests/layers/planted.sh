#!/bin/sh
# The lint must accept a good tree and must report each include planted here, with its place.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT

plant() {  # FILE INCLUDE: a good tree with this one line more
  rm -rf "$tree/src"
  mkdir -p "$tree/src/low" "$tree/src/mid" "$tree/src/left" "$tree/src/right" "$tree/src/apart" "$tree/src/top"
  printf '# a comment: top low\nlow\nmid\nleft right apart*\ntop\n' >"$tree/src/layers.txt"
  printf '#include <vector>\n#include "low/b.hpp"\n#include <boost/low/top.hpp>\n' >"$tree/src/low/a.hpp"
  printf '#include "low/a.hpp"\n// #include "top/a.hpp"\n' >"$tree/src/mid/a.hpp"
  printf '#include "mid/a.hpp"\n#include "low/a.hpp"\n' >"$tree/src/left/a.cpp"
  printf '#include "low/a.hpp"\n' >"$tree/src/right/a.cpp"
  printf '#include "apart/b.hpp"\n#include <gmp.h>\n' >"$tree/src/apart/a.cpp"
  printf '#include "apart/a.hpp"\n#include "left/a.hpp"\n#include "right/a.hpp"\n' >"$tree/src/top/a.cpp"
  printf '#include "left/a.hpp"\n#include "right/a.hpp"\n' >"$tree/src/all.hpp"
  if [ $# -gt 0 ]; then
    mkdir -p "$(dirname "$tree/src/$1")"
    printf '%s\n' "$2" >>"$tree/src/$1"
  fi
}

plant
sh "$here/layers.sh" "$tree/src" || { echo "the good tree was refused"; exit 1; }

count=0
refused() {  # FILE INCLUDE MESSAGE
  plant "$1" "$2"
  if output=$(sh "$here/layers.sh" "$tree/src"); then
    echo "not noticed: $2 in $1"
    exit 1
  fi
  case $output in
    "src/$1:"*"$3"*) count=$((count + 1)) ;;
    *) echo "$2 in $1: expected \"$3\", got:"; echo "$output"; exit 1 ;;
  esac
}
refused low/a.hpp '#include "mid/a.hpp"' 'low must not include mid/a.hpp: mid comes later'
refused low/a.hpp '#include <mid/a.hpp>' 'low must not include mid/a.hpp: mid comes later'
refused low/deeper/c.cpp '  #  include "top/a.hpp"  // why' 'low must not include top/a.hpp: top comes later'
refused left/a.cpp '#include "right/a.hpp"' 'left must not include right/a.hpp: they are siblings'
refused left/a.cpp '#include "apart/a.hpp"' 'they are siblings'
refused apart/a.cpp '#include "low/a.hpp"' 'apart stands alone and must not include low/a.hpp'
refused mid/a.hpp '#include "a.hpp"' 'does not name a folder'
refused mid/a.hpp '#include "../top/a.hpp"' 'does not name a folder'
refused mid/a.hpp '#include "low/../top/a.hpp"' 'must not step between folders'
refused mid/a.hpp '#include "other/a.hpp"' 'does not name a folder'
refused all.hpp '#include "other/a.hpp"' 'does not name a folder'
refused new/a.hpp '#include <vector>' 'the folder new has no line'
echo "$count planted includes refused"
