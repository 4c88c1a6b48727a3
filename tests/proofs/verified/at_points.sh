#!/bin/sh
# at_points.sh DRIVER JUDGE PROOFS SCRATCH SAMPLES ROUNDS: the semantics that run in Coq and the judge of the library say
# the same of each claim at each point, of mutants, too, but where one of them does not know.
set -eu
driver=$1 judge=$2 proofs=$3 scratch=$4 samples=$5 rounds=$6
rm -rf "$scratch"
mkdir -p "$scratch"
"$driver" "$scratch" 1 "$samples" "$rounds" "$proofs"/*/claims.toml
for points in "$scratch"/*.points; do
  name=${points%.points}
  [ -s "$points" ] || continue
  "$judge" --at "$points" "$name.canonical" >"$name.found"
  paste -d ' ' "$name.expected" "$name.found" "$points" | sed "s|^|$(basename "$name") |"
done >"$scratch/all"
awk '{
  ++pairs
  if ($3 == "unsure" || $4 == "unknown") ++unknown
  else if ($3 == $4) ++alike
  else { print "judged differently: " $0; ++different }
}
END {
  print pairs " pairs, " alike " judged alike, " unknown " not known to one of the two"
  if (different > 0 || alike < 10000 || 20 * unknown > pairs) exit 1
}' "$scratch/all"
