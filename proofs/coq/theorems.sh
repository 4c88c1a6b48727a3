#!/bin/sh
# theorems.sh CERT...: a file of Coq with a theorem for each certificate, that its statement is true, which Coq's kernel
# checks by computing. Then, beside what build.sh made: ulimit -s unlimited; coqc -Q FOLDER Slipproof FILE.v
echo 'From Slipproof Require Import Print Meaning Checker Sound Literal.'
number=0
for certificate; do
  number=$((number + 1))
  echo "(* $(basename "$certificate") *)"
  for part in statement cert; do
    printf 'Definition %s%s := text "' $part $number
    sed 's/"/""/g' "${certificate%.cert}.$part"
    echo '"%literal.'
  done
  echo "Theorem holds$number : exists s, states statement$number s /\\ meaning s."
  echo "Proof. apply (accepts_sound statement$number cert$number). vm_cast_no_check (@eq_refl bool true). Qed."
done
