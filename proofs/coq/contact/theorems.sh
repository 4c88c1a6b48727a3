#!/bin/sh
# theorems.sh CERT...: a file of Coq with a theorem for each contact certificate, that what it claims is true, which Coq's
# kernel checks by computing. Then, beside what ../build.sh made: ulimit -s unlimited; coqc -Q FOLDER Slipproof FILE.v
# Exit code 3 where a file is no regular one.
set -eu
export LC_ALL=C
echo 'From Coq Require Import List.'
echo 'From Slipproof Require Import Literal.'
echo 'From Slipproof.contact Require Import Coulomb Certificate Parse Sound.'
number=0
for certificate; do
  number=$((number + 1))
  # Nothing of a name may end the comment.
  echo "(* $(printf %s "${certificate##*/}" | tr -c 'A-Za-z0-9_.-' '?') *)"
  [ -f "$certificate" ] || { echo "theorems.sh: theorem $number: its certificate is not a regular file" >&2; exit 3; }
  printf 'Definition certificate%s := text "' $number
  sed 's/"/""/g' <"$certificate"
  echo '"%literal.'
  echo "Theorem holds$number : exists c, states certificate$number c /\\ complete (about c) /\\ proper (problem_of (about c)) /\\"
  echo "  claims c <> nil /\\ Forall (meaning (about c)) (claims c)."
  echo "Proof. apply (accepts_sound certificate$number). vm_cast_no_check (@eq_refl bool true). Qed."
done
