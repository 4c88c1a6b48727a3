#!/bin/sh
# alike.sh PROGRAM TESTS: the verified checker judges each pair of statement and certificate that the tests of
# slipproof-check judge, forgeries and mutants among them, as they do. A verdict that was changed on the way is noticed.
set -e
program=$1
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
mkfifo "$folder/pipe"
SLIPPROOF_CHECK_RECORD=$folder/pipe "$2" --test-case-exclude='the second reading*' >"$folder/tests.txt" 2>&1 &
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

statement=$(printf 'slipproof-statement 1\ntheorem t\nshow false')
printf 'accepted %d 0\n%s' ${#statement} "$statement" >"$folder/wrong"
! "$program" --compare "$folder/wrong" >"$folder/found.txt"
grep -q '^s DIFFERENT 1 pairs, 0 accepted, 1 judged differently$' "$folder/found.txt"
