#!/bin/sh
# all_solutions.sh PROGRAM CERTIFICATES: the verified checker accepts these certificates of all motions, and judges them
# after each of these changes as it should.
set -eu
program=$1 certificates=$2
scratch=$(mktemp -d)
trap 'rm -r "$scratch"' EXIT
"$program" "$certificates"/*.cert

changes=0
while read -r verdict name change; do
  changes=$((changes + 1))
  sed "$change" "$certificates/$name.cert" >"$scratch/changed.cert"
  if cmp -s "$certificates/$name.cert" "$scratch/changed.cert"; then
    echo "nothing changed: $name $change"
    exit 1
  fi
  found=$("$program" "$scratch/changed.cert" || true)
  case $found in
    "$verdict"*) ;;
    *) echo "$name $change: found $found, expected $verdict"; exit 1 ;;
  esac
done <<'END'
accepted rests-or-lifts s/exact 0/exact 0 within 1/
accepted rests-or-lifts s/exact 0/exact 0 within 1/;s/known 1/known 0/
rejected rests-or-lifts s/exact 0/exact 0 within 1\/2/;s/known 1/known 0/
rejected rests-or-lifts s/exact 0/exact 0 within -1/
rejected rests-or-lifts s/known 1/known 0/
rejected rests-or-lifts s/exact 1/exact 2/
rejected touches s/empty -1/empty 0/
rejected touches s/empty -1/empty 1/
rejected touches s/known 0/empty 1/
rejected guided s/empty -1 0/empty 0 0/
rejected guided s/within 0 1/within 0 1\/2/
rejected guided s/0 -1$/0 0/
rejected guided s/known 0$/empty 0 0/
accepted rests s/alone 1/within 0/;s/known 0.*/known 0/
accepted rests s/alone 1//;s/known 0.*/known 0/
unreadable rests s/alone 1//
rejected rests s/alone 1/alone 1\/2/
rejected rests s/alone 1/alone 0/
unreadable rests s/alone 1/alone 1 within 0/
rejected rests s/0 0 1\/2/0 0 1/
rejected rests s/known 0  -1  1/known 0  0  1/
rejected rests s/known 0  -1  1/known 0  -1  0/
rejected rests s/empty -1/empty 1/
unreadable rests s/empty -1//
unreadable rests s/eliminated.*//
accepted slides s/within 0 0//
rejected slides s/within 0 0/within 0 -1/
rejected slides s/known 0  1\/2 1/known 0  1\/2 0/
rejected slides s/empty 0 1/empty 0 0/
rejected slides s/slide+/slide-/
rejected paradox s/known 2  1 0/known 2  1 1/
rejected paradox s/known 1/known 0/
rejected paradox s/empty 1 0/empty 0 0/
rejected paradox s/alone 2/within 0 0/;s/known 2.*/known 2 0 0 0 0/
rejected sticks s/known 0  -1 0 0/known 0  0 0 0/
rejected sticks s/radius 1\/4 1\/4/radius 1\/4 4/
rejected sticks s/slips 0 4  1 0  0 1/slips 0 4  0 1  1 0/
rejected three-contacts s/decide 1/decide 0/
rejected three-contacts s/slips 2/slips 1/
rejected slides-in-space s/alone 4/alone 1/
rejected slides-in-space s/alone 4/alone 64/
rejected slides-in-space s/slips 0 4  1 0  0 1  -1 0/slips 0 4  1 0  0 1  -1 1/
rejected slides-in-space s/slips 0 4  1 0  0 1  -1 0  0 -1/slips 0 3  1 0  0 1  -1 0/;s/    empty 0 0 1//
rejected slides-in-space s/center 10 -3 -4 2/center 10 -3 -4 3/
rejected near-a-slide s/within 0 1\/16 1\/16/within 0 1\/16 0/
rejected near-a-slide s/within 0 1\/16 1\/16//
rejected near-a-slide s/within 0 1\/16 1\/16/within 0 1\/16 -1/
rejected with-free-unknown s/eliminated 1 0 0 1/eliminated 1 0 0 3/
rejected with-free-unknown s/alone 488/alone 4880/
rejected with-free-unknown s/alone 488/alone 1/
accepted block-rests s/1\/2 0  1\/2 0/1\/2 0  1\/2 0 within 0 0 0 1/
accepted block-rests s/0 3  1/0 4  0 5 6 7 8  1/
rejected block-rests s/1\/2 0  1\/2 0/1\/2 0  1\/2 0 within 0 0 0 -1/
rejected block-rests s/1\/2 0  1\/2 0/1\/2 1\/8  1\/2 -1\/8/
rejected block-rests s/0 3 -1/0 3 -2/
rejected block-rests s/3 1 2/3 1 3/
rejected block-rests s/1 1 2/1 1 3/
rejected block-rests s/2 3 1/2 3 0/
rejected block-rests s/  1 -1 1 1 1/  -1 -1 1 1 1/
rejected block-rests s/  1 -1 1 1 1/  1 -1 1 1 7\/8/
rejected block-rests s/0 3  1 0 1 0 1/0 2/
unreadable block-rests s/0 3  1 0 1 0 1/0 3/
unreadable block-rests s/frictionless 0/frictionless 1/
unreadable block-rests s/1 1 1$/1 1/
accepted lifts-off s/3  2 1 0 0/4  1 1 0 0  1 1 0 0/
rejected lifts-off s/constant -2 1 0 0/constant -2 1 0 1/
rejected lifts-off s/constant -2 1 0 0/constant -2 1 1 0/
rejected lifts-off s/3  2 1 0 0/3  1 1 0 0/
rejected lifts-off s/3  2 1 0 0/2/
rejected lifts-off s/matrix 5/matrix 6  2 3 1/
rejected on-ice s/mu 0 1/mu 1 1/
rejected on-ice s/-1 2  -1 0/-1 2  1 2/;s/1 0  1 0/1 0  0 0/
rejected on-ice s/1 0  1 0$/2 0  1 0/
rejected rests-or-lifts s/solutions 2/solutions 1/;s/motion exact 1//;s/decide.*/frictionless 0 1  -1 1/;s/ *known.*//
rejected rests-or-lifts s/solutions 2/solutions 1/;s/motion exact 1//;s/decide.*/frictionless 0 1  1 1/;s/ *known.*//
rejected rests s/alone 1//;s/decide.*/frictionless 0 1  1 1/;s/ *empty.*//;s/ *known.*//
END
echo "$changes changes are judged as they should be"
