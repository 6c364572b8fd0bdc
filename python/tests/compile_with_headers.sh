#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The sources of the module compile with the headers of another pybind11, without a warning:
#   compile_with_headers.sh <source tree> <folder with pybind11/pybind11.h> <compiler> <interpreter> <folder of Eigen>
set -euo pipefail
root=$1 headers=$2 compiler=$3 python=$4 eigen=$5
[ -f "$headers/pybind11/pybind11.h" ] || { echo "no pybind11/pybind11.h in $headers" >&2; exit 1; }
of_python=$("$python" -c 'import sysconfig; print(sysconfig.get_path("include"))')
printf '%s\0' "$root"/python/src/*.cpp | xargs -0 -n 1 -P "$(nproc)" "$compiler" -std=c++20 -fvisibility=hidden -fsyntax-only -Wall -Wextra -Werror \
  -I"$root/src" -I"$root/include" -isystem "$headers" -isystem "$of_python" -isystem "$eigen"
