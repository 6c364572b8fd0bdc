#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# check_streams.sh <program> <folder>: standard streams that are closed, full, or read by nobody any more. Standard error
# is no part of a result: what a run answers, writes and ends with is the same without it. Standard output that cannot
# be written to is a file error, exit code 3, and files that were written before are kept.
program=$1 folder=$2
rm -rf -- "$folder" && mkdir -p -- "$folder" && cd -- "$folder" || exit 1

faults=0
fail() {
  printf '%s\n' "$*"
  faults=$((faults + 1))
}

# outcome <redirections> <argument>...: exit code of the program with its streams redirected so, its answer in ./answer
outcome() {
  local redirections=$1
  shift
  rm -f answer
  eval '"$program" "$@" >answer' "$redirections"
  printf '%s' $?
}

# A warning, an error, a study that goes on, a refusal of the command line.
warning=(estimate --void-ratio 0.6 --pressure 100kPa --coordination-number 13 --full)
error=(estimate --void-ratio -1 --pressure 100kPa)
study=(verify --grains 80 --seeds 1 --set study.contacts=sphere --set study.densities=dense
  --set study.pressures=20kPa,40kPa,60kPa --set study.probe_pressures=)
"$program" "${warning[@]}" >expected 2>warned
grep -q 'granum: warning: ' warned || fail "no warning: choose another command"

broken='2> >(exec true)' # by the time that something is said, its reader is gone
for stream in '2>&-' '2>/dev/full' '2</dev/null' "$broken" '2>&- <&-'; do
  code=$(outcome "$stream" "${warning[@]}")
  { [[ $code == 0 ]] && cmp -s answer expected; } || fail "a warning with $stream: exit code $code"
  code=$(outcome "$stream" "${error[@]}")
  [[ $code == 2 ]] || fail "an error with $stream: exit code $code"
  code=$(outcome "$stream" nonsense)
  [[ $code == 2 ]] || fail "a refusal with $stream: exit code $code"
done
# No file takes the place of a stream: what would have been said must not stand in one.
"$program" "${warning[@]}" --out kept 2>&-
cmp -s kept expected || fail "a file beside a closed standard error differs"

for stream in '>&-' '>/dev/full' '</dev/null >&0'; do
  for command in '"${warning[@]}"' --help --version 'sweep --help'; do
    eval '"$program"' "$command" "$stream" 2>said
    code=$?
    { [[ $code == 3 ]] && grep -q 'standard output: cannot be written' said; } ||
      fail "$command with $stream: exit code $code, said: $(cat said)"
  done
  eval '"$program"' "$command" "$stream" '2>&-'
  code=$?
  [[ $code == 3 ]] || fail "$command with $stream and without standard error: exit code $code"
done

"$program" "${study[@]}" --out whole >expected 2>/dev/null
whole=$?
"$program" "${study[@]}" --out deaf >answer 2>&-
code=$?
[[ $code == "$whole" ]] || fail "a study without standard error: exit code $code, with it $whole"
"$program" "${study[@]}" --out mute >&- 2>said
code=$?
[[ $code == 3 ]] || fail "a study without standard output: exit code $code"
for results in deaf mute; do
  for name in states exponents; do
    cmp -s "whole/$name.csv" "$results/$name.csv" || fail "$results/$name.csv differs from the whole run's"
  done
  [[ -s $results/manifest.json ]] || fail "$results/manifest.json is missing"
done
exit "$((faults > 0))"
