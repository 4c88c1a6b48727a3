#!/bin/sh
# size.sh accepts a good checker, and refuses one that is too long or includes what it must not. What finds the files may
# be long.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
tree=$folder/check
mkdir "$tree"

plant() {  # LINE TIMES: a good checker of three lines, with this line as often
  rm -f "$tree"/*
  yes 'int a_line;' | head -n 900 | tee "$tree/files.cpp" "$tree/files.hpp" >"$tree/main.cpp"
  printf '#include <vector>\n#include <gmpxx.h>\n#include "proofs/check/b.hpp"\n// #include <boost/a.hpp>\n\n' >"$tree/a.cpp"
  yes "$1" | head -n "$2" >"$tree/b.hpp"
}
refused() {
  plant "$@"
  if sh "$here/size.sh" "$tree" 800 >/dev/null; then
    echo "not noticed: $1, $2 times"
    exit 1
  fi
}

plant 'int a_line;  // of code' 797
sh "$here/size.sh" "$tree" 800
plant '  // a comment' 900
sh "$here/size.sh" "$tree" 800
refused 'int a_line;  // of code' 798
for include in '"proofs/search/prove.hpp"' '<boost/rational.hpp>' '<flint.h>' '<proofs/search/prove.hpp>' '"b.hpp"' '"../a.hpp"' \
  '"proofs/check/files.hpp"' '<filesystem>' '<fstream>'; do
  refused "#include $include" 1
done
refused '  #  include <fmt/core.h>' 1

plant 'int a_line;' 790
yes 'int another;' | head -n 20 >"$tree/more_files.cpp"
if sh "$here/size.sh" "$tree" 800 >/dev/null; then
  echo "not noticed: more_files.cpp counts"
  exit 1
fi
