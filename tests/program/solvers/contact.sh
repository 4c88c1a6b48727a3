#!/bin/sh
# contact.sh RECORDER SLIPPROOF DATA OUT: every solver of RECORDER (record_contact) on every file of DATA, at three
# tolerances, judged by `slipproof certify`. Writes OUT/verdicts.csv, and OUT/tables.txt. Needs jq.
set -eu
recorder=$1 slipproof=$2 data=$3 out=$4
none=,,,,,,
. "$(dirname "$0")/contact_runs.sh"

# Solvers measure their errors in ways of their own, and some errors of theirs are 100 times smaller than ours.
allowed() {
  case $setting in 1e-4) echo 1e-2 ;; *) echo 1e-6 ;; esac
}

now() { date +%s.%N; }

columns() {
  if [ "${sized:-}" != "$file" ]; then
    "$slipproof" certify "$data/$file" --json --quiet >"$work/size" || true
    sized=$file
  fi
  echo "$file,$(head -n 1 "$work/size" | jq -r '"\(.contacts),\(.dimension)"'),$solver,$setting"
}

verdicts() {
  start=$(now)
  certify >"$work/line"
  seconds=$(echo "$start $(now)" | awk '{printf "%.2f", $2 - $1}')
  [ -s "$work/line" ] || return 1
  jq -r --arg seconds "$seconds" \
    '[.verdict, .unique, .rho, .backward_error, .velocity_error, $seconds, .reason // ""] | @csv' "$work/line" |
    sed 's/"\([^",]*\)"/\1/g'
}

mkdir -p "$out"
{
  printf %s 'file,contacts,dimension,solver,tolerance,code,error,seconds,'
  echo 'verdict,unique,rho,backward_error,velocity_error,certify_seconds,reason'
  every_run "$recorder"
} >"$out/verdicts.csv"
write_tables "$out"
