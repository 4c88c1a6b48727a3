#!/bin/sh
# theorems.sh CERT...: a file of Coq with a theorem for each certificate, that its statement is true, which Coq's kernel
# checks by computing. Then, beside what build.sh made: ulimit -s unlimited; coqc -Q FOLDER Slipproof FILE.v
# Exit code 3 where a file is no regular one.
set -eu
export LC_ALL=C
echo 'From Slipproof Require Import Print Meaning Checker Sound Literal.'
number=0
for certificate; do
  number=$((number + 1))
  # Nothing of a name may end the comment.
  echo "(* $(printf %s "${certificate##*/}" | tr -c 'A-Za-z0-9_.-' '?') *)"
  for part in statement cert; do
    file=${certificate%.cert}.$part
    [ -f "$file" ] || { echo "theorems.sh: theorem $number: its .$part is not a regular file" >&2; exit 3; }
    printf 'Definition %s%s := text "' $part $number
    sed 's/"/""/g' <"$file"
    echo '"%literal.'
  done
  echo "Theorem holds$number : exists s, states statement$number s /\\ meaning s."
  echo "Proof. apply (accepts_sound statement$number cert$number). vm_cast_no_check (@eq_refl bool true). Qed."
done
