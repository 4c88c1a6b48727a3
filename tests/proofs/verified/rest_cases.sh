#!/bin/sh
# rest_cases.sh PROGRAM CHECKER CLI SCENES: of each scene, at its own load and at one that few can bear, the verified checker
# accepts the certificate as slipproof-check-contact does, in the same words; and changed ones it rejects alike.
set -eu
program=$1 checker=$2 cli=$3 scenes=$4
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
for scene in "$scenes"/*.toml; do
  name=$(basename "$scene" .toml)
  "$cli" rest "$scene" --effort 1000000000 --certificate "$folder/$name.cert" >"$folder/said.txt" 2>&1 || true
  if grep -q ' at [A-Z] = ' "$folder/said.txt"; then
    "$cli" rest "$scene" --load 1000000 --effort 1000000000 --certificate "$folder/$name-loaded.cert" >/dev/null 2>&1 || true
  fi
done
cd "$folder"
"$checker" *.cert >checked.txt
"$program" *.cert >verified.txt
cmp checked.txt verified.txt
count=$(ls *.cert | wc -l)
for words in 'it can rest' 'it cannot rest'; do
  said=$(grep -c "$words" verified.txt) || true
  echo "$said of $count certificates say: $words"
  [ "$said" -ge 5 ]
done

# One digit more in the last force or multiplier; other pushes.
for certificate in *.cert; do
  sed -e '/^problem/d' -e '/^\(forces\|multipliers\)/s/$/1/' "$certificate" >"$certificate.digit"
  sed -e '/^problem/d' -e '/^constant/s/ \(-\{0,1\}[1-9]\)/ \1\1/' "$certificate" >"$certificate.constant"
done
"$checker" *.digit *.constant >checked.txt || true
"$program" *.digit *.constant >verified.txt || true
plain() { sed 's/: \(rejected\|unreadable\): .*/: \1/' "$1"; }
plain checked.txt >checked.plain
plain verified.txt >verified.plain
cmp checked.plain verified.plain
rejected=$(grep -c 'cert.*: rejected' verified.plain)
echo "$rejected of $(grep -c 'cert.*: ' verified.plain) changed ones are rejected"
[ "$rejected" -ge "$count" ]
