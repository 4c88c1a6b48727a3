#!/bin/sh
# sanitized.sh CMAKE BUILD COMMAND...: builds the module, which is no part of a sanitized build, and runs the tests. The
# build must not have the sanitizer preloaded.
set -eu
cmake=$1 build=$2
shift 2
env -u LD_PRELOAD "$cmake" --build "$build" --target slipproof_python slipproof_cli
exec "$@"
