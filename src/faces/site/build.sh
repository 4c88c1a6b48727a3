#!/usr/bin/env bash
# build.sh BUILT OUT [OPTION...]: makes the site in OUT with the program in BUILT: its front page, on which the explorer runs,
# the report of all papers, for which the options are, the table of the engines, and all pages of the project with navigation
# and search. It needs no server. `slipproof explore` finds the explorer where ./run explorer put it.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source=$(cd "$here/../../.." && pwd)
built=$(cd "$1" && pwd)
mkdir -p "$2"
out=$(cd "$2" && pwd)
shift 2
program=$built/slipproof
# A verdict other than success is what the report is about; from 5 on, there is none.
allowed() { "$@" || (($? < 5)); }

cd "$source"
"$program" explore cases/three-motions/drawn.toml -o "$out/index.html" --quiet
"$program" explore cases/rest/three-legged-table.toml -o "$out/stand.html" --quiet
allowed "$program" report proofs --out "$out/papers" --quiet "$@"
allowed "$program" report cases/engines --out "$out/engines" --quiet
stand=$("$program" rest cases/rest/three-legged-table.toml | sed -n 's/^ *\(.*it can rest from.*\)/\1/p')
/usr/bin/python3 -B "$here/front.py" "$out/index.html" "version=$("$program" --version)" "stand=$stand"
/usr/bin/python3 -B "$here/pages.py" "$source" "$built" "$out"
