#!/usr/bin/env bash
# Kills programs that write results, at random moments, and looks at what stands there then: the older content or the
# complete new one, never a part. Usage: kill.sh SLIPPROOF SOURCES KILLS_OF_EACH_COMMAND
set -euo pipefail
export LC_ALL=C
readonly slipproof=$1 sources=$2 kills=$3
folder=$(mktemp -d)
readonly folder
trap 'rm -rf "$folder"' EXIT
cd "$folder"
RANDOM=20261122 # the moments are the same in every run, as far as the machine allows
failures=0 interrupted=0

microseconds() { echo $((${EPOCHREALTIME/./})); }

# Every file of out/ is that of old/ or that of new/; what else is there is the nameless file of a moment.
inspect() {
  local file name
  while IFS= read -r file; do
    name=${file#out/}
    [[ $(basename "$name") == .slipproof-* ]] && continue
    cmp -s "$file" "old/$name" || cmp -s "$file" "new/$name" || {
      echo "$1: $name is neither the older file nor the new one: $(wc -c <"$file") bytes"
      failures=$((failures + 1))
    }
  done < <(find out -type f)
  while IFS= read -r file; do
    [[ -e out/${file#old/} ]] || {
      echo "$1: ${file#old/} is gone"
      failures=$((failures + 1))
    }
  done < <(find old -type f)
}

# attack NAME COMMAND...: the command writes into out/. Half of the kills come late, when it writes.
attack() {
  local name=$1 start length delay i pid file
  shift
  rm -rf old new out && mkdir old out
  start=$(microseconds)
  "$@" >/dev/null 2>&1 || (($? == 1 || $? == 4)) || { echo "$name does not run"; exit 1; }
  length=$(($(microseconds) - start))
  mv out new
  (cd new && find . -type d -exec mkdir -p ../old/{} \;)
  while IFS= read -r file; do
    if [[ $file == *.theorems ]]; then
      printf 'slipproof-statement 1\ntheorem before%d\nreal x\nshow x^2 >= 0\n' {1..200} >"old/${file#new/}"
    else
      printf 'what stood in %s before\n%.0s' "$file" {1..200} >"old/${file#new/}"
    fi
  done < <(find new -type f)
  for ((i = 0; i < kills; ++i)); do
    rm -rf out && cp -r old out
    delay=$(((RANDOM * 32768 + RANDOM) % (length + 1)))
    ((i % 2)) && delay=$((length - delay / 8))
    "$@" >/dev/null 2>&1 &
    pid=$!
    sleep "$(printf '%d.%06d' $((delay / 1000000)) $((delay % 1000000)))"
    kill -KILL "$pid" 2>/dev/null && interrupted=$((interrupted + 1))
    wait "$pid" 2>/dev/null || true
    inspect "$name, killed after $delay microseconds"
  done
  echo "$name: $kills kills within $length microseconds"
}

scene=$sources/cases/city-bicycle.toml proofs=$sources/proofs/rozenblat-yashin/claims.theorems
{
  echo 'F,a,S2,S3,N2,N3'
  for ((i = 1; i <= 3000; ++i)); do echo "$((i % 7)),0.1,0.2,0.3,400,433"; done
} >answers.csv
attack certify "$slipproof" certify --scene "$scene" --summary out/summary.json answers.csv
attack map "$slipproof" map "$scene" --columns 600 -o out/map.svg
mkdir statements
for name in $(awk '$0 == "slipproof-statement 1" { getline; print substr($0, 9) }' "$proofs" | grep -E '^(A2\.4|A3\.)'); do
  "$slipproof" check --show "$name.statement" "$proofs" >"statements/$name.statement"
done
cat statements/*.statement >chosen.theorems
attack prove "$slipproof" prove statements/*.statement --out out
attack theorems "$slipproof" prove chosen.theorems --out out
attack report "$slipproof" report "$sources/proofs/rear-drive/claims.toml" --samples 20 --lines 0 --out out/report.html
echo "$interrupted of $((5 * kills)) were running when they were killed, $failures failures"
((failures == 0 && interrupted > 0))
