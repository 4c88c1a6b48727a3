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

# Debian's clang in place of emcc, whose Python takes longer than a small file. What it links is only tried by configure.
cc=$folder/cc
write_cc() {
  printf '%s\n' '#!/bin/sh' "exec clang-14 --target=wasm32-unknown-emscripten --sysroot=$emscripten/cache/sysroot -D__EMSCRIPTEN__ -O2 -w \
    -nostdlib -Wl,--no-entry,--allow-undefined \"\$@\"" >"$cc"
  chmod +x "$cc"
}
# FLINT's headers, which take longer than most of its files, are compiled once, but for files that define what these look at.
compile() {  # FILE...
  local flags=("-I$folder/sources/flint" "-I$folder/installed/include") header
  if [[ ! -e $folder/flint.pch ]]; then
    for header in stdio stdlib string math gmp mpfr {fmpz,fmpq,fmpz_mod,nmod,fq_nmod,fq_zech}_mpoly_factor fmpz_lll aprcl qsieve; do
      echo "#include <$header.h>"
    done >"$folder/flint_headers.h"
    "$cc" "${flags[@]}" -c -x c-header "$folder/flint_headers.h" -o "$folder/flint.part.pch"
    mv "$folder/flint.part.pch" "$folder/flint.pch"
  fi
  local own='undef ulong|_INLINES_C'
  { grep -LZE "$own" "$@" || true; } | xargs -0 -r -n 20 -P "$jobs" "$cc" "${flags[@]}" -include-pch "$folder/flint.pch" -c
  { grep -lZE "$own" "$@" || true; } | xargs -0 -r -n 20 -P "$jobs" "$cc" "${flags[@]}" -c
}
background=()
in_parallel() {  # COMMAND...: in the background, at most $jobs at once; then wait_for_all
  while (($(jobs -rp | wc -l) >= jobs)); do wait -n; done
  "$@" &
  background+=($!)
}
wait_for_all() {  # fails if one of them did
  local one
  for one in "${background[@]}"; do wait "$one"; done
  background=()
}

# Without make and libtool, which start four processes for each of its small files.
gmp() {
  unpack gmp gmp
  cd "$folder/sources/gmp"
  mkdir -p doc  # Debian leaves the manual out
  printf 'all install:\n' >doc/Makefile.in
  ./configure --host=none --disable-assembly --disable-shared --disable-cxx CC="$cc" CC_FOR_BUILD=gcc CFLAGS=
  make fac_table.h fib_table.h mpn/fib_table.c mp_bases.h mpn/mp_bases.c trialdivtab.h mpn/jacobitab.h mpn/perfsqr.h
  rm -rf "$folder/gmp"
  mkdir -p "$folder/gmp" "$folder/installed/include"
  local file part
  for file in mpn/*.c; do
    in_parallel "$cc" -DHAVE_CONFIG_H -D__GMP_WITHIN_GMP "-DOPERATION_$(basename "${file%.c}")" -I. -Impn -c "$file" -o "$folder/gmp/${file//\//_}.o"
  done
  for part in . mpz mpq mpf rand printf; do
    mkdir -p "$folder/gmp/$part"
    (cd "$folder/gmp/$part" && find "$folder/sources/gmp/$part" -maxdepth 1 -name '*.c' ! -name 'gen-*' ! -name 'tal-[dn]*' ! -name 'ob*' -print0 |
      xargs -0 -n 20 -P "$jobs" "$cc" -DHAVE_CONFIG_H -D__GMP_WITHIN_GMP "-I$folder/sources/gmp" -c)
  done
  wait_for_all
  cp gmp.h "$folder/installed/include/"
  archive gmp "$folder"/gmp/*.o "$folder"/gmp/*/*.o
}

