#!/bin/sh
# assumptions.sh FILE THEOREMS AXIOM...: what Coq printed of the assumptions of so many theorems names these axioms, of its
# reals, for each of them, and no others.
set -e
file=$1 theorems=$2
shift 2
found=$(sed -n 's/^\([A-Za-z][A-Za-z_.0-9]*\)\( :.*\)\{0,1\}$/\1/p' "$file" | sort | uniq -c | sed 's/^ *//')
expected=$(printf "$theorems %s\n" "$@")
headings=$(grep -c '^Axioms:$' "$file")
if [ "$found" != "$expected" ] || [ "$headings" != "$theorems" ]; then
  echo "the theorems rest on other assumptions than the axioms of the reals:"
  cat "$file"
  exit 1
fi
