#!/bin/sh
# sanitized.sh CMAKE BUILD LIBRARIES COMMAND...: builds the sanitized module, which nothing else needs, and runs the tests
# with the sanitizer in front of Python's allocator.
set -eu
cmake=$1 build=$2 libraries=$3
shift 3
"$cmake" --build "$build" --target slipproof_python_sanitized
export PYTHONMALLOC=malloc
LD_PRELOAD="$libraries" exec "$@"
