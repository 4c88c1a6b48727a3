#!/bin/sh
# again.sh PROGRAM PROOFS SCRATCH NUMBER: a tenth of the shipped certificates, chosen by NUMBER, are found again, byte for
# byte, from their statements. Without NUMBER the commit chooses, so that each landing tries another tenth.
set -eu
program=$1 proofs=$2 scratch=$3
number=${4:-$(git -C "$proofs" rev-parse HEAD 2>/dev/null || echo 0)}
rm -rf "$scratch"
found=0
for folder in "$proofs"/*/certificates; do
  paper=$(basename "$(dirname "$folder")")
  # A statement without a certificate is one that was left undecided: its search would run to its end for nothing.
  chosen=$(cd "$folder" && ls | sed -n 's/\.cert$//p' | awk -v number="$number" '
    BEGIN { for (i = 0; i < 256; ++i) code[sprintf("%c", i)] = i }
    { h = 7; text = number $0; for (i = 1; i <= length(text); ++i) h = (h * 31 + code[substr(text, i, 1)]) % 1000003
      if (h % 10 == 0) print }')
  [ -n "$chosen" ] || continue
  mkdir -p "$scratch/$paper"
  for name in $chosen; do
    grep -q '^slipproof-undecided ' "$folder/$name.cert" || cp "$folder/$name.statement" "$scratch/$paper/"
  done
  "$program" prove --again --quiet "$scratch/$paper" || { echo "$paper: not proved again"; exit 1; }
  for certificate in "$scratch/$paper"/*.cert; do
    cmp "$certificate" "$folder/$(basename "$certificate")"
    found=$((found + 1))
  done
done
[ "$found" -gt 100 ] || { echo "only $found certificates were tried"; exit 1; }
echo "$found certificates found again, chosen by $number"
