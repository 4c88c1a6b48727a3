#!/bin/sh
# again.sh PROGRAM PROOFS SCRATCH NUMBER: a thirtieth of the shipped certificates, chosen by NUMBER, are found again, byte for
# byte, from their statements. Without NUMBER the commit chooses, so that each landing tries others. NUMBER `all`: all of them.
set -eu
export LC_ALL=C
program=$1 proofs=$2 scratch=$3
number=${4:-$(git -C "$proofs" rev-parse HEAD 2>/dev/null || echo 0)}
rm -rf "$scratch"
mkdir -p "$scratch"
found=0
for file in "$proofs"/*/claims.theorems; do
  paper=$(basename "$(dirname "$file")")
  again=$scratch/$paper.theorems shipped=$scratch/$paper.shipped
  # A statement without a certificate is one that was left undecided: its search would run to its end for nothing.
  chosen=$(awk -v number="$number" -v again="$again" -v shipped="$shipped" '
    BEGIN { for (i = 0; i < 256; ++i) code[sprintf("%c", i)] = i }
    function is_chosen(name,  h, text, i) {
      if (number == "all") return 1
      h = 7; text = number name; for (i = 1; i <= length(text); ++i) h = (h * 31 + code[substr(text, i, 1)]) % 1000003
      return h % 30 == 0
    }
    /^slipproof-[a-z]+ [0-9]+$/ {
      part = $1
      if (part == "slipproof-statement") { statement = ""; name = "" }
      if (part == "slipproof-certificate" && (taken = is_chosen(name))) {
        printf "%s", statement >again
        printf "%s", statement >shipped
        ++count
      }
    }
    part == "slipproof-statement" { statement = statement $0 "\n"; if (name == "" && $1 == "theorem") name = substr($0, 9) }
    part == "slipproof-certificate" && taken { print >shipped }
    END { print count + 0 }' "$file")
  [ "$chosen" -gt 0 ] || continue
  "$program" prove --again --quiet "$again" || { echo "$paper: not proved again"; exit 1; }
  cmp "$shipped" "$again" || exit 1
  found=$((found + chosen))
done
[ "$found" -gt 30 ] || { echo "only $found certificates were tried"; exit 1; }
echo "$found certificates found again, chosen by $number"
