#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# stop_when.sh <mark> <signal> <program> <argument>...: runs the program, sends it the signal once the mark, a file or
# folder that it makes, is there, and ends with its exit code. Speed decides how far the program comes, nothing else.
mark=$1 signal=$2
shift 2
"$@" &
program=$!
until [[ -e $mark ]]; do
  kill -0 "$program" 2>/dev/null || break
  sleep 0.01
done
kill -s "$signal" "$program" 2>/dev/null
wait "$program"
