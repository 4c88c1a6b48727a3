#!/bin/sh
# types.sh FOLDER USE: mypy accepts the package's types, the first example of its page, and the types in a file that uses
# them, where it is installed.
set -eu
/usr/bin/env mypy --version >/dev/null 2>&1 || exit 77
mypy --strict --cache-dir=/dev/null "$1/slipproof"
first=$(sed -n '/^```python$/,/^```$/ { s/^\(>>>\|\.\.\.\) //p; /^```$/q }' "$1/README.md")
case $first in *"import slipproof"*certify*) ;; *) echo "found no first example in $1/README.md" && exit 1 ;; esac
export MYPYPATH="$1"
mypy --strict --cache-dir=/dev/null -c "$first"
exec mypy --strict --cache-dir=/dev/null "$2"
