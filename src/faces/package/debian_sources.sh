# shellcheck shell=bash disable=SC2154
# Sourced by scripts that compile what Debian has no fitting archive of from Debian's source packages. $folder holds what
# they make: sources/, the archives in installed/lib, the headers in installed/include, and done/, which names the steps
# that are done.

# The source packages, by the mirror that the machine has for its binary ones; nothing of the system's is changed.
fetch() {  # PACKAGE...
  mkdir -p "$folder/apt/lists/partial" "$folder/sources"
  apt-get indextargets --format 'deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $(SITE) $(RELEASE) $(COMPONENT)' \
    'Created-By: Packages' 'Origin: Debian' | sort -u >"$folder/apt/sources.list"
  local apt=(apt-get -q -y -o "Dir::Etc::sourcelist=$folder/apt/sources.list" -o Dir::Etc::sourceparts=- -o "Dir::State::Lists=$folder/apt/lists"
    -o "Dir::Cache::srcpkgcache=" -o "Dir::Cache::pkgcache=" -o APT::Sandbox::User=)
  "${apt[@]}" update
  (cd "$folder/sources" && "${apt[@]}" source --download-only "$@")
}

unpack() {  # PACKAGE NAME: into sources/NAME
  [[ -d $folder/sources/$2 ]] || (cd "$folder/sources" && dpkg-source -x "$1"_*.dsc "$2" >/dev/null)
}

# What numbers, their polynomials and factors of these need.
flint_folders=(fmpz fmpz_vec fmpz_poly fmpz_factor fmpz_poly_factor fmpz_poly_mat fmpz_mat fmpz_lll fmpz_mod fmpz_mod_poly fmpz_mpoly
  fmpz_mpoly_factor fmpz_mod_mpoly fmpq fmpq_vec fmpq_mat fmpq_poly fmpq_mpoly fmpq_mpoly_factor ulong_extras
  long_extras double_extras nmod_vec nmod_mat nmod_poly nmod_poly_factor nmod_mpoly nmod_mpoly_factor n_poly mpoly mpn_extras fft
  perm d_vec d_mat mpf_vec mpf_mat mpfr_vec mpfr_mat thread_pool thread_support
  # The greatest common divisors and factors of polynomials in several variables call these, too.
  fmpz_mod_vec fmpz_mod_mat fmpz_mod_mpoly_factor fq_nmod fq_nmod_vec fq_nmod_mat fq_nmod_poly fq_nmod_poly_factor
  fq_nmod_mpoly fq_nmod_mpoly_factor fq_nmod_embed fq_zech fq_zech_vec fq_zech_mat fq_zech_poly fq_zech_poly_factor fq_zech_mpoly
  fq_zech_mpoly_factor aprcl qsieve)
# flint_of_debian BITS: libflint.a for words of 32 or 64 bits. The caller has these functions: flint_config prints
# flint-config.h, compile FILE... compiles into the present folder, archive NAME FILE... makes libNAME.a.
flint_of_debian() {
  unpack flint flint
  cd "$folder/sources/flint" || return
  cp fmpz-conversions-single.in fmpz-conversions.h
  cp "fft_tuning$1.in" fft_tuning.h
  cp fmpz/link/fmpz_single.c fmpz/fmpz.c
  flint_config >flint-config.h
  mkdir -p "$folder/installed/include/flint"
  cp ./*.h "$folder/installed/include/flint/"
  rm -rf "$folder/flint"
  compile_flint top "$PWD"/{printf,fprintf,sprintf,scanf,fscanf,sscanf,clz_tab,memory_manager,exception,hashmap,inlines}.c
  local part
  for part in "${flint_folders[@]}"; do compile_flint "$part" "$PWD/$part"/*.c; done
  # FLINT asks its table of Conway's polynomials before it looks for an irreducible one; the table would take 0.9 MB as text,
  # and is left empty.
  echo 'int flint_conway_polynomials[] = {0};' >"$folder/flint/conway.c"
  compile_flint conway "$folder/flint/conway.c"
  archive flint "$folder"/flint/*/*.o
}
compile_flint() {  # NAME FILE...: one call for each folder; there are thousands of files
  mkdir -p "$folder/flint/$1"
  (cd "$folder/flint/$1" && shift && compile "$@")
}

once() {  # STEP: unless it was done
  [[ -e $folder/done/$1 ]] && return
  echo "${0##*/}: $1" >&2
  ("$1") >"$folder/$1.log" 2>&1 &  # not before ||, where set -e is off
  wait $! || {
    tail -n 30 "$folder/$1.log" >&2
    echo "${0##*/}: $1 failed; $folder/$1.log has all that it printed" >&2
    exit 1
  }
  touch "$folder/done/$1"
}
