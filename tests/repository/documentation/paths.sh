#!/bin/sh
# paths.sh PROJECT: a word in a comment of src or tests that looks like a path of this tree is one. It looks like one if it
# ends as files of sources do (FOLDER/b.hpp, FOLDER/b.md), or begins with a wing or with src/, tests/, proofs/ or cases/; it is one from src/, from
# tests/, from PROJECT, or from the folder of the comment or one above it.
set -eu
cd "$1"
find src tests -name '*.hpp' -o -name '*.cpp' -o -name '*.h' -o -name '*.c' -o -name '*.inc' -o -name '*.py' -o -name '*.sh' \
  -o -name '*.awk' -o -name '*.cmake' -o -name CMakeLists.txt | sort | xargs awk '
  function there(name) {
    if (!(name in seen)) seen[name] = system("test -e '\''" name "'\''") == 0
    return seen[name]
  }
  function found(name,   folder) {
    if (there(name) || there("src/" name) || there("tests/" name)) return 1
    folder = FILENAME
    while (sub(/\/[^\/]*$/, "", folder)) if (there(folder "/" name)) return 1
    return 0
  }
  {
    line = $0
    if (FILENAME ~ /\.(hpp|cpp|h|c|inc)$/) {
      if (!match(line, /(^|[ ;{}])\/\/|^ *\*|\/\*/)) next
    } else if (!match(line, /(^| )# /)) next
    line = substr(line, RSTART)
    if (line ~ /include[ \t]*["<]/) next
    while (match(line, /[A-Za-z0-9_.*{}<>$:~-]*(\/[A-Za-z0-9_.*{}<>$:-]+)+/)) {
      name = substr(line, RSTART, RLENGTH)
      line = substr(line, RSTART + RLENGTH)
      sub(/[.:]+$/, "", name)
      if (name ~ /[*{}<>$:~]/ || name ~ /^\// || name ~ /^(build|usr|etc|proc)/ || name ~ /(^|\/)[A-Z_]+(\/|$|\.)/) continue
      if (name !~ /\.(hpp|cpp|h|inc|md|toml|py|sh|awk|txt|mjs|csv|svg|html|css|js|in)$/ && name !~ /^(src|tests|proofs|cases|base|mechanics|floating|contact|records|claims|report|faces)\//) continue
      if (!found(name)) { print FILENAME ":" FNR ": there is no " name; failed = 1 }
    }
  }
  END { exit failed }'
