#!/bin/sh
# turned.sh SLIPPROOF PROJECT FOLDER: holds the pages of scenes in space to their pictures. Exit code 77: skipped.
set -eu
slipproof=$1 project=$2 folder=$3
command -v node >/dev/null || { echo "skipped: no node"; exit 77; }
mkdir -p "$folder"
node "$project/tests/program/browser/turned.mjs" "$slipproof" "$folder" "$project"/cases/space/*.toml
