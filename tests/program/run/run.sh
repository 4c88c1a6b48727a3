#!/usr/bin/env bash
# run.sh RUN: what ./run calls, seen by programs that only note how they are called: dpkg-query, which lacks the packages
# of $LACKING, apt-get, sudo, cmake, ctest and the built slipproof.
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
project="$scratch/a path with spaces"
mkdir -p "$project/build" "$scratch/bin"
cp "$1" "$project/run"

note='#!/bin/sh
echo "${0##*/} $*" >>"$CALLS"
'
for program in apt-get cmake ctest run-clang-tidy-14; do echo "$note" >"$scratch/bin/$program"; done
echo "$note"'[ "${SUDO_WORKS-}" ] || exit 1
[ "$1" = -n ] && shift
exec "$@"' >"$scratch/bin/sudo"
echo '#!/bin/sh
for package in "$@"; do :; done
case " $LACKING " in
  *" $package:known "*) printf "not-installed " ;;
  *" $package "*) exit 1 ;;
  *) printf "installed " ;;
esac' >"$scratch/bin/dpkg-query"
echo '#!/bin/sh
echo "slipproof$(printf " <%s>" "$@")" >>"$CALLS"
[ "$1" = trade ] || [ "$1" = report ] && exit 0
echo "s REFUTED"
exit 1' >"$project/build/slipproof"
chmod -R a+rwX "$scratch"
chmod a+x "$scratch/bin/"* "$project/run" "$project/build/slipproof"

as_user=()
((EUID)) || as_user=(setpriv --reuid=65534 --regid=65534 --clear-groups)
export CALLS="$scratch/calls" LACKING="" SUDO_WORKS=""
call() {  # ARGUMENTS of run; leaves output, calls, code
  : >"$CALLS"
  chmod a+rw "$CALLS"
  code=0
  output=$(cd / && PATH="$scratch/bin:$PATH" "$@" 2>&1) || code=$?
  calls=$(cat "$CALLS")
}
expect() {  # CODE PATTERN of calls, PATTERN of output
  # shellcheck disable=SC2053
  [[ $code == "$1" && $calls == $2 && $output == $3 ]] || {
    printf 'line %s: expected exit code %s, calls %s, output %s\ngot %s\ncalls:\n%s\noutput:\n%s\n' \
      "${BASH_LINENO[0]}" "$1" "$2" "$3" "$code" "$calls" "$output"
    exit 1
  }
}

call "$project/run"
expect 2 '' '*which command*usage:*'
call "$project/run" verfy
expect 2 '' '*unknown command: verfy*usage:*'
call "$project/run" test --most
expect 2 '' '*--all*--most*'
call "$project/run" help
expect 0 '' 'usage:*'

# All papers, with a page for each.
call "$project/run" verify
expect 1 '*slipproof <verify> <--report> <build/report> <--trade> <build/report/trade.json> <proofs>' 's REFUTED'
# Nothing missing: no apt-get. The verdict's exit code comes through, the output is kept.
call "$project/run" verify --samples 5 'a b'
expect 1 'cmake --preset ci*cmake --build --preset ci*slipproof <trade> <--quick> <--json>*slipproof <verify> <--report> <build/report/index.html> <--trade> <build/report/trade.json> <--samples> <5> <a b>' 's REFUTED'
[[ $(cat "$project/build/report/verify.txt") == 's REFUTED' ]]
# The checker that is proved right is asked where it is built.
cp "$project/build/slipproof" "$project/build/slipproof-check-verified"
call "$project/run" verify --samples 5
expect 1 '*slipproof <verify> *<--second-checker> <build/slipproof-check-verified> <--samples> <5>' 's REFUTED'
rm "$project/build/slipproof-check-verified"
# No report is asked for where there are no verdicts, and no second one where one is asked for.
for mode in --mutants --coverage --help; do
  call "$project/run" verify --samples 5 "$mode"
  expect 1 "*slipproof <verify> <--samples> <5> <$mode>" 's REFUTED'
  [[ $calls != *'<trade>'* ]]
done
call "$project/run" verify --report 'my report.html'
expect 1 '*slipproof <verify> <--report> <my report.html>' 's REFUTED'
call "$project/run" verify --trade=mine.json
expect 1 '*slipproof <verify> <--report> <build/report/index.html> <--trade=mine.json>' 's REFUTED'
[[ $calls != *'<trade>'* ]]
call "$project/run" test
expect 0 'cmake*ctest --preset release*cmake*ctest --preset sanitize*' ''
[[ $calls != *apt-get* ]]

