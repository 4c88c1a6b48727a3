#!/bin/sh
# sabotage.sh SLIPPROOF JUDGE PAPER SCRATCH: a writer of statements that says too little is noticed. Each sabotage makes a
# statement of the paper weaker, has it proved, and the judge no longer calls its claim proved or refuted; it still does so
# of all others.
set -eu
slipproof=$1 judge=$2 paper=$3 scratch=$4
rm -rf "$scratch"
mkdir -p "$scratch"
"$judge" "$paper" >"$scratch/before" || true
sed -i "s|$paper|PAPER|" "$scratch/before"
count=0

# CLAIM, STATEMENT, and what sed does to it; without a change of the text, or without a proof of it, the test is wrong.
sabotage() {
  count=$((count + 1))
  copy=$scratch/$count
  cp -r "$paper" "$copy"
  statement=$copy/certificates/$2.statement
  sed -E "$3" "$paper/certificates/$2.statement" >"$statement"
  ! cmp -s "$paper/certificates/$2.statement" "$statement" || { echo "$1: nothing was changed"; exit 1; }
  if [ "$3" = d ]; then
    rm "$statement" "$copy/certificates/$2.cert"
  else
    "$slipproof" prove --again --quiet "$statement" >"$copy/out" || { printf "%s: not proved: %s\n" "$1" "$3"; exit 1; }
  fi
  "$judge" "$copy" >"$copy/after" || true
  grep -q "^open $copy/certificates/$1\$" "$copy/after" || { printf "%s: not noticed: %s\n" "$1" "$3"; exit 1; }
  sed "s|$copy|PAPER|; s|^open PAPER/certificates/$1\$|same|" "$copy/after" | grep -E '^(proved|refuted|open) ' >"$copy/others"
  grep -E '^(proved|refuted|open) ' "$scratch/before" | grep -v " PAPER/certificates/$1\$" | cmp - "$copy/others" ||
    { echo "$1: another claim is judged differently"; exit 1; }
}

while read -r claim statement change; do sabotage "$claim" "$statement" "$change"; done <<'END'
L1 L1.only-then s/mu1 >= 0/mu1 > 0/
L1 L1.only-then s/N2 >= 0 and/N2 > 0 and/
L1 L1.only-then s/^show (.*)/show \1 or m > 0/
L1 L1.only-then s/^assume motion: /assume more: m > 1\nassume motion: /
L1 L1.always d
L1 L1.always s/-mu2\*N2 <= S2 <= /S2 <= /
L1 L1.always s/ and N1 >= 0//
L1 L1.always s/ and N2 >= 0//
L10 L10.4 s/gap_wall >= 0/gap_wall > 0/
L10 L10.1 s/^define ax_: .*/define ax_: 0 = 1/
P2 P2.refuted s/g > 0 and //
END
echo "$count sabotages noticed"
