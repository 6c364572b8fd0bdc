#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the page, and tests it: its numbers against the native program of build/ci or build/release, its parts in a browser.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."
cmake --workflow --preset web
cd web/tests
[ -e node_modules/.package-lock.json ] && cmp -s package-lock.json node_modules/granum-lock.json || {
  npm ci --no-audit --no-fund
  cp package-lock.json node_modules/granum-lock.json
}
# Two runners side by side, for node starts the files of one in turn where there are two cores.
pictures=$(mktemp)
trap 'rm -f "$pictures"' EXIT
node --test pictures.test.mjs >"$pictures" 2>&1 &
code=0
node --test numbers.test.mjs page.test.mjs || code=$?
wait $! || code=$?
cat "$pictures"
exit "$code"
