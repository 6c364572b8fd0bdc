#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# signals.sh <program> <signals> <seed> <scratch folder> [<most seconds>]: Ctrl-C and SIGTERM at random moments of a
# study of 20,000 grains, where a step takes milliseconds; tells how long each took to be heard. A second on a machine
# that does nothing else; ten of them are a fault on any. That each loop asks before every step is counted by the unit
# tests (tests/dem, tests/triaxial), which time nothing.
program=$1 signals=$2 folder=$4 most=${5:-10}
RANDOM=$3
rm -rf -- "$folder" && mkdir -p -- "$folder" && cd -- "$folder" || exit 1

faults=0
for ((k = 0; k < signals; ++k)); do
  rm -rf run
  "$program" verify --grains 20000 --set study.contacts=sphere --threads 1 --out run >said.txt 2>&1 &
  child=$!
  until [[ -e run ]]; do sleep 0.01; done
  sleep "$((RANDOM % 30)).$((RANDOM % 10))"
  signal=INT expected=130
  ((RANDOM % 2)) && signal=TERM expected=143
  start=$(date +%s%N)
  kill -s "$signal" "$child"
  wait "$child"
  code=$?
  milliseconds=$((($(date +%s%N) - start) / 1000000))
  printf 'SIG%s: exit code %s after %s ms\n' "$signal" "$code" "$milliseconds"
  if [[ $code != "$expected" || $milliseconds -gt $((1000 * most)) || ! -s run/manifest.json ]]; then
    faults=$((faults + 1))
  fi
done
exit "$((faults > 0))"
