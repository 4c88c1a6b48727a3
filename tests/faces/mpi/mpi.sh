#!/usr/bin/env bash
# Many ranks give the bytes of one; a run whose ranks are killed, as often as it is, goes on with another number of ranks.
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
  for (i = 1; i <= 48000; ++i) {
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
search=(search ladder --samples 4000)
trade=(trade --scenes 60 --seconds 0 --json) # the same but for its speeds
prove=(prove statements)
mkdir statements
theorems=$sources/proofs/wheelie-and-stoppie/claims.theorems
for name in $(awk '$0 == "slipproof-statement 1" { getline; print substr($0, 9) }' "$theorems" | grep '^W1'); do
  "$slipproof" check --show "$name.statement" "$theorems" >"statements/$name.statement"
done
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

# Output in parts is that of one machine, once it is joined; a part that is not as it was written is named.
for number in 1 3; do
  found=0
  rm -f out.*
  ranks "$number" "${certify[@]}" --threads 1 --parts out >found || found=$?
  ((found == code[certify])) || fail "certify --parts: $number ranks end with $found"
  cmp found <(tail -n 4 expected.certify) || fail "certify --parts: $number ranks say something else"
  found=0
  "$slipproof" join out -o joined || found=$?
  ((found == code[certify])) || fail "join of $number parts ends with $found"
  cmp joined expected.certify || fail "join of $number parts writes something else"
done
part=$(find . -name 'out.*.1' | head -n 1)
printf '?' | dd of="$part" bs=1 seek=5 conv=notrunc status=none
if "$slipproof" join out >joined 2>error; then fail "a changed part was joined"; fi
grep -q "^${part#./}: found other bytes" error || fail "a changed part gives: $(cat error)"
[[ ! -s joined ]] || fail "of a changed part something was written"

# Where rank 0 cannot begin, the others do not wait for it.
for refused in "search ladder --checkpoint none/x" "certify records.csv --scene $sources/cases/ambiguous.toml --parts none/x" \
  "verify papers --samples 5 --report records.csv"; do
  found=0
  become="timeout 60" ranks 2 $refused >found 2>error || found=$?
  ((found == 6)) || fail "$refused ends with $found: $(cat error)"
done

milliseconds() { echo $((${EPOCHREALTIME/./} / 1000)); }

# goes_on KIND NAME: runs that are hit at random moments, each with another number of ranks, until one comes to its end.
# In parts, a run goes on from their index, and what is joined counts.
goes_on() {
  local kind=$1 name=$2 number=0 more pid victim delay found patience
  local -n arguments=${name/parts/certify}
  local expected=expected.${name/parts/certify} expects=${code[${name/parts/certify}]} checkpoint=checkpoint option=--checkpoint
  [[ $name != parts ]] || checkpoint=out.index option=--parts
  rm -f checkpoint out.*
  [[ $name != prove ]] || rm -f statements/*.cert
  for ((run = 0; ; ++run)); do
    more=$((1 + RANDOM % 3)) found=0 patience=100
    number=$((1 + (number + more - 1) % 4))
    become=exec ranks "$number" "${arguments[@]}" --threads 1 "$option" "${checkpoint%.index}" >found 2>error &
    pid=$!
    if ((run == 0 || RANDOM % 2)); then
      delay=$(((RANDOM * 32768 + RANDOM) % length[$name]))
      sleep "$(printf '%d.%03d' $((delay / 1000)) $((delay % 1000)))"
      hits=$((hits + 1))
      case $kind in
        TERM) kill -TERM "$pid" 2>/dev/null || true ;;
        KILL)
          mapfile -t victim < <(pgrep -P "$pid" || true)
          ((${#victim[@]} == 0)) || kill -KILL "${victim[RANDOM % ${#victim[@]}]}" 2>/dev/null || true
          ;;
      esac
    fi
    wait "$pid" || found=$?
    # mpirun ends with 1 where it is hit itself, so that the last line alone tells a run that came to its end.
    if tail -n 1 found | grep -q "^s "; then break; fi
    interrupted=$((interrupted + 1))
    [[ $name == parts ]] || cmp -n "$(stat -c %s found)" found "$expected" || fail "$kind: $name has printed no beginning of the output"
    ! grep -q "missing: " error || named=$((named + 1))
    # mpirun may end before its ranks do
    until [[ ! -e $checkpoint ]] || flock -n "$checkpoint" true || ((--patience == 0)); do sleep 0.1; done
  done
  if [[ $name == parts ]]; then
    found=0
    "$slipproof" join out >found || found=$?
    ((found == expects)) || fail "$kind: what is joined ends with $found"
  fi
  cmp found "$expected" || fail "$kind: $name says something else after $run runs that were hit"
  [[ $name != prove ]] || cmp <(cat statements/*.cert) certificates || fail "$kind: prove writes something else"
}

declare -A length
for name in certify parts verify search prove; do
  declare -n arguments=${name/parts/certify}
  [[ $name != prove ]] || rm -f statements/*.cert
  start=$(milliseconds)
  ranks 2 "${arguments[@]}" --threads 1 >found || true
  length[$name]=$(($(milliseconds) - start))
  declare +n arguments
  hits=0 interrupted=0 named=0
  # A hit that comes when all is done shows nothing.
  for ((i = 0; interrupted < kills && i < 5 * kills; ++i)); do
    goes_on KILL "$name"
    ((i % 4)) || goes_on TERM "$name"
  done
  ((interrupted >= kills)) || fail "$name: only $interrupted of $hits hits came before the end of a run"
  echo "$name: $hits hits, $interrupted before the end of a run, $named of these named what was missing"
done
