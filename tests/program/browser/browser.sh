#!/bin/sh
# browser.sh SLIPPROOF PROJECT FOLDER: makes a report in FOLDER and looks at it with Chromium. Exit code 77: skipped.
set -eu
slipproof=$1 project=$2 folder=$3
here=$(cd "$(dirname "$0")" && pwd)
for program in node npm chromium; do
  command -v "$program" >/dev/null || { echo "skipped: no $program"; exit 77; }
done
mkdir -p "$folder"
cp "$here/package.json" "$here/package-lock.json" "$here/report.mjs" "$folder/"
cd "$folder"
npm ci --ignore-scripts --no-audit --no-fund >npm.log 2>&1 || { cat npm.log; echo "skipped: npm ci failed"; exit 77; }
"$slipproof" trade --quick --json >trade.json
"$slipproof" report --samples 300 --trade trade.json --out index.html --quiet
"$slipproof" report "$project/proofs" --out papers --quiet
"$slipproof" certify "$project/cases/contact-problems/pushed-block.json" --report contact.html --quiet >certify.txt
SLIPPROOF="$slipproof" PROJECT="$project" node --test --test-reporter=spec report.mjs
