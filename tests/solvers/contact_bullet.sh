#!/bin/sh
# contact_bullet.sh SINGLE DOUBLE SLIPPROOF DATA OUT: every solver of Bullet, in single and in double precision (the
# programs record_contact_bullet and record_contact_bullet64), on every file of DATA that it takes, judged by `slipproof
# certify` for the cone and for the pyramid. Writes OUT/bullet.csv, and OUT/README.md below "## Tables". A solver has ten
# seconds. Needs jq.
set -eu
single=$1 double=$2 slipproof=$3 data=$4 out=$5
here=$(dirname "$0")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

judge() {
  timeout 120 "$slipproof" certify "$data/$file" --answer "$work/answer.json" --tolerance $allowed --json --quiet "$@"
}

record() {
  rm -f "$work/answer.json"
  status=0
  solved=$(timeout -k 1 10 "$recorder" "$data/$file" "$solver" "$work/answer.json" 2>"$work/log") || status=$?
  case $status in
    0) ;;
    2) cat "$work/log" >&2 && exit 1 ;; # the recorder's own refusal
    124 | 137) solved=time\ limit,, ;;
    *) solved=crash,, ;;
  esac
  printf %s "$file,$precision,$solver,$allowed,$solved,"
  if [ $status -ne 0 ]; then
    echo ",,,,"
    return
  fi
  judge >"$work/cone" || status=$? # its exit code is the verdict
  judge --law box >"$work/box" || status=$?
  if [ -s "$work/cone" ] && [ -s "$work/box" ]; then
    jq -rs '. as [$cone, $box] | [$cone.verdict, $cone.backward_error, ($cone.right_for // "" | split(" ")[0]),
      $box.verdict, $box.backward_error] | @csv' "$work/cone" "$work/box" | tr -d '"'
  else
    echo "no verdict ($status),,,,"
  fi
}

mkdir -p "$out"
{
  echo 'file,precision,solver,tolerance,code,error,seconds,verdict,backward_error,right_for,box_verdict,box_backward_error'
  (cd "$data" && ls fclib/* siconos/* lcp/*) | while read -r file; do
    for precision in single double; do
      case $precision in
        single) recorder=$single allowed=1e-4 ;;
        double) recorder=$double allowed=1e-6 ;;
      esac
      "$recorder" "$data/$file" >"$work/solvers"
      while read -r solver; do record; done <"$work/solvers"
    done
  done
} >"$out/bullet.csv"
sh "$here/contact_tables.sh" "$out" >"$work/README.md"
cp "$work/README.md" "$out/README.md"
