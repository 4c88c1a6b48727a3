#!/bin/sh
# seeds.sh PROOFS OUT: what the fuzzer starts from: each short certificate of PROOFS with its statement, as fuzz.cpp
# reads them.
set -eu
mkdir -p "$2"
find "$1" -name '*.cert' -size -5k | while read -r certificate; do
  statement=${certificate%.cert}.statement
  { cat "$statement"; echo ====; tail -n +3 "$certificate"; } >"$2/$(basename "$certificate")"
done
# No certificate that splits is short.
cat >"$2/split" <<'END'
slipproof-statement 1
theorem square
real x y
assume a: y = x or x > 0 and y >= 0
show x^2 >= 0
====
split s: x
branch negative
contradiction
term 1 s^2
term 1 goal
qed
branch zero
contradiction
term 1 goal
equation s: x
qed
branch positive
contradiction
term 1 s^2
term 1 goal
qed
end
END
