#!/bin/sh
# The lints of pages and of paths in comments must accept a good tree and must report each mistake planted here.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT

plant() {  # [FILE LINE]: a good tree, with this line more
  rm -rf "$tree/src" "$tree/tests" "$tree/proofs" "$tree"/*.md
  mkdir -p "$tree/src/base/one" "$tree/tests/base" "$tree/proofs/paper"
  printf '[house](src/base/HOUSE.md#the-house-of-a) [papers](proofs/README.md) [web](https://example.org/none.md)\n' >"$tree/README.md"
  printf '# House\n\n## The `house` of (a)\n[back](../../README.md)\n' >"$tree/src/base/HOUSE.md"
  printf '[paper](paper/README.md)\n' >"$tree/proofs/README.md"
  printf '# Paper\n```\n[no link](nowhere)\n```\n[itself](#paper)\n' >"$tree/proofs/paper/README.md"
  printf '// See one/b.hpp, base/one/b.hpp, proofs/paper and FOLDER/no.csv.\nint a;  // src/base/one\n' >"$tree/src/base/a.hpp"
  printf '#include "base/none.hpp"\n' >"$tree/src/base/one/b.hpp"
  printf '# of base/one\n' >"$tree/tests/base/run.sh"
  if [ $# -gt 0 ]; then printf '%s\n' "$2" >>"$tree/$1"; fi
}

plant
for lint in pages paths; do sh "$here/$lint.sh" "$tree" || { echo "$lint.sh refused the good tree"; exit 1; }; done

count=0
refused() {  # LINT FILE LINE MESSAGE
  plant "$2" "$3"
  if output=$(sh "$here/$1.sh" "$tree"); then
    echo "not noticed: $3 in $2"
    exit 1
  fi
  case $output in
    *"$4"*) count=$((count + 1)) ;;
    *) echo "$3 in $2: expected \"$4\", got:"; echo "$output"; exit 1 ;;
  esac
}
refused pages proofs/README.md '[a](none.md)' 'proofs/README.md:2: there is no proofs/none.md'
refused pages README.md '[a](proofs/paper/README.md#none)' 'README.md:2: proofs/paper/README.md has no heading #none'
refused pages README.md '[a](#none)' 'README.md has no heading #none'
refused pages proofs/paper/MORE.md '# Lost' 'proofs/paper/MORE.md is not reached'
refused paths src/base/a.hpp '// see base/two/b.hpp' 'src/base/a.hpp:3: there is no base/two/b.hpp'
refused paths src/base/a.hpp 'int b;  // PAGE.md: one/c.hpp.' 'there is no one/c.hpp'
refused paths tests/base/run.sh '# proofs/none has it' 'tests/base/run.sh:2: there is no proofs/none'
echo "$count planted mistakes reported"
