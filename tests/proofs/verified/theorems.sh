#!/bin/sh
# theorems.sh PROOFS COMPILED FOLDER EVERY: every so manieth certificate becomes a theorem that Coq's kernel checks, 50 in
# a file; one for a statement that is false does not, though nothing but a strict term is missing.
proofs=$1 compiled=$2 folder=$3 every=$4
script=$proofs/coq/theorems.sh
set -e
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
ulimit -s unlimited
for file in $(find "$proofs" -name '*.theorems' | sort); do
  awk -v file="$file" '
    $0 == "slipproof-statement 1" { getline; name = substr($0, 9) }
    $0 == "slipproof-certificate 1" { print file "/" name ".cert" }' "$file"
done | awk "NR % $every == 0" | split -l 50 - list.
cat list.* | wc -l
for list in list.*; do
  xargs sh "$script" <"$list" >"T_${list#list.}.v"
  coqc -q -Q "$compiled" Slipproof "T_${list#list.}.v"
done

cat >forged.statement <<'END'
slipproof-statement 1
theorem false
real x
assume a: x >= 0
show x > 0
END
cat >forged.cert <<'END'
slipproof-certificate 1
theorem false 1478c041452c8926
contradiction
term 1 a
term 1 goal
qed
END
sh "$script" forged.cert >Forged.v
if coqc -q -Q "$compiled" Slipproof Forged.v 2>refusal.txt; then
  echo 'Coq accepted a forged certificate'
  exit 1
fi
grep -q 'accepts' refusal.txt || { cat refusal.txt; exit 1; }
