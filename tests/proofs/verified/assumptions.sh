#!/bin/sh
# assumptions.sh FILE: what Coq printed of the assumptions of both theorems names the axioms of its reals, and no others.
set -e
found=$(sed -n 's/^\([A-Za-z][A-Za-z_.0-9]*\)\( :.*\)\{0,1\}$/\1/p' "$1" | sort | uniq -c | sed 's/^ *//')
expected='2 ClassicalDedekindReals.sig_forall_dec
2 FunctionalExtensionality.functional_extensionality_dep'
headings=$(grep -c '^Axioms:$' "$1")
if [ "$found" != "$expected" ] || [ "$headings" != 2 ]; then
  echo "the theorems rest on other assumptions than the axioms of the reals:"
  cat "$1"
  exit 1
fi
