#!/bin/sh
# explorer.sh SLIPPROOF PROJECT FOLDER: makes an explorer in FOLDER and drags it in Chromium. Exit code 77: skipped.
set -eu
slipproof=$1 project=$2 folder=$3
here=$(cd "$(dirname "$0")" && pwd)
for program in node npm chromium; do
  command -v "$program" >/dev/null || { echo "skipped: no $program"; exit 77; }
done
[ -e "$project/build-explorer/explorer.html" ] || { echo "skipped: the explorer is not built (./run explorer)"; exit 77; }
mkdir -p "$folder"
cp "$here/package.json" "$here/package-lock.json" "$here"/explorer*.mjs "$folder/"
cd "$folder"
npm ci --ignore-scripts --no-audit --no-fund >npm.log 2>&1 || { cat npm.log; echo "skipped: npm ci failed"; exit 77; }
"$slipproof" explore "$project/cases/ambiguous.toml" -o explorer.html --quiet
"$slipproof" explore "$project/cases/engines/scenes/several-or-none/painleve-rod-inconsistent.toml" -o rod.html --quiet
"$slipproof" explore "$project/cases/mechanisms/scenes/three-axles.toml" -o truck.html --quiet
"$slipproof" report "$project/cases/engines" --out engines --quiet
"$slipproof" report "$project/proofs/ladder" --out papers --samples 100 --lines 0 --quiet || [ $? -lt 5 ]
SLIPPROOF="$slipproof" node --test --test-reporter=spec explorer.mjs
node explorer_numbers.mjs "$slipproof" "$project/build-explorer/library.js" 500 \
  "$project"/cases/*.toml "$project"/cases/mechanisms/scenes/*.toml
