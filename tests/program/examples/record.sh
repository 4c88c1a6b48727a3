#!/bin/sh
# record.sh SLIPPROOF EXPECTED PROGRAM: runs PROGRAM FILE ARGUMENTS for each line `$ ARGUMENTS` of EXPECTED. Below it stands how
# many of the steps have which verdict by their own law, and by Coulomb's.
set -eu
slipproof=$1 expected=$2 program=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

grep '^\$' "$expected" | while read -r _ arguments; do
  echo "\$ $arguments" | sed 's/ $//'
  # shellcheck disable=SC2086  # several
  "$program" "$work/steps.jsonl" $arguments
  "$slipproof" certify "$work/steps.jsonl" --json >"$work/lines" 2>/dev/null || [ $? = 1 ]
  sed -n 's/.*"dimension":3,"verdict":"\([^"]*\)".*"coulomb":{"verdict":"\([^"]*\)".*/\1; by Coulomb: \2/p' "$work/lines" |
    sort | uniq -c | sed 's/^ *//'
done >"$work/found"
diff "$expected" "$work/found"
