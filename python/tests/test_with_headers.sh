#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the module with the headers of another pybind11, as a target of the build tree does, and runs the package's tests
# on it:
#   test_with_headers.sh <build tree> <target> <folder of that package> <interpreter> <folder of python's sources>
# The environment has what the tests need: GRANUM_SOURCE and GRANUM_PROGRAM.
set -euo pipefail
tree=$1 target=$2 package=$3 python=$4 source=$5
cmake --build "$tree" --target "$target"
cp "$source"/granum/*.py "$source"/granum/*.pyi "$source"/granum/py.typed "$package"
"$python" "$source/make_stub.py" "$source/granum" "$package" "$package/__init__.pyi"
PYTHONPATH=$(dirname -- "$package") PYTHONDONTWRITEBYTECODE=1 \
  "$python" -m pytest -q -p no:cacheprovider "$source/tests"
