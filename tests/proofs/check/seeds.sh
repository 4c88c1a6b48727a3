#!/bin/sh
# seeds.sh PROOFS OUT: what the fuzzer starts from: each short certificate of PROOFS with its statement, as fuzz.cpp
# reads them.
set -eu
mkdir -p "$2"
find "$1" -name '*.theorems' | while read -r file; do
  awk -v out="$2" '
    function flush() {
      if (proof != "" && length(proof) <= 4000) {
        printf "%s====\n%s", statement, proof >(out "/" name ".cert")
        close(out "/" name ".cert")
      }
      statement = proof = ""
    }
    $0 == "slipproof-statement 1" { flush(); part = 1; line = 0 }
    $0 == "slipproof-certificate 1" { part = 2; line = 0 }
    { ++line }
    part == 1 { statement = statement $0 "\n"; if (line == 2) name = substr($0, 9) }
    part == 2 && line > 2 { proof = proof $0 "\n" }
    END { flush() }' "$file"
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
