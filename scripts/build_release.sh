#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds build/release/granum. On a terminal one line of standard error gives what is built, how far, and how long it
# still takes; elsewhere there is such a line every ten seconds. The output of the tools goes to build/release.log, and is
# shown if they fail.
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."
tree=build/release log=build/release.log
mkdir -p build

said=-10 # seconds, of the last line
line() {
  if [ -t 2 ]; then
    printf '\r\033[K%s' "$1" >&2
  elif [ -n "$1" ] && [ $((SECONDS - said)) -ge 10 ]; then
    echo "$1" >&2
    said=$SECONDS
  fi
}
fail() {
  line ""
  cat "$log" >&2
  exit 1
}

# Sets `weight` to what a step of the build counts. Sources that are compiled in one go, headers that are compiled
# beforehand and two long sources take about five times as long as another one.
weigh() {
  case "$1" in
  *Unity* | *.gch | *contact_sweep* | *elimination*) weight=5 ;;
  *) weight=1 ;;
  esac
}

export NINJA_STATUS="[%f/%t] "
line "configuring granum"
cmake --preset release >"$log" 2>&1 || fail
steps=0 total=0
while read -r step; do
  [[ $step == \[* ]] || continue
  weigh "$step"
  steps=$((steps + 1)) total=$((total + weight))
done < <(cmake --build "$tree" -- -n)

[ "$steps" -eq 0 ] || line "building granum 0/$steps"
start=$SECONDS count=0 made=0
cmake --build "$tree" 2>&1 | while IFS= read -r step; do
  printf '%s\n' "$step" >>"$log"
  [[ $step == \[* ]] || continue
  weigh "$step"
  count=$((count + 1)) made=$((made + weight))
  line "building granum $count/$steps, about $(((SECONDS - start) * (total - made) / made)) s left"
done || fail
line ""