# Missing, and nobody to install it: everything missing is named, nothing is built.
LACKING='cmake libgmp-dev:known'
call "${as_user[@]}" "$project/run" test
expect 1 'sudo -n true' '*missing*apt-get install --no-install-recommends cmake libgmp-dev'

SUDO_WORKS=yes
call "${as_user[@]}" "$project/run" test
expect 0 '*sudo*apt-get*update*sudo*apt-get*install --no-install-recommends cmake libgmp-dev?cmake --preset*' '*installing*'

# The program that the first command builds reads every format that the README names.
LACKING=libhdf5-dev
call "${as_user[@]}" "$project/run" verify
expect 1 '*install --no-install-recommends libhdf5-dev?cmake --preset*' '*installing libhdf5-dev*'
# What only tests need is left to the second one.
LACKING=pybind11-dev
call "${as_user[@]}" "$project/run" verify
[[ $calls != *apt-get* ]]
call "${as_user[@]}" "$project/run" test
expect 0 '*install --no-install-recommends pybind11-dev?cmake --preset*' '*installing pybind11-dev*'

# Engines: those of Debian are installed, those of npm where there is an npm; without it the others are asked.
mkdir -p "$project/cases/engines"
echo '{}' | tee "$project/cases/engines/package.json" >"$project/cases/engines/package-lock.json"
echo 'import sys; print("asked", *sys.argv[1:])' >"$project/cases/engines/ask.py"
echo "$note"'exit 1' >"$scratch/bin/npm"
chmod a+rwx "$scratch/bin/npm"
LACKING=libdart-dev
call "${as_user[@]}" "$project/run" engines planck
expect 0 '*install --no-install-recommends libdart-dev?cmake --preset ci*npm ci *' '*could not install its engines*asked --slipproof build/slipproof *planck'
echo "$note" >"$scratch/bin/npm"
LACKING=
call "$project/run" engines
expect 0 'cmake --preset ci*npm ci *<report> <cases/engines>*' 'asked --slipproof build/slipproof *the table is */build/report/engines/index.html'

# Wheels: what is missing is installed, then built and tested.
mkdir -p "$project/src/faces/python/wheel"
for script in build test; do echo "$note" >"$project/src/faces/python/wheel/$script.sh"; done
chmod a+rx "$project/src/faces/python/wheel/"*
LACKING=patchelf
call "${as_user[@]}" "$project/run" wheel
expect 0 '*install --no-install-recommends patchelf?build.sh build-wheel?test.sh build-wheel' '*installing patchelf*'
LACKING=
call "$project/run" wheel twice
expect 2 '' '*wheel takes nothing, not: twice*'

# A release is of a commit, has its time, and is put together when its parts are built and tested.
mkdir -p "$project/src/faces/"{explorer,site,package} "$project/build-explorer"
for script in explorer site; do echo "$note" >"$project/src/faces/$script/build.sh"; done
echo 'import os; print("packed at", os.environ["SOURCE_DATE_EPOCH"])' >"$project/src/faces/package/release.py"
echo '#!/bin/sh
case $1 in status) echo "${CHANGED-}" ;; log) echo 17 ;; esac' >"$scratch/bin/git"
touch "$project/build-explorer/explorer.html"
chmod -R a+rwX "$project"
chmod a+rx "$scratch/bin/git" "$project/src/faces/"*/build.sh
call "${as_user[@]}" "$project/run" release
expect 0 'build.sh build-explorer*build.sh build-wheel*test.sh build-wheel*build.sh build build/site*cmake --build --preset ci * slipproof_c slipproof_python' '*packed at 17'
call "${as_user[@]}" env CHANGED=' M run' "$project/run" release
expect 1 '' '*not committed*'
call "$project/run" release now
expect 2 '' '*release takes nothing, not: now*'

LACKING=coq
call "${as_user[@]}" "$project/run" test
expect 0 'cmake --preset*' ''
[[ $calls != *apt-get* ]]
call "${as_user[@]}" "$project/run" test --all
expect 0 '*install --no-install-recommends coq?cmake --preset*ctest --test-dir build*ctest --preset clang*run-clang-tidy-14 *' '*installing coq*'
