#!/bin/sh
# assumptions.sh FILE AXIOM...: what Coq printed of the assumptions of both theorems names these axioms, of its reals, and
# no others.
set -e
file=$1
shift
found=$(sed -n 's/^\([A-Za-z][A-Za-z_.0-9]*\)\( :.*\)\{0,1\}$/\1/p' "$file" | sort | uniq -c | sed 's/^ *//')
expected=$(printf '2 %s\n' "$@")
headings=$(grep -c '^Axioms:$' "$file")
if [ "$found" != "$expected" ] || [ "$headings" != 2 ]; then
  echo "the theorems rest on other assumptions than the axioms of the reals:"
  cat "$file"
  exit 1
fi
