#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# All tests, from nothing: sets the machine up, then formatting, the unit tests under the sanitizers, what the page
# leaves out of the libraries by clang with libc++, every test of the release build with warnings as errors, and the
# page, its module of WebAssembly and then in a browser, where the system offers what that needs. Each step runs even
# where an earlier one failed; exit code 1 if any did.
set -uo pipefail
export PATH # bash supplies one where the environment has none; cmake needs to see it
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")" || exit 1

scripts/setup.sh test || exit
scripts/setup.sh web && web=there || web= # before the rows: it may ask for a password
mkdir -p build
rm -f build/test-*.{log,verdict}

# step <name> <command>...: runs it, keeps its output in build/test-<name>.log, and notes the verdict beside it.
step() {
  local name=$1 start=$SECONDS outcome=passed
  shift
  printf '\n===== %s\n' "$name"
  "$@" 2>&1 </dev/null | tee "build/test-$name.log" || outcome=FAILED
  echo "$outcome in $((SECONDS - start)) s" >"build/test-$name.verdict"
}

# Two rows of steps side by side, each with half of the cores: one works while the other waits for a link, a browser or a
# long test. The page is compared with the program that the other row builds.
half=$((($(nproc) + 1) / 2))
export CMAKE_BUILD_PARALLEL_LEVEL=$((half > 2 ? half : 2))
set -m # a group of its own, which ends with this script
{
  step sanitizers cmake --workflow --preset sanitize
  step clang cmake --workflow --preset clang-libraries
  if [ "$web" ]; then
    step module cmake --workflow --preset web
    until [ -e build/test-build.verdict ]; do sleep 1; done
    step page web/test.sh
  else
    step engine cmake --build --preset clang-libraries --target granum_dem # what the page's compiler would check
    echo "left out: what it needs is missing, as said above" >build/test-page.verdict
  fi
} >build/test-aside.log 2>&1 &
set +m
trap 'kill -- "-$!" 2>/dev/null' EXIT

step formatting scripts/format.sh --check
step build bash -c 'cmake --preset ci && cmake --build --preset ci'
step tests ctest --preset ci
wait
cat build/test-aside.log

printf '\n===== summary\n'
for name in formatting sanitizers clang engine build tests module page; do
  [ -e "build/test-$name.verdict" ] || continue
  printf '%-10s  %s\n' "$name" "$(<"build/test-$name.verdict")"
  # ctest's own words: what failed, and how many
  sed -n '/% tests passed/p; /The following tests FAILED/,/^Errors/{/^\t/p}' "build/test-$name.log" 2>/dev/null
done
! grep -q FAILED build/test-*.verdict
