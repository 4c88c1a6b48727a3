#!/usr/bin/env bash
# Many ranks give the bytes of one; a run whose ranks are killed goes on from its checkpoint with another number of ranks.
# Usage: mpi.sh SLIPPROOF SLIPPROOF_MPI MPIRUN SOURCES KILLS
set -euo pipefail
export LC_ALL=C OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
readonly slipproof=$1 slipproof_mpi=$2 mpirun=$3 sources=$4 kills=$5
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
RANDOM=20261122 # the moments are the same in every run, as far as the machine allows

ranks() { # NUMBER ARGUMENTS...; in the background it becomes mpirun itself
  local number=$1
  shift
  $become "$mpirun" --quiet -n "$number" --oversubscribe "$slipproof_mpi" "$@"
}

become=""

fail() {
  echo "$1"
  exit 1
}

# Right answers and wrong ones, blank lines, and lines that are no records: more than two pieces.
awk 'BEGIN {
  print "F,mode,a,S2,S3,N2,N3"
  right = "3.27,stick/stick,2.9727272727272727,3.1213636363636363,-0.14863636363636363,9.642784090909091,0.16721590909090908"
  for (i = 1; i <= 24000; ++i) {
    if (i % 977 == 0) print "3.2,stick/slip+,3,3.05,-0.05,9.75,0.06\r\n"
    else if (i % 1009 == 0) print "no record"
    else print right
  }
}' >records.csv
certify=(certify records.csv --scene "$sources/cases/ambiguous.toml")
verify=(verify "$sources/proofs/wheelie-and-stoppie/claims.toml" --samples 200)
papers=(verify papers --samples 20 --json)
mkdir -p papers/first papers/second
cp "$sources/proofs/wheelie-and-stoppie"/*.toml papers/first
cp "$sources/proofs/block-on-incline"/*.toml papers/second
search=(search ladder --samples 60)
trade=(trade --scenes 60 --seconds 0 --json) # the same but for its speeds
prove=(prove statements)
mkdir statements
for i in 1 2 3 4 5; do
  printf 'slipproof-statement 1\ntheorem power%d\nreal x\nassume positive: x > 0\nshow x^%d + 1 > x\n' "$i" $((2 * i)) \
    >"statements/power$i.statement"
done
printf 'slipproof-statement 1\ntheorem wrong\nreal x\nassume positive: x > 0\nshow x > 1\n' >statements/wrong.statement

without_speeds() {
  sed 's/"scenes_per_second": [0-9]*/"scenes_per_second": 0/'
}

# same NAME RANKS THREADS: the command of that name says what it says on one machine.
same() {
  local -n arguments=$1
  local found=0
  [[ $1 != prove ]] || rm -f statements/*.cert
  ranks "$2" "${arguments[@]}" --threads "$3" | without_speeds >found || found=$?
  ((found == ${code[$1]})) || fail "$1: $2 ranks of $3 threads end with $found, expected ${code[$1]}"
  cmp found "expected.$1" || fail "$1: $2 ranks of $3 threads say something else"
  [[ $1 != prove ]] || cmp <(cat statements/*.cert) certificates || fail "$2 ranks of $3 threads write something else"
}

declare -A code
for name in certify verify papers search trade prove; do
  declare -n arguments=$name
  code[$name]=0
  "$slipproof" "${arguments[@]}" | without_speeds >"expected.$name" || code[$name]=$?
  declare +n arguments
done
cat statements/*.cert >certificates
((code[certify] == 1 && code[prove] == 1)) || fail "one machine ends with ${code[certify]} and ${code[prove]}"
for number in 1 2 3 8; do
  for threads in 1 2; do same certify "$number" "$threads"; done
done
for name in verify papers search trade prove; do
  for number in 2 3 8; do same "$name" "$number" 1; done
  same "$name" 2 2
done

for refused in "solve $sources/cases/ambiguous.toml" "verify --mutants"; do
  if ranks 2 $refused >found 2>error; then fail "$refused ran on two ranks"; fi
  grep -q "found .*more than one rank\|found .*many ranks" error || fail "$refused was refused with: $(cat error)"
done

# goes_on KIND NAME: a run that is hit at a random moment, then one of another number of ranks that ends.
goes_on() {
  local -n arguments=$2
  local kind=$1 expected=expected.$2 number=$((2 + RANDOM % 3)) pid victim found=0 patience=100
  rm -f checkpoint
  become=exec ranks "$number" "${arguments[@]}" --threads 1 --checkpoint checkpoint >found 2>error &
  pid=$!
  sleep "$((RANDOM % 3)).$((RANDOM % 1000))"
  case $kind in
    TERM) kill -TERM "$pid" 2>/dev/null || true ;;
    KILL)
      mapfile -t victim < <(pgrep -P "$pid" || true)
      ((${#victim[@]} == 0)) || kill -KILL "${victim[RANDOM % ${#victim[@]}]}" 2>/dev/null || true
      ;;
  esac
  wait "$pid" || true
  # mpirun ends with 1 where it is hit itself, so that the last line alone tells a run that came to its end.
  if tail -n 1 found | grep -q "^s "; then
    cmp found "$expected" || fail "a run that was hit too late says something else"
    return
  fi
  interrupted=$((interrupted + 1))
  cmp -n "$(stat -c %s found)" found "$expected" || fail "$kind: what was printed is no beginning of the output"
  ! grep -q "missing: " error || named=$((named + 1))
  until flock -n checkpoint true || ((--patience == 0)); do sleep 0.1; done # mpirun may end before its ranks do
  ranks "$((1 + RANDOM % 3))" "${arguments[@]}" --threads 1 --checkpoint checkpoint >found || found=$?
  ((found == code[$2])) || fail "$kind: the run that goes on ends with $found"
  cmp found "$expected" || fail "$kind: the run that goes on says something else"
}
interrupted=0 named=0
for ((i = 0; i < kills; ++i)); do
  goes_on TERM certify
  goes_on KILL certify
  goes_on TERM verify
  goes_on KILL verify
done
echo "$((4 * kills)) runs were hit, $interrupted before their end, $named of these named what was missing"
