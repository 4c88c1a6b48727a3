#!/bin/sh
# random_at_points.sh DRIVER JUDGE SCRATCH SEED PAIRS: of random claims, the semantics that run in Coq and the second
# judge of tests/claims/meaning say the same at each point, but where the former do not know.
set -eu
driver=$1 judge=$2 scratch=$3 seed=$4 pairs=$5
rm -rf "$scratch"
mkdir -p "$scratch"
"$driver" "$scratch" "$seed" "$pairs"
for points in "$scratch"/*.points; do
  name=${points%.points}
  [ -s "$points" ] || continue
  "$judge" --at "$points" "$name.canonical" >"$name.found"
  paste -d ' ' "$name.expected" "$name.found" "$points" | sed "s|^|$(basename "$name") |"
done >"$scratch/all"
awk '{
  ++pairs
  ++kinds[$2 " " $3]
  if ($4 == "unknown") ++unknown
  else if ($3 == $4) ++alike
  else { print "judged differently: " $0; ++different }
}
END {
  for (kind in kinds) print kind ": " kinds[kind]
  print pairs " pairs, " alike " judged alike, " unknown " not known to Coq"
  if (different > 0 || 3 * alike < 2 * pairs) exit 1
}' "$scratch/all"
