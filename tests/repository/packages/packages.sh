#!/usr/bin/env bash
# packages.sh BUILD SOURCES: the Debian packages of a build as lintian sees them; then in a bare Debian 12, which knows
# nothing of this machine but where its packages come from: installed, used, and removed without leaving anything.
set -euo pipefail
skip() {
  echo "skipped: $1"
  exit 77
}
for tool in debootstrap lintian cpack; do command -v "$tool" >/dev/null || skip "$tool is not installed"; done
((EUID == 0)) || skip "a chroot needs root"
[[ ${OF_ITS_OWN-} ]] || exec env OF_ITS_OWN=yes unshare --mount "$0" "$@"  # what is mounted ends with the test
build=$1 sources=$2
scratch=$(mktemp -d)
trap 'umount "$bare/proc" 2>/dev/null || true; rm -rf "$scratch"' EXIT
bare=$scratch/bare
fail() {
  echo "failed: $1" >&2
  exit 1
}

cpack --config "$build/CPackConfig.cmake" -G DEB -B "$scratch/packages" >"$scratch/cpack.log" || fail "$(cat "$scratch/cpack.log")"
rm -rf "$scratch/packages/_CPack_Packages"
packages=("$scratch"/packages/*.deb)
names=()
for package in "${packages[@]}"; do names+=("$(dpkg-deb --field "$package" Package)"); done
echo "packages: ${names[*]}"
for name in slipproof libslipproof0 libslipproof-dev; do [[ " ${names[*]} " == *" $name "* ]] || fail "there is no $name"; done
lintian --allow-root --fail-on error "${packages[@]}" || fail "lintian"

mirror=$(apt-get indextargets --format '$(ORIGIN) $(CODENAME) $(REPO_URI)' | awk '$1 == "Debian" && $2 == "bookworm" { print $3; exit }')
[[ $mirror ]] || skip "apt knows no Debian 12"
debootstrap --variant=minbase bookworm "$bare" "$mirror" >"$scratch/debootstrap.log" || fail "$(tail "$scratch/debootstrap.log")"
apt-config dump | grep -E '^Acquire::(https?|ftp)::' >"$bare/etc/apt/apt.conf.d/99-of-the-host" || true
mount -t proc proc "$bare/proc"
mkdir "$bare/new"
cp "${packages[@]}" "$sources/tests/repository/install/consumer/main.c" "$bare/new"
inside() { chroot "$bare" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
quietly() { inside "$@" >"$scratch/log" 2>&1 || fail "$*: $(tail -20 "$scratch/log")"; }
files() { (cd "$bare" && find . -xdev -path ./proc -prune -o -path ./new -prune -o -path ./var/lib/dpkg -prune -o -path ./var/log -prune -o -path ./var/cache -prune -o -print | sort); }
install() { quietly sh -c 'apt-get -q -y install --no-install-recommends /new/*.deb'; }

quietly apt-get -q update
quietly apt-get -q -y install --no-install-recommends gcc libc6-dev pkg-config python3
# What they depend on stays: the files before are those beside which nothing may be left.
install
quietly dpkg --purge "${names[@]}"
files >"$scratch/before"
grep slipproof "$scratch/before" && fail "these were left by the first removal"
install

expect() {  # PATTERN COMMAND...
  local output
  output=$(inside "${@:2}" 2>&1) || fail "${*:2}: $output"
  # shellcheck disable=SC2053
  [[ $output == $1 ]] || fail "${*:2} printed: $output"
}
expect '' dpkg --verify "${names[@]}"
expect '*s SOLVED modes*' slipproof solve /usr/share/slipproof/cases/touring-bicycle.toml
expect '*s SOLVED motions 2 *' slipproof solve /usr/share/slipproof/cases/mechanisms/scenes/block-on-incline.toml
expect '*s VERIFIED*' slipproof verify --only A5.1 --samples 20
expect '*s ACCEPTED*' slipproof-check /usr/share/slipproof/proofs/rozenblat-yashin
expect '' sh -c 'cc -std=c99 $(pkg-config --cflags slipproof) -o /new/main /new/main.c $(pkg-config --libs slipproof)'
expect 'stick/stick with ax = 0*' /new/main /usr/share/slipproof/cases/mechanisms/scenes/block-on-incline.toml
if [[ " ${names[*]} " == *" python3-slipproof "* ]]; then
  expect 'certified' python3 -c 'import slipproof; print(slipproof.certify([[2, 1], [1, 2]], [-4, -5], [1, 2]).verdict)'
fi

rm "$bare/new/main"
quietly dpkg --purge "${names[@]}"
files >"$scratch/after"
diff "$scratch/before" "$scratch/after" || fail "removing the packages leaves or takes these"
echo "installed, used, and removed"
