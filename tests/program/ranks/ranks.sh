#!/usr/bin/env bash
# Many ranks give the bytes of one, whichever of them is killed: ranks.sh SLIPPROOF SOURCES
set -euo pipefail
export LC_ALL=C
readonly slipproof=$1 sources=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

fail() {
  echo "$1"
  exit 1
}

# Right answers and wrong ones, blank lines, and lines that are no records: some pieces.
awk 'BEGIN {
  print "F,mode,a,S2,S3,N2,N3"
  right = "3.27,stick/stick,2.9727272727272727,3.1213636363636363,-0.14863636363636363,9.642784090909091,0.16721590909090908"
  for (i = 1; i <= 8000; ++i) {
    if (i % 977 == 0) print "3.2,stick/slip+,3,3.05,-0.05,9.75,0.06\r\n"
    else if (i % 1009 == 0) print "no record"
    else print right
  }
}' >records.csv
mkdir statements
for i in 1 2 3 4 5; do
  printf 'slipproof-statement 1\ntheorem power%d\nreal x\nassume positive: x > 0\nshow x^%d + 1 > x\n' "$i" $((2 * i)) \
    >"statements/power$i.statement"
done
declare -A commands=(
  [certify]="certify records.csv --scene $sources/cases/ambiguous.toml"
  [verify]="verify $sources/proofs/tips-or-slips/claims.toml --samples 100"
  [search]="search ladder --samples 1000"
  [prove]="prove statements"
  [trade]="trade --scenes 5 --seconds 0 --json") # the same but for its speeds

# ranks NUMBER COMMAND: rank 0 in the foreground, with the checkpoint of that name; writes what it says to `found`
ranks() {
  local rank others=() code=0
  for ((rank = 1; rank < $1; ++rank)); do
    SLIPPROOF_RANK=$rank SLIPPROOF_RANKS=$1 "$slipproof" ${commands[$2]} --threads 1 --checkpoint "$2.checkpoint" >"said.$rank" 2>&1 &
    others+=($!)
  done
  [[ ! ${hit-} ]] || (sleep 0.15; kill -KILL "${others[0]}") &
  PMI_RANK=0 PMI_SIZE=$1 "$slipproof" ${commands[$2]} --threads 1 --checkpoint "$2.checkpoint" >found 2>error || code=$?
  wait
  cat /dev/null said.* >others 2>/dev/null && [[ ! -s others ]] || (($1 == 1)) || fail "$2: others say $(cat others)"
  rm -f said.*
  return "$code"
}
without_speeds() { sed 's/"scenes_per_second": [0-9]*/"scenes_per_second": 0/' "$1"; }
# same COMMAND CODE: what was found is what one machine says
same() {
  (($2 == code[$1])) || fail "$1 ends with $2, expected ${code[$1]}: $(cat error)"
  cmp <(without_speeds found) <(without_speeds "expected.$1") || fail "$1 says something else"
  [[ $1 != prove ]] || cmp <(cat statements/*.cert) certificates || fail "prove writes something else"
}

declare -A code
for name in "${!commands[@]}"; do
  code[$name]=0
  "$slipproof" ${commands[$name]} >"expected.$name" || code[$name]=$?
  [[ $name != prove ]] || cat statements/*.cert >certificates
  for number in 1 2 3; do
    rm -f "$name".checkpoint* statements/*.cert
    found=0
    ranks "$number" "$name" || found=$?
    same "$name" "$found"
  done
done
((code[certify] == 1)) || fail "certify ends with ${code[certify]}"
(($(stat -c %s certify.checkpoint.2) > 30000)) || fail "rank 2 has done nothing"

# A rank that is killed is missed by nobody; a run whose rank 0 is killed goes on with other ranks.
for name in certify verify search prove; do
  rm -f "$name".checkpoint* statements/*.cert
  found=0
  hit=yes ranks 3 "$name" || found=$?
  same "$name" "$found"
  rm -f "$name".checkpoint* statements/*.cert
  for delay in 0.05 0.1 0.3; do
    timeout --signal KILL "$delay" env SLIPPROOF_RANK=0 SLIPPROOF_RANKS=2 "$slipproof" ${commands[$name]} --threads 1 \
      --checkpoint "$name.checkpoint" >found 2>error &
    SLIPPROOF_RANK=1 SLIPPROOF_RANKS=2 "$slipproof" ${commands[$name]} --threads 1 --checkpoint "$name.checkpoint"
    wait
    cmp -n "$(stat -c %s found)" found "expected.$name" || fail "$name has printed no beginning of the output"
  done
  found=0
  ranks 3 "$name" || found=$?
  same "$name" "$found"
done

refused() { # WORDS COMMAND...
  if SLIPPROOF_RANK=0 SLIPPROOF_RANKS=2 "$slipproof" "${@:2}" >found 2>&1; then fail "${*:2} ran on two ranks"; fi
  grep -q "$1" found || fail "${*:2} was refused with: $(cat found)"
}
refused "more than one rank" solve "$sources/cases/ambiguous.toml"
refused "many ranks" verify --mutants
refused "2 ranks without it" search ladder
refused "cannot be written" search ladder --checkpoint none/x
if SLIPPROOF_RANK=2 SLIPPROOF_RANKS=2 "$slipproof" search ladder 2>found; then fail "rank 2 of 2 ran"; fi
grep -q "found rank 2 of 2" found || fail "rank 2 of 2 was refused with: $(cat found)"
