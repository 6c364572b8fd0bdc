#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Formats every C++ source in place; with --check changes nothing and fails if one is not formatted. Comments are left as
# they are written, except that --check also refuses lines of more than 110 characters.
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
mapfile -d '' sources < <(find include src tests examples validation bench python/src web/src \( -name '*.hpp' -o -name '*.cpp' \) -print0)
clang-format "${action[@]}" "${sources[@]}"
if [ "${1:-}" = --check ] && LC_ALL=C.UTF-8 grep -nE '^.{111,}' "${sources[@]}"; then
  echo "these lines are longer than 110 characters" >&2
  exit 1
fi
