#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# clang-tidy over the library and the program, after the whitelist in .clang-tidy; any finding fails.
# With arguments, over those sources only:  scripts/tidy.sh src/contact/power_law.cpp
set -euo pipefail
export PATH # bash supplies one where the environment has none; cmake needs to see it
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

scripts/setup.sh tidy
cmake --preset dev >/dev/null
if [ $# -eq 0 ]; then
  mapfile -d '' sources < <(find src -name '*.cpp' -print0)
else
  sources=("$@")
fi
printf '%s\0' "${sources[@]}" | xargs -0 -n 1 -P "$(nproc)" clang-tidy -p build/dev --quiet \
  --extra-arg=-Wno-unknown-warning-option # the build is of g++, which knows other warnings
echo "clang-tidy: ${#sources[@]} sources, nothing found"
