#!/bin/sh
# sabotage.sh SLIPPROOF JUDGE PAPER SCRATCH LIST: a writer of statements that says too little is noticed. Each sabotage of
# the list makes a statement of the paper weaker, has it proved, and the judge no longer calls its claim proved or refuted;
# it still does so of all others. A paper without certificates is proved first.
set -eu
slipproof=$1 judge=$2 paper=$3 scratch=$4 list=$5
rm -rf "$scratch"
mkdir -p "$scratch"
if [ ! -d "$paper/certificates" ]; then
  cp -r "$paper" "$scratch/paper"
  paper=$scratch/paper
  "$slipproof" prove --quiet "$paper/claims.toml" || true
fi
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

while read -r claim statement change; do sabotage "$claim" "$statement" "$change"; done <"$list"
echo "$count sabotages noticed"
