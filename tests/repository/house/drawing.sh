#!/bin/sh
# drawing.sh SRC: the house as text, from SRC/layers.txt and the includes: each wing, and the wings whose headers it includes.
set -eu
cd "$1"
grep -rhHoE '^[ \t]*#[ \t]*include[ \t]*"[a-z_]+/' --include='*.hpp' --include='*.cpp' --include='*.h' --include='*.inc' . |
  sed -E 's#^\./([a-z_]+)/.*"([a-z_]+)/$#\1 \2#' | sort -u | awk '
    FILENAME == "-" { if ($1 != $2) uses[$1, $2] = 1; next }
    /^[a-z_]+:/ { wing[++wings] = substr($1, 1, length($1) - 1) }
    END {
      for (i = wings; i >= 1; --i) {
        below = ""
        for (j = i - 1; j >= 1; --j) if ((wing[i], wing[j]) in uses) below = below " " wing[j]
        if (below == "") print wing[i]
        else printf "%-10s%s\n", wing[i], below
      }
    }' - layers.txt