mpfr() {
  unpack mpfr4 mpfr
  cd "$folder/sources/mpfr"
  ./configure --host=none --disable-shared --disable-thread-safe "--with-gmp=$folder/installed" CC="$cc" CFLAGS=
  mkdir -p "$folder/mpfr"
  local defined=()  # it has no config.h; and some files are parts of others
  eval "defined=($(sed -n 's/^DEFS = //p' src/Makefile))"
  (cd "$folder/mpfr" && find "$folder/sources/mpfr/src" -name '*.c' ! -name '*_extracted.c' ! -name round_raw_generic.c ! -name jyn_asympt.c -print0 |
    xargs -0 -n 20 -P "$jobs" "$cc" "${defined[@]}" "-I$folder/sources/mpfr" "-I$folder/sources/mpfr/src" "-I$folder/installed/include" -c)
  cp src/mpfr.h "$folder/installed/include/"
  archive mpfr "$folder"/mpfr/*.o
}

flint_config() {
  local setting
  for setting in BLAS TLS FENV PTHREAD GC CPUSET; do echo "#define FLINT_USES_$setting 0"; done
  printf '#define FLINT_%s 0\n' BIG_ENDIAN REENTRANT WANT_ASSERT
  echo '#define FLINT_DLL'
}
flint() {
  rm -f "$folder/flint.pch"  # of a run that was stopped
  flint_of_debian 32
}

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
    in_parallel em++ "${flags[@]}" -w -DNDEBUG -DLIBCXX_BUILDING_LIBCXXABI=1 -D_LIBCPP_BUILDING_LIBRARY \
      -D_LIBCPP_DISABLE_VISIBILITY_ANNOTATIONS -I. -c "$file.cpp" -o "$folder/libcxx-objects/${file//\//_}.o"
    objects+=("$folder/libcxx-objects/${file//\//_}.o")
  done
  wait_for_all
  archive c++16 "${objects[@]}"
}

pugixml() {
  unpack pugixml pugixml
  em++ "${flags[@]}" -c "$folder/sources/pugixml/src/pugixml.cpp" -o "$folder/pugixml.o"
  archive pugixml "$folder/pugixml.o"
}

# What solve, map and certify need, in the order of the rooms, one file a wing as in the preset ci; unless neither the wing
# nor those that it includes have changed.
wings=("$here/missing")
wing() {  # WING PATTERN: compiles WING.cpp, which includes the sources of its rooms that match
  local room
  wings+=("$src/$1")
  [[ ! -e $folder/$1.o || $(find "${wings[@]}" -name '*.?pp' -newer "$folder/$1.o" -print -quit) ]] || return 0
  { for room in $(sed -n "s|^\($1/[a-z_]*\)[*]*$|\1|p" "$src/layers.txt"); do
    find "$src/$room" -name '*.cpp' | sort | sed "s|^$src/||" | grep -E "$2" || true
  done; } | sed 's|.*|#include "&"|' >"$folder/$1.cpp"
  in_parallel compile_own "$folder/$1.cpp" "$1"
}
compile_own() {  # FILE NAME
  em++ "${flags[@]}" "${own_flags[@]}" -c "$1" -o "$folder/$2.part.o"
  mv "$folder/$2.part.o" "$folder/$2.o"
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
  wing base '^base/(algebra|expression|input|number|rounding)/|^base/output/json|^base/files/(json_tree|words)|^base/parallel/failure'
  wing mechanics '^mechanics/(elements|kernel|mechanism|points|bodies|states|reading|scene|impact|family|lines|planes)/|^mechanics/checks/kinds'
  wing floating '^floating/batch/tier'
  wing contact '^contact/problem/|^contact/formats/(json_problem|read_json_problem|problem_check)|^contact/judge/(all_solutions|small|verdict)'
  wing report '^report/(markup|document|values|phase|picture/(arrows|frame|labels))/|^report/picture/(drawing|me|mo|p|s)[a-z_]*[.]cpp|velocities/|scenes/mechanism|explorer/portable'
  wing records '^records/(record|reading)/|^records/judging/(answer|exact_judge|explanation|forces_near|judge)|^records/problems/problem_(judge|reader)|^records/certify/output_line'
  for file in "$here"/*.cpp "$here/missing/space_memory.cpp" "$folder/shipped.cpp"; do
    in_parallel compile_own "$file" "$(basename "$file" .cpp)"
  done
  wait_for_all
  # Without -O2 wasm-opt is left out, which takes a minute and makes no answer faster.
  em++ -fwasm-exceptions -O1 "$folder"/{main,explorer,pasted,space_memory,records,report,contact,floating,mechanics,base,shipped}.o "$folder"/installed/lib/lib{pugixml,flint,mpfr,gmp,c++16}.a \
    -nostdlib++ -lc++abi -lunwind-except -o "$folder/library.js" --no-entry \
    -sMODULARIZE=1 -sEXPORT_NAME=Library -sALLOW_MEMORY_GROWTH=1 -sENVIRONMENT=web,worker,node \
    -sEXPORTED_FUNCTIONS=_slipproof_open,_slipproof_answer -sEXPORTED_RUNTIME_METHODS=cwrap
}

page() {
  local part
  sed -E "s/@(style|compiled|library|asking|words|moving|pasted|script)@/\n@\1@\n/" "$here/page.html.in" | while IFS= read -r line; do
    case $line in
      @style@) cat "$here/style.css" ;;
      @compiled@) gzip -9n <"$folder/library.wasm" | base64 -w 0 ;;
      @library@) cat "$folder/library.js" ;;
      @asking@ | @words@ | @moving@ | @pasted@ | @script@) part=${line//@/}; cat "$here/$part.js" ;;
      *) printf '%s\n' "$line" ;;
    esac
  done >"$folder/explorer.part"
  mv "$folder/explorer.part" "$folder/explorer.html"
}

sources() { fetch gmp mpfr4 flint pugixml llvm-toolchain-16; }

mkdir -p "$folder/done" "$folder/installed/lib"
write_cc
for step in sources gmp mpfr flint libcxx pugixml; do once "$step"; done
changed=$(find "$src/base" "$src/mechanics" "$src/contact" "$src/records" "$src/report" "$here"/*.?pp "$here/build.sh" "$src/../cases/mechanisms" -newer "$folder/done/library" 2>/dev/null | head -1) || true
[[ -z $changed ]] || rm -f "$folder/done/library"
once library
page
echo "build.sh: $folder/explorer.html, $(stat -c %s "$folder/explorer.html") bytes" >&2
