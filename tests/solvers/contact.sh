#!/bin/sh
# contact.sh RECORDER SLIPPROOF DATA OUT: every solver of RECORDER (record_contact) on every file of DATA, at three
# tolerances, judged by `slipproof certify`. Writes OUT/verdicts.csv, and OUT/README.md below "## Tables" from it. A
# solver has ten seconds. Needs jq.
set -eu
recorder=$1 slipproof=$2 data=$3 out=$4
here=$(dirname "$0")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

now() { date +%s.%N; }

# Solvers measure their errors in ways of their own, and some errors of theirs are 100 times smaller than ours.
judge() {
  case $tolerance in 1e-4) allowed=1e-2 ;; *) allowed=1e-6 ;; esac
  timeout 120 "$slipproof" certify "$data/$file" --answer "$work/answer.json" --tolerance $allowed --json --quiet
}

record() {
  rm -f "$work/answer.json"
  status=0
  solved=$(timeout -k 1 10 "$recorder" "$data/$file" "$solver" "$tolerance" "$work/answer.json" 2>"$work/log") ||
    status=$?
  case $status in
    0) ;;
    2) cat "$work/log" >&2 && exit 1 ;; # the recorder's own refusal
    124 | 137) solved=time\ limit,, ;;
    *) solved=crash,, ;;
  esac
  printf %s "$file,$size,$solver,$tolerance,$solved,"
  if [ $status -ne 0 ]; then
    echo ",,,,,,"
    return
  fi
  start=$(now)
  judge >"$work/line" || status=$? # its exit code is the verdict
  seconds=$(echo "$start $(now)" | awk '{printf "%.2f", $2 - $1}')
  if [ -s "$work/line" ]; then
    jq -r --arg seconds "$seconds" \
      '[.verdict, .unique, .rho, .backward_error, .velocity_error, $seconds, .reason // ""] | @csv' "$work/line" |
      sed 's/"\([^",]*\)"/\1/g'
  else
    echo "no verdict ($status),,,,,$seconds,"
  fi
}

mkdir -p "$out"
{
  printf %s 'file,contacts,dimension,solver,tolerance,code,error,seconds,'
  echo 'verdict,unique,rho,backward_error,velocity_error,certify_seconds,reason'
  (cd "$data" && ls fclib/* siconos/* lcp/*) | while read -r file; do
    "$recorder" "$data/$file" >"$work/solvers"
    "$slipproof" certify "$data/$file" --json --quiet >"$work/line" || true
    size=$(head -n 1 "$work/line" | jq -r '"\(.contacts),\(.dimension)"')
    while read -r solver; do
      for tolerance in 1e-4 1e-8 1e-14; do record; done
    done <"$work/solvers"
  done
} >"$out/verdicts.csv"
sh "$here/contact_tables.sh" "$out" >"$work/README.md"
cp "$work/README.md" "$out/README.md"
