#!/bin/sh
# site.sh SLIPPROOF PROJECT FOLDER: makes the site in FOLDER and reads it in Chromium. Exit code 77: skipped.
set -eu
slipproof=$1 project=$2 folder=$3
here=$(cd "$(dirname "$0")" && pwd)
for program in node npm chromium mkdocs; do
  command -v "$program" >/dev/null || { echo "skipped: no $program"; exit 77; }
done
[ -e "$project/build-explorer/explorer.html" ] || { echo "skipped: the explorer is not built (./run explorer)"; exit 77; }
mkdir -p "$folder"
cp "$here/package.json" "$here/package-lock.json" "$here/site.mjs" "$folder/"
cd "$folder"
npm ci --ignore-scripts --no-audit --no-fund >npm.log 2>&1 || { cat npm.log; echo "skipped: npm ci failed"; exit 77; }
"$project/src/faces/site/build.sh" "$(dirname "$slipproof")" site --samples 100 --lines 0
SLIPPROOF="$slipproof" PROJECT="$project" node --test --test-reporter=spec site.mjs
