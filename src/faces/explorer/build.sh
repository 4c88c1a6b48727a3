#!/usr/bin/env bash
# build.sh FOLDER: compiles the library to WebAssembly with Debian's emscripten, and makes FOLDER/explorer.html of it.
# GMP, MPFR, FLINT, pugixml and libc++ 16 are compiled from Debian's sources: emscripten's own libc++ 13 lacks much of
# C++20. Its compiler, clang 14, and its libc, libc++abi and unwinder are used as they are. What is there is kept: after a
# change only the library is compiled again.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
src=$(cd "$here/../.." && pwd)
mkdir -p "$1"
folder=$(cd "$1" && pwd)
jobs=${JOBS:-$(nproc)}
emscripten=/usr/share/emscripten
# Node.js from elsewhere does not look for Debian's packages.
export NODE_PATH=/usr/share/nodejs
version=$(sed -n 's/^project(slipproof VERSION \([0-9.]*\).*/\1/p' "$src/../CMakeLists.txt")

source "$src/faces/package/debian_sources.sh"

gmp() {
  unpack gmp gmp
  cd "$folder/sources/gmp"
  mkdir -p doc  # Debian leaves the manual out
  printf 'all install:\n' >doc/Makefile.in
  emconfigure ./configure --host=none --disable-assembly --disable-shared --disable-cxx CC_FOR_BUILD=gcc CFLAGS=-O2 \
    "--prefix=$folder/installed"
  emmake make -j "$jobs" install
}

mpfr() {
  unpack mpfr4 mpfr
  cd "$folder/sources/mpfr"
  emconfigure ./configure --host=none --disable-shared --disable-thread-safe "--with-gmp=$folder/installed" CFLAGS=-O2 \
    "--prefix=$folder/installed"
  emmake make -j "$jobs" -C src install
}

flint_config() {
  local setting
  for setting in BLAS TLS FENV PTHREAD GC CPUSET; do echo "#define FLINT_USES_$setting 0"; done
  printf '#define FLINT_%s 0\n' BIG_ENDIAN REENTRANT WANT_ASSERT
  echo '#define FLINT_DLL'
}
compile() {  # FILE...
  clang-14 --target=wasm32-unknown-emscripten "--sysroot=$emscripten/cache/sysroot" -O2 -w -D__EMSCRIPTEN__ \
    "-I$folder/sources/flint" "-I$folder/installed/include" -c "$@"
}
flint() { flint_of_debian 32; }

archive() {  # NAME FILE...; names of members may be alike
  rm -f "$folder/installed/lib/lib$1.a"
  llvm-ar-14 qcs "$folder/installed/lib/lib$1.a" "${@:2}"
}

flags=(-std=c++20 -O2 -fwasm-exceptions -nostdinc++ -isystem "$here/missing" -isystem "$folder/libcxx"
  -isystem /usr/lib/llvm-16/include/c++/v1 -isystem "$emscripten/system/lib/libcxxabi/include")

libcxx() {
  cd "$folder/sources"
  tar xf llvm-toolchain-16_*.orig.tar.xz --wildcards '*/libcxx/src/*'
  mkdir -p "$folder/libcxx" "$folder/libcxx-objects"
  printf '#define %s\n' '_LIBCPP_ABI_VERSION 1' '_LIBCPP_ABI_NAMESPACE __1' _LIBCPP_HAS_MUSL_LIBC _LIBCPP_HAS_THREAD_API_PTHREAD \
    _LIBCPP_HAS_NO_VENDOR_AVAILABILITY_ANNOTATIONS '_LIBCPP_ENABLE_ASSERTIONS_DEFAULT 0' >"$folder/libcxx/__config_site"
  cd llvm-toolchain-16_*/libcxx/src
  local file objects=()
  for file in algorithm charconv exception filesystem/operations filesystem/directory_iterator functional hash ios \
    ios.instantiations iostream locale memory mutex mutex_destructor new optional random ryu/d2fixed ryu/d2s ryu/f2s \
    shared_mutex stdexcept string system_error thread typeinfo chrono condition_variable variant vector verbose_abort; do
    em++ "${flags[@]}" -w -DNDEBUG -DLIBCXX_BUILDING_LIBCXXABI=1 -D_LIBCPP_BUILDING_LIBRARY \
      -D_LIBCPP_DISABLE_VISIBILITY_ANNOTATIONS -I. -c "$file.cpp" -o "$folder/libcxx-objects/${file//\//_}.o"
    objects+=("$folder/libcxx-objects/${file//\//_}.o")
  done
  archive c++16 "${objects[@]}"
}

pugixml() {
  unpack pugixml pugixml
  em++ "${flags[@]}" -c "$folder/sources/pugixml/src/pugixml.cpp" -o "$folder/pugixml.o"
  archive pugixml "$folder/pugixml.o"
}

