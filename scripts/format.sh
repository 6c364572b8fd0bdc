#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Formats every C++ source in place; with --check changes nothing and fails if one is not formatted.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

case "${1:-}" in
"") action=(-i) ;;
--check) action=(--dry-run -Werror) ;;
*)
  echo "usage: scripts/format.sh [--check]" >&2
  exit 2
  ;;
esac
find include src tests examples validation \( -name '*.hpp' -o -name '*.cpp' \) -print0 |
  xargs -0 clang-format "${action[@]}"
