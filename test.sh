#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# All tests, from nothing: sets the machine up, then formatting, the unit tests under the sanitizers, and every test of
# the release build with warnings as errors. Each step runs even where an earlier one failed; exit code 1 if any did.
set -uo pipefail
export PATH # bash supplies one where the environment has none; cmake needs to see it
cd -- "$(dirname -- "${BASH_SOURCE[0]}")" || exit 1

scripts/setup.sh test || exit
mkdir -p build

summary=""
failed=0
# step <name> <command>...: runs it, keeps its output in build/test-<name>.log, notes the verdict and ctest's own summary.
step() {
  local name=$1 log="build/test-$1.log" start=$SECONDS verdict=passed
  shift
  printf '\n===== %s\n' "$name"
  "$@" 2>&1 </dev/null | tee "$log"
  if [ "${PIPESTATUS[0]}" -ne 0 ]; then
    verdict=FAILED
    failed=1
  fi
  summary+=$(printf '%-12s %s in %d s' "$name" "$verdict" $((SECONDS - start)))$'\n'
  summary+=$(sed -n '/% tests passed/p; /The following tests FAILED/,/^Errors/{/^\t/p}' "$log" | sed '$s/$/\n/')
}

step formatting scripts/format.sh --check
step sanitizers cmake --workflow --preset sanitize
step tests cmake --workflow --preset ci

printf '\n===== summary\n%s' "$summary" | cat -s
exit "$failed"