# What solve and map need, in the order of the rooms, one file a wing as in the preset ci; unless neither the wing nor those
# that it includes have changed.
wings=("$here/missing")
wing() {  # WING PATTERN: compiles WING.cpp, which includes the sources of its rooms that match
  local room
  wings+=("$src/$1")
  [[ ! -e $folder/$1.o || $(find "${wings[@]}" -name '*.?pp' -newer "$folder/$1.o" -print -quit) ]] || return 0
  { for room in $(sed -n "s|^\($1/[a-z_]*\)[*]*$|\1|p" "$src/layers.txt"); do
    find "$src/$room" -name '*.cpp' | sort | sed "s|^$src/||" | grep -E "$2" || true
  done; } | sed 's|.*|#include "&"|' >"$folder/$1.cpp"
  em++ "${flags[@]}" "${own_flags[@]}" -c "$folder/$1.cpp" -o "$folder/$1.part.o"
  mv "$folder/$1.part.o" "$folder/$1.o"
}
own_flags=(-Wall -Wextra -DSLIPPROOF_SERIAL -DNDEBUG -DFMT_HEADER_ONLY -DSLIPPROOF_VERSION="\"$version\"" -ffp-contract=off "-I$src"
  -isystem "$folder/installed/include" -isystem "$folder/headers")

library() {
  local file header
  mkdir -p "$folder/headers"
  for header in boost eigen3/Eigen fmt nlohmann fast_float pugixml.hpp pugiconfig.hpp toml++; do
    ln -sfn "/usr/include/$header" "$folder/headers/$(basename "$header")"
  done
  { sed '/@SLIPPROOF_SHIPPED_MECHANISMS@/,$d' "$src/mechanics/reading/shipped_texts.cpp.in"
    for file in "$src"/../cases/mechanisms/*.toml; do
      printf '    {"%s", R"toml(' "$(basename "$file" .toml)"
      cat "$file"
      echo ')toml"},'
    done
    sed -n 's/^@SLIPPROOF_SHIPPED_MECHANISMS@//;T;:a;p;n;ba' "$src/mechanics/reading/shipped_texts.cpp.in"; } >"$folder/shipped.cpp"
  em++ "${flags[@]}" "${own_flags[@]}" -c "$folder/shipped.cpp" -o "$folder/shipped.o"
  wing base '^base/(algebra|expression|input|number|rounding)/|^base/output/json'
  wing mechanics '^mechanics/(elements|kernel|mechanism|points|bodies|reading|scene|planes)/'
  wing contact '^contact/problem/'
  wing report '^report/(markup|document|values|picture|phase)/|scenes/mechanism|explorer/portable'
  for file in main explorer; do em++ "${flags[@]}" "${own_flags[@]}" -c "$here/$file.cpp" -o "$folder/$file.o"; done
  em++ -fwasm-exceptions -O2 "$folder"/{main,explorer,report,contact,mechanics,base,shipped}.o "$folder"/installed/lib/lib{pugixml,flint,mpfr,gmp,c++16}.a \
    -nostdlib++ -lc++abi -lunwind-except -o "$folder/library.js" --no-entry \
    -sMODULARIZE=1 -sEXPORT_NAME=Library -sSINGLE_FILE=1 -sALLOW_MEMORY_GROWTH=1 -sENVIRONMENT=web,worker,node \
    -sEXPORTED_FUNCTIONS=_slipproof_open,_slipproof_answer -sEXPORTED_RUNTIME_METHODS=cwrap
}

page() {
  local part
  sed -E "s/@(style|library|asking|words|script)@/\n@\1@\n/" "$here/page.html.in" | while IFS= read -r line; do
    case $line in
      @style@) cat "$here/style.css" ;;
      @library@) cat "$folder/library.js" ;;
      @asking@ | @words@ | @script@) part=${line//@/}; cat "$here/$part.js" ;;
      *) printf '%s\n' "$line" ;;
    esac
  done >"$folder/explorer.part"
  mv "$folder/explorer.part" "$folder/explorer.html"
}

sources() { fetch gmp mpfr4 flint pugixml llvm-toolchain-16; }

mkdir -p "$folder/done" "$folder/installed/lib"
for step in sources gmp mpfr flint libcxx pugixml; do once "$step"; done
changed=$(find "$src/base" "$src/mechanics" "$src/contact/problem" "$src/report" "$here"/*.?pp "$here/build.sh" "$src/../cases/mechanisms" -newer "$folder/done/library" 2>/dev/null | head -1) || true
[[ -z $changed ]] || rm -f "$folder/done/library"
once library
page
echo "build.sh: $folder/explorer.html, $(stat -c %s "$folder/explorer.html") bytes" >&2
