#!/bin/sh
# sabotage.sh SLIPPROOF JUDGE PAPER SCRATCH LIST: a writer of statements that says too little is noticed. Each sabotage of
# the list makes a statement of the paper weaker, has it proved, and the judge no longer calls its claim proved or refuted;
# it still does so of all others. A paper without certificates is proved first.
set -eu
slipproof=$1 judge=$2 paper=$3 scratch=$4 list=$5
rm -rf "$scratch"
mkdir -p "$scratch"
if [ ! -f "$paper/claims.theorems" ]; then
  cp -r "$paper" "$scratch/paper"
  paper=$scratch/paper
  "$slipproof" prove --quiet "$paper/claims.toml" || true
fi
"$judge" "$paper" >"$scratch/before" || true
sed -i "s|$paper|PAPER|" "$scratch/before"
count=0

# with THEOREM FILES...: the theorem file on standard input with these texts in place of the theorem's
with() {
  theorem=$1
  shift
  awk -v theorem="theorem $theorem" -v files="$*" '
    $0 == "slipproof-statement 1" {
      first = $0
      getline
      its = $0 == theorem
      if (its) { count = split(files, names, " "); for (i = 1; i <= count; ++i) while ((getline line <names[i]) > 0) print line }
      $0 = first "\n" $0
    }
    !its'
}

# CLAIM, STATEMENT, and what sed does to it; without a change of the text, or without a proof of it, the test is wrong.
sabotage() {
  count=$((count + 1))
  copy=$scratch/$count changed=$scratch/changed
  cp -r "$paper" "$copy"
  "$slipproof" check --show "$2.statement" "$paper/claims.theorems" >"$scratch/statement"
  sed -E "$3" "$scratch/statement" >"$changed.statement"
  ! cmp -s "$scratch/statement" "$changed.statement" || { echo "$1: nothing was changed"; exit 1; }
  if [ "$3" = d ]; then
    with "$2" <"$paper/claims.theorems" >"$copy/claims.theorems"
  else
    "$slipproof" prove --again --quiet "$changed.statement" >"$copy/out" || { printf "%s: not proved: %s\n" "$1" "$3"; exit 1; }
    with "$2" "$changed.statement" "$changed.cert" <"$paper/claims.theorems" >"$copy/claims.theorems"
  fi
  "$judge" "$copy" >"$copy/after" || true
  grep -q "^open $copy/claims.theorems/$1\$" "$copy/after" || { printf "%s: not noticed: %s\n" "$1" "$3"; exit 1; }
  sed "s|$copy|PAPER|; s|^open PAPER/claims.theorems/$1\$|same|" "$copy/after" | grep -E '^(proved|refuted|open) ' >"$copy/others"
  grep -E '^(proved|refuted|open) ' "$scratch/before" | grep -v " PAPER/claims.theorems/$1\$" | cmp - "$copy/others" ||
    { echo "$1: another claim is judged differently"; exit 1; }
}

while read -r claim statement change; do sabotage "$claim" "$statement" "$change"; done <"$list"
echo "$count sabotages noticed"
