#!/bin/sh
# notebook.sh NOTEBOOK SCRATCH: runs the notebook from beginning to end, where Jupyter and matplotlib are installed.
set -eu
/usr/bin/python3 -c 'import nbconvert, ipykernel, matplotlib, pandas' 2>/dev/null || exit 77
/usr/bin/python3 -m nbconvert --to notebook --execute --ExecutePreprocessor.kernel_name=python3 \
  --output-dir "$2" --output executed.ipynb "$1"
grep -q '"image/png"' "$2/executed.ipynb"
