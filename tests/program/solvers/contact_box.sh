#!/bin/sh
# contact_box.sh NAME SLIPPROOF DATA OUT RECORDER...: every solver of a game engine, by its recorders
# (record_contact_bullet and record_contact_bullet64, or record_contact_dart), on every file of DATA that it takes, judged
# by `slipproof certify` for the cone and for the pyramid. Writes OUT/NAME.csv, and OUT/tables.txt. Needs
# jq.
set -eu
name=$1 slipproof=$2 data=$3 out=$4
shift 4
none=,,,,
. "$(dirname "$0")/contact_runs.sh"

allowed() {
  case $setting in single | 1e-4) echo 1e-4 ;; *) echo 1e-6 ;; esac
}

columns() { echo "$file,$setting,$solver,$(allowed)"; }

verdicts() {
  certify >"$work/cone"
  certify --law box >"$work/box"
  [ -s "$work/cone" ] && [ -s "$work/box" ] || return 1
  jq -rs '. as [$cone, $box] | [$cone.verdict, $cone.backward_error, ($cone.right_for // "" | split(" ")[0]),
    $box.verdict, $box.backward_error] | @csv' "$work/cone" "$work/box" | tr -d '"'
}

mkdir -p "$out"
{
  echo 'file,setting,solver,tolerance,code,error,seconds,verdict,backward_error,right_for,box_verdict,box_backward_error'
  every_run "$@"
} >"$out/$name.csv"
write_tables "$out"
