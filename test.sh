#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# All tests, from nothing: sets the machine up, then formatting, the unit tests under the sanitizers, what the page
# leaves out of the libraries by clang with libc++, every test of the release build with warnings as errors, and the
# page in a browser, where the system offers what that needs. Each step runs even where an earlier one failed; exit
# code 1 if any did.
set -uo pipefail
export PATH # bash supplies one where the environment has none; cmake needs to see it
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")" || exit 1

scripts/setup.sh test || exit
mkdir -p build

failed=0
declare -A verdict
# step <name> <command>...: runs it, keeps its output in build/test-<name>.log, and notes the verdict.
step() {
  local name=$1 start=$SECONDS outcome=passed
  shift
  printf '\n===== %s\n' "$name"
  if ! "$@" 2>&1 </dev/null | tee "build/test-$name.log"; then
    outcome=FAILED
    failed=1
  fi
  verdict[$name]="$outcome in $((SECONDS - start)) s"
}

step formatting scripts/format.sh --check
step sanitizers cmake --workflow --preset sanitize
step clang cmake --workflow --preset clang-libraries
step tests cmake --workflow --preset ci
if scripts/setup.sh web; then
  step page web/test.sh
else
  step engine cmake --build --preset clang-libraries --target granum_dem # what the page's compiler would check
  verdict[page]="left out: what it needs is missing, as said above"
  : >build/test-page.log
fi

printf '\n===== summary\n'
for name in formatting sanitizers clang engine tests page; do
  [ -n "${verdict[$name]:-}" ] || continue
  printf '%-10s  %s\n' "$name" "${verdict[$name]}"
  # ctest's own words: what failed, and how many
  sed -n '/% tests passed/p; /The following tests FAILED/,/^Errors/{/^\t/p}' "build/test-$name.log"
done
exit "$failed"
