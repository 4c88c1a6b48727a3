#!/bin/sh
# contact_alike.sh PROGRAM TESTS SOURCES: the verified checker judges each contact certificate that these tests judge,
# forgeries and mutants among them, as slipproof-check-contact does, or calls it not covered. A verdict that was changed on
# the way is noticed.
set -e
program=$1
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
mkfifo "$folder/pipe"
SLIPPROOF_CHECK_RECORD=$folder/pipe "$2" --source-file="$3" >"$folder/tests.txt" 2>&1 &
tests=$!
"$program" --compare "$folder/pipe" >"$folder/found.txt" || {
  head -c 20000 "$folder/found.txt"
  exit 1
}
wait $tests || {
  tail -50 "$folder/tests.txt"
  exit 1
}
tail -1 "$folder/found.txt"

certificate='slipproof-contact 1 dimension 1 free 0 contacts 1 mu 0 matrix 1 0 0 1 constant 1 no-answer unique dominant 1 end'
printf 'rejected %d\n%s' ${#certificate} "$certificate" >"$folder/wrong"
! "$program" --compare "$folder/wrong" >"$folder/found.txt"
grep -q '^s DIFFERENT 1 texts, 1 accepted, 0 not covered, 1 judged differently$' "$folder/found.txt"
