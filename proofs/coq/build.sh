#!/bin/sh
# build.sh FOLDER: lets Coq check the proofs, writes what they rest on to FOLDER/assumptions.txt, and makes
# FOLDER/slipproof-check-verified of the extracted checker; then the same of claim/, with slipproof-judge-verified, and of
# contact/, with slipproof-check-contact-verified. Needs Coq 8.16, OCaml, findlib and zarith.
set -e
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1/claim" "$1/contact"
cd "$1"
cp "$here"/*.v "$here"/*.ml .
cp "$here"/claim/*.v "$here"/claim/*.ml claim
cp "$here"/contact/*.v "$here/contact/main.ml" contact
for part in Text Syntax Meaning Print Parse Poly Normal Checker NormalSound Sound Lossless Literal Extract; do
  coqc -q -Q . Slipproof $part.v
done
coqc -q -Q . Slipproof Assumptions.v >assumptions.txt
ocamlfind ocamlopt -O3 -w -a -package unix,zarith -linkpkg checker.mli checker.ml support.ml main.ml -o slipproof-check-verified

for part in Expression Mechanism Claim Forms FormsSound Entails Covers Scopes Inline Points Rising Obligations MotionForms Here ProvedEquations ProvedLimits \
  ProvedUnique Proved Refuted Canonical Linear RunValues RunConditions RunPoint RunModes RunMotion \
  RunKinds RunUnique Run Judge Extract; do
  coqc -q -Q . Slipproof claim/$part.v
done
coqc -q -Q . Slipproof claim/Assumptions.v >claim/assumptions.txt
mv judge.ml judge.mli claim
ocamlfind ocamlopt -O3 -w -a -I claim -package unix,zarith -linkpkg claim/judge.mli claim/judge.ml support.ml claim/canonical.ml \
  claim/main.ml -o slipproof-judge-verified

for part in Coulomb Number Certificate Fixed Linear Zero Checker Motions Read Parse Rows Law Enclose Refute Rest Unique Definite Ball Arcs States Multipliers Eliminate Alone Known KnownAlone Frictionless AllMotions Different Sound Extract; do
  coqc -q -Q . Slipproof contact/$part.v
done
coqc -q -Q . Slipproof contact/Assumptions.v >contact/assumptions.txt
mv contact_checker.ml contact_checker.mli contact
cd contact
cp ../support.ml .
ocamlfind ocamlopt -O3 -w -a -package unix,zarith -linkpkg contact_checker.mli contact_checker.ml support.ml main.ml \
  -o ../slipproof-check-contact-verified
