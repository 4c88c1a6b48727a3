#!/usr/bin/env bash
# release.sh PROJECT: the archive that ./run release made, as a user of it sees it, and put together a second time. Exit code
# 77: skipped.
set -euo pipefail
project=$1
fail() {
  echo "failed: $1" >&2
  exit 1
}
archives=("$project"/build-release/slipproof-*-release.tar.gz)
[[ -e ${archives[0]} ]] || { echo "skipped: there is no release (./run release)"; exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
tar -C "$scratch" -xf "${archives[0]}"
cd "$scratch"/slipproof-*-release

sha256sum --quiet --check SHA256SUMS || fail "checksums"
diff <(cut -c67- SHA256SUMS | sort) <(find . -type f ! -name SHA256SUMS -printf '%P\n' | sort) || fail "SHA256SUMS does not list these"
for file in site/index.html site/stand.html site/papers/index.html site/pages/index.html packages/slipproof_*.deb packages/libslipproof0_*.deb \
  packages/libslipproof-dev_*.deb wheel/slipproof-*.whl source/slipproof-*.tar.gz READ_ME.txt; do
  [[ -e $file ]] || fail "there is no $file"
done
dpkg-deb --contents packages/slipproof_*.deb | grep 'share/slipproof/build-explorer/explorer.html' >/dev/null || fail "the package has no explorer"

version=$(sed -n 's/^project(slipproof VERSION \([0-9.]*\).*/\1/p' "$project/CMakeLists.txt")
for file in wheel/slipproof-"$version"-*.whl "source/slipproof-$version.tar.gz" packages/slipproof_"$version"*.deb; do
  [[ -e $file ]] || fail "there is no $file: another version"
done

# The sources are those of the commit, and what was built from what is said of each part.
commit=$(python3 -c 'import json; print(json.load(open("BUILT_FROM.json"))["commit"])')
mkdir "$scratch/source"
tar -C "$scratch/source" --strip-components=1 -xf source/slipproof-*.tar.gz
diff <(cd "$scratch/source" && find . ! -type d -printf '%P\n' | sort) <(git -C "$project" ls-tree -r --name-only "$commit" | sort) || fail "sources"
python3 - <<'PYTHON' || fail "BUILT_FROM.json"
import json, os
parts = json.load(open("BUILT_FROM.json"))["parts"]
assert set(parts) == {"source", "packages", "wheel", "site"}
for name, part in parts.items():
    assert part["files"] and all(os.path.exists(file) for file in part["files"]), name
    assert name == "source" or (part["compilers"] and part["packages"]), name
for name, source in (("wheel", "flint_"), ("site", "llvm-toolchain-16_")):
    assert any(one["file"].startswith(source) for one in parts[name]["debian_sources"]), name
PYTHON

[[ -z $(git -C "$project" status --porcelain) && $(git -C "$project" rev-parse HEAD) == "$commit" ]] || {
  echo "not put together again: the files are no longer those of the release's commit"
  exit
}
SOURCE_DATE_EPOCH=$(git -C "$project" log -1 --format=%ct) python3 -B "$project/src/faces/package/release.py" "$scratch/again"
cmp "${archives[0]}" "$scratch"/again/slipproof-*-release.tar.gz || fail "the same parts give other bytes"
echo "the same parts give the same bytes"
