#!/bin/sh
# build.sh FOLDER: lets Coq check the proofs, writes what they rest on to FOLDER/assumptions.txt, and makes
# FOLDER/slipproof-check-verified of the extracted checker. Needs Coq 8.16, OCaml, findlib and zarith.
set -e
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1"
cd "$1"
cp "$here"/*.v "$here/main.ml" .
for part in Text Syntax Meaning Print Parse Poly Normal Checker NormalSound Sound Lossless Literal Extract; do
  coqc -q -Q . Slipproof $part.v
done
coqc -q -Q . Slipproof Assumptions.v >assumptions.txt
ocamlfind ocamlopt -O3 -w -a -package unix,zarith -linkpkg checker.mli checker.ml main.ml -o slipproof-check-verified
