#!/bin/sh
# format.sh CLANG_FORMAT PROJECT OPTIONS...: clang-format with these options over all C and C++ of the project.
set -eu
clang_format=$1
cd "$2"
shift 2
find src tests cases \( -name '*.hpp' -o -name '*.cpp' -o -name '*.h' -o -name '*.c' \) -exec "$clang_format" --style=file "$@" {} + || {
  echo "Not formatted as .clang-format says: cmake --build build --target format"
  exit 1
}
