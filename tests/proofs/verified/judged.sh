#!/bin/sh
# judged.sh JUDGE PROOFS: of all claims of the papers, the judge leaves at most one in fifty open, and it
# accepts each certificate.
set -eu
"$1" "$2" | tail -1 | awk '{
  print
  if ($1 != "s" || $2 == "REJECTED" || $2 == "UNREADABLE") exit 1
  if ($3 + $5 < 1100 || 50 * $7 > $3 + $5 + $7) exit 1
}'
