#!/bin/sh
# pip.sh PYTHON PROJECT BUILD SCRATCH: pip installs the package without a network, from what is built, into an
# environment of its own, where it gives a verdict; and takes it away again.
set -eu
python=$1 project=$2 build=$3 scratch=$4
rm -rf "$scratch/environment"
"$python" -m venv --system-site-packages --without-pip "$scratch/environment"
cd "$(dirname "$build")"  # the build folder is named relative to where one stands
pip() {
  SLIPPROOF_BUILD=$(basename "$build") "$python" -m pip --disable-pip-version-check -q --python "$scratch/environment/bin/python" "$@"
}
pip install --no-index --no-build-isolation --no-deps "$project/src/faces/python"
found=$("$scratch/environment/bin/python" -I -c '
import slipproof, pathlib
folder = pathlib.Path(slipproof.__file__).parent
assert (folder / "py.typed").exists() and (folder / "_core.pyi").exists()
assert "environment" in str(folder), folder
print(slipproof.__version__, slipproof.certify([[2, 1], [1, 2]], [-5, -6], [4/3, 7/3]).verdict)')
wanted=$(sed -n 's/^project(slipproof VERSION \([0-9.]*\).*/\1/p' "$project/CMakeLists.txt")
[ "$found" = "$wanted certified" ] || { echo "the installed package prints: $found"; exit 1; }
# Its plugin of pytest is found by itself, and asking for it as well is no mistake.
printf 'def test_plugin(assert_certified):\n    assert_certified([[1]], [-1], [1])\n' >"$scratch/test_plugin.py"
for plugin in "" "-p slipproof.testing"; do
  # shellcheck disable=SC2086
  (cd "$scratch" && "$scratch/environment/bin/python" -IB -m pytest -q -p no:cacheprovider --rootdir "$scratch" -c /dev/null $plugin test_plugin.py)
done
pip uninstall -y slipproof
! "$scratch/environment/bin/python" -I -c 'import slipproof' 2>/dev/null || { echo "it is still there"; exit 1; }
