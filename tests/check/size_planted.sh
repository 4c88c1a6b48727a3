#!/bin/sh
# size.sh accepts a good checker, and refuses one that is too long or includes what it must not.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT

plant() {  # LINE TIMES: a good checker with this line as often
  rm -f "$tree"/*
  printf '#include <vector>\n#include <gmpxx.h>\n#include "check/b.hpp"\n// #include <boost/a.hpp>\n' >"$tree/a.cpp"
  yes "$1" | head -n "$2" >"$tree/b.hpp"
}
refused() {
  plant "$@"
  if sh "$here/size.sh" "$tree" >/dev/null; then
    echo "not noticed: $1, $2 times"
    exit 1
  fi
}

plant '// a line' 796
sh "$here/size.sh" "$tree"
refused '// a line' 797
for include in '"prove/statement.hpp"' '<boost/rational.hpp>' '<flint.h>' '<prove/statement.hpp>' '"b.hpp"' '"../a.hpp"'; do
  refused "#include $include" 1
done
refused '  #  include <fmt/core.h>' 1
