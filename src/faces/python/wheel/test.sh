#!/usr/bin/env bash
# test.sh FOLDER: installs the wheel in FOLDER into an environment without system packages, and in an empty Debian 12 where
# debootstrap is installed and the user is root; and uses it there.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
folder=$(cd "$1" && pwd)
[[ ${OF_ITS_OWN-} || $EUID != 0 ]] || exec env OF_ITS_OWN=yes unshare --mount "$0" "$@"  # what is mounted ends with the test
scratch=$(mktemp -d)
bare=$scratch/bare
trap 'umount "$bare/proc" 2>/dev/null || true; rm -rf "$scratch"' EXIT
fail() {
  echo "failed: $1" >&2
  exit 1
}
wheel=$(echo "$folder"/slipproof-*.whl)
[[ -e $wheel ]] || fail "$folder has not one wheel"
size=$(stat -c %s "$wheel")
((size <= 5550000)) || fail "$wheel has $size bytes, more than the 5.5 MB that README.md states"
if command -v auditwheel >/dev/null; then  # a second opinion on the tag
  tag=$(sed -E 's/.*-(manylinux_.*)\.whl/\1/' <<<"$wheel")
  auditwheel show "$wheel" | tr '\n' ' ' | grep -qF "platform tag: \"$tag\"" || fail "auditwheel gives $wheel another tag"
  echo "test.sh: auditwheel gives it the same tag, $tag"
fi

mkdir "$scratch/wheels"
cp "$wheel" "$here/check.py" "$here/../../../../cases/ambiguous.toml" "$scratch/wheels"
/usr/bin/python3 "$here/numpy_of_debian.py" "$scratch/wheels"
/usr/bin/python3 -m venv "$scratch/environment"
install=(-m pip --isolated --disable-pip-version-check -q install --no-index --find-links)
(cd / && "$scratch/environment/bin/python" "${install[@]}" "$scratch/wheels" slipproof)
"$scratch/environment/bin/python" -I -c 'import sys; assert not [p for p in sys.path if "dist-packages" in p]'
# All symbols at once: what is missing shows now.
(cd / && env -i LD_BIND_NOW=1 "$scratch/environment/bin/python" -I "$scratch/wheels/check.py" "$scratch/wheels/ambiguous.toml") || fail "in an environment"
echo "test.sh: works in an environment without system packages"

[[ $EUID == 0 && $(command -v debootstrap) ]] || {
  echo "test.sh: not tested in an empty Debian, which needs debootstrap and root"
  exit
}
mirror=$(apt-get indextargets --format '$(ORIGIN) $(CODENAME) $(REPO_URI)' | awk '$1 == "Debian" && $2 == "bookworm" { print $3; exit }')
debootstrap --variant=minbase bookworm "$bare" "$mirror" >"$scratch/log" 2>&1 || fail "$(tail "$scratch/log")"
apt-config dump | grep -E '^Acquire::(https?|ftp)::' >"$bare/etc/apt/apt.conf.d/99-of-the-host" || true
mount -t proc proc "$bare/proc"
inside() { chroot "$bare" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
quietly() { inside "$@" >"$scratch/log" 2>&1 || fail "$*: $(tail -20 "$scratch/log")"; }
quietly apt-get -q update
quietly apt-get -q -y install --no-install-recommends python3 python3-venv python3-numpy
mv "$scratch/wheels" "$bare/wheels"
rm "$bare"/wheels/numpy-*.whl
quietly python3 -m venv --system-site-packages /environment
quietly /environment/bin/python "${install[@]}" /wheels slipproof
use() { inside LD_BIND_NOW=1 /environment/bin/python -I /wheels/check.py /wheels/ambiguous.toml || fail "in an empty Debian"; }
use
echo "test.sh: works in an empty Debian $(cat "$bare/etc/debian_version"), which has $(inside dpkg-query -f '.\n' -W | wc -l) packages"
quietly apt-get -q -y install --no-install-recommends libudunits2-0
use
