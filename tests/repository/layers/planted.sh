#!/bin/sh
# The lint must accept a good tree and must report each include planted here, with its place.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT

plant() {  # FILE INCLUDE: a good tree with this one line more
  rm -rf "$tree/src"
  mkdir -p "$tree/src/low/one" "$tree/src/low/two/deeper" "$tree/src/high/apart" "$tree/src/high/top"
  printf '# a comment: top low\nlow: what is low\nlow/one\nlow/two\nhigh: what is high\nhigh/apart*\nhigh/top\nreport: what is read\nreport/pages\n' >"$tree/src/layers.txt"
  printf '#include <vector>\n#include "low/one/b.hpp"\n#include <boost/low/top.hpp>\n' >"$tree/src/low/one/a.hpp"
  printf '#include "low/one/a.hpp"\n// #include "high/top/a.hpp"\n#include "low/two/deeper/a.hpp"\n' >"$tree/src/low/two/a.hpp"
  printf '#include "low/two/a.hpp"\n' >"$tree/src/low/two/deeper/a.hpp"
  printf '#include "high/apart/b.hpp"\n#include <gmp.h>\n' >"$tree/src/high/apart/a.cpp"
  printf '#include "high/apart/a.hpp"\n#include "low/one/a.hpp"\n#include "low/two/deeper/a.hpp"\n' >"$tree/src/high/top/a.cpp"
  printf '#include "low/one/a.hpp"\n#include "high/top/a.hpp"\n' >"$tree/src/all.hpp"
  mkdir "$tree/src/report" "$tree/src/report/pages"
  printf '#include "high/top/result.hpp"\n#include "low/one/a.hpp"\n#include "low/two/a.hpp"\n' >"$tree/src/report/pages/a.cpp"
  printf '# a comment: low/one\nhigh\n!high/top/result.hpp\nlow/two/deeper\nlow/one/solve.hpp\n' >"$tree/solvers"
  if [ $# -gt 0 ]; then
    mkdir -p "$(dirname "$tree/src/$1")"
    printf '%s\n' "$2" >>"$tree/src/$1"
  fi
}

plant
sh "$here/layers.sh" "$tree/src" "$tree/solvers" || { echo "the good tree was refused"; exit 1; }

count=0
refused() {  # FILE INCLUDE MESSAGE
  plant "$1" "$2"
  if output=$(sh "$here/layers.sh" "$tree/src" "$tree/solvers"); then
    echo "not noticed: $2 in $1"
    exit 1
  fi
  case $output in
    "src/$1:"*"$3"*) count=$((count + 1)) ;;
    *) echo "$2 in $1: expected \"$3\", got:"; echo "$output"; exit 1 ;;
  esac
}
refused low/one/a.hpp '#include "low/two/a.hpp"' 'low/one must not include low/two/a.hpp: low/two comes later'
refused low/one/a.hpp '#include <low/two/a.hpp>' 'low/one must not include low/two/a.hpp: low/two comes later'
refused low/one/new/c.cpp '  #  include "high/top/a.hpp"  // why' 'low/one must not include high/top/a.hpp: high/top comes later'
refused low/two/deeper/a.hpp '#include "high/apart/a.hpp"' 'low/two must not include high/apart/a.hpp'
refused high/apart/a.cpp '#include "low/one/a.hpp"' 'high/apart stands alone and must not include low/one/a.hpp'
refused low/two/a.hpp '#include "a.hpp"' 'does not name a room'
refused low/two/a.hpp '#include "../top/a.hpp"' 'must not step between folders'
refused low/two/a.hpp '#include "low/one/../two/a.hpp"' 'must not step between folders'
refused low/two/a.hpp '#include "low/other/a.hpp"' 'does not name a room'
refused all.hpp '#include "low/other/a.hpp"' 'does not name a room'
refused low/new/a.hpp '#include <vector>' 'its folder is no room'
refused report/pages/a.cpp '#include "high/top/a.hpp"' 'report/pages must not include high/top/a.hpp, which solves'
refused report/pages/b.hpp '#include "low/one/solve.hpp"' 'must not include low/one/solve.hpp, which solves'
refused report/pages/b.hpp '#include <low/two/deeper/a.hpp>' 'must not include low/two/deeper/a.hpp, which solves'
echo "$count planted includes refused"
