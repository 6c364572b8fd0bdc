#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# kills.sh <program> <kills> <seed> <scratch folder>: a small `reproduce` is ended at random
# moments, most often by SIGKILL, else by Ctrl-C or SIGTERM, and resumed, up to three times in a row; each time it must come
# to the bytes of the run that nothing ended. When it is hit depends on the machine, what must come of it does not.
program=$1 kills=$2 folder=$4
RANDOM=$3
rm -rf -- "$folder" && mkdir -p -- "$folder" && cd -- "$folder" || exit 1

scene=(--grains 100 --seeds 1 --set study.contacts=sphere --set study.pressures=25kPa,50kPa,100kPa
  --set study.probe_pressures=50kPa --set shear.paths=TXC,RTXE --set shear.inertial_number=1e-3
  --set shear.largest_strain=0.001 --set shear.strain_step=0.00025 --set shear.probe_eta_step=0.5)
tables=(states curves loops histograms table2 table4 table5 exponents verdicts)

fail() {
  printf '%s\n' "$*"
  exit 1
}

start=$(date +%s%N)
"$program" reproduce "${scene[@]}" --out whole >whole.txt 2>&1
whole=$?
[[ $whole == [01] ]] || fail "the whole run ended with $whole: $(cat whole.txt)"
milliseconds=$((($(date +%s%N) - start) / 1000000))

hits=0
for ((round = 0; hits < kills; ++round)); do
  rm -rf run
  arguments=(reproduce "${scene[@]}" --out run)
  for ((life = 0; life < 3; ++life)); do
    "$program" "${arguments[@]}" >said.txt 2>&1 &
    child=$!
    moment=$((RANDOM * milliseconds / 32767))
    sleep "$((moment / 1000)).$(printf '%03d' $((moment % 1000)))"
    case $((RANDOM % 4)) in
    0) signal=INT ;;
    1) signal=TERM ;;
    *) signal=KILL ;;
    esac
    kill -s "$signal" "$child" 2>/dev/null
    wait "$child" 2>/dev/null
    code=$?
    case $code in
    130 | 137 | 143) hits=$((hits + 1)) ;;
    "$whole") ;; # was done before the signal came
    *) fail "round $round: exit code $code after SIG$signal: $(cat said.txt)" ;;
    esac
    [[ ! -e run/scene.toml ]] || arguments=(reproduce --resume run)
  done
  "$program" "${arguments[@]}" >said.txt 2>&1
  code=$?
  [[ $code == "$whole" ]] || fail "round $round: the last run ended with $code: $(cat said.txt)"
  for table in "${tables[@]}"; do
    cmp "whole/$table.csv" "run/$table.csv" || fail "round $round: $table.csv differs"
  done
done
printf '%s runs ended at random moments, all of them resumed to the same bytes\n' "$hits"
