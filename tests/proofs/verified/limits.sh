#!/bin/sh
# limits.sh SLIPPROOF JUDGE PAPER SCRATCH: the judge proves the limit that is true, and leaves the false one open, although
# each of its statements, as an earlier prover wrote them, is true and has a certificate that is accepted.
set -eu
slipproof=$1 judge=$2 paper=$3 scratch=$4
rm -rf "$scratch"
cp -r "$paper" "$scratch"
"$slipproof" prove --quiet "$scratch/claims.toml" || true
awk '$0 == "slipproof-statement 1" { first = $0; getline; its = /^theorem F1\./; $0 = first "\n" $0 } !its' \
  "$scratch/claims.theorems" >"$scratch/others"
mv "$scratch/others" "$scratch/claims.theorems"
for statement in "$scratch"/forgotten/*.statement; do
  "$slipproof" prove --again --quiet "$statement"
  cat "$statement" "${statement%.statement}.cert" >>"$scratch/claims.theorems"
done
rm -r "$scratch/forgotten"
"$judge" "$scratch" >"$scratch/verdicts" || true
cat "$scratch/verdicts"
for expected in 'accepted .*/F1.beyond.cert' 'accepted .*/F1.eventually.cert' 'accepted .*/F1.from.cert' 'open .*/F1' 'proved .*/E1'; do
  grep -q "^$expected\$" "$scratch/verdicts" || { echo "expected: $expected"; exit 1; }
done
