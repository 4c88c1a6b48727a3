#!/bin/sh
# run.sh EXPECTED PROGRAM [ARGUMENT...]: the program ends well and prints what stands in the file EXPECTED.
set -eu
expected=$1
shift
output=$("$@")
printf '%s\n' "$output" | diff "$expected" -
