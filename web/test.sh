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
# Runners side by side, for node starts the files of one in turn where there are two cores.
logs=$(mktemp -d)
trap 'rm -rf "$logs"' EXIT
for part in devices numbers texts drawings firefox pictures; do
  node --test "$part.test.mjs" >"$logs/$part" 2>&1 &
done
code=0
node --test page.test.mjs || code=$?
for _ in devices numbers texts drawings firefox pictures; do
  wait -n || code=$?
done
cat "$logs"/*
exit "$code"
