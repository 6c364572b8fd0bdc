#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What a deck of `granum export lammps` costs as it grows: time, memory and disk for each grain, and the steps
# that one pressure takes. Writes bench/results/lammps_growth.csv and says what 10^7 and
# 10^8 grains need:
#   bench/peers/lammps_growth.sh GRANUM [FOLDER]     FOLDER: scratch, else a temporary one
# Needs lmp and mpirun. Times are CPU times (LAMMPS's loop time times its CPU use), the least of
# three runs, for machines with other work.
# Exit codes: 0 done, 2 usage, 3 lmp or mpirun is missing.
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
results=$here/../results/lammps_growth.csv
if [ "$#" -lt 1 ] || [ "$#" -gt 2 ] || ! [ -x "$1" ]; then
  echo "usage: bench/peers/lammps_growth.sh GRANUM [FOLDER]" >&2
  exit 2
fi
if ! command -v lmp >/dev/null || ! command -v mpirun >/dev/null; then
  echo "lammps_growth.sh: lmp and mpirun are needed (Debian: lammps, openmpi-bin)" >&2
  exit 3
fi
scratch=${2:-$(mktemp -d)}
runs=${GROWTH_RUNS:-3}
work=${GROWTH_WORK:-8000000}
mkdir -p -- "$scratch"
source "$here/deck_of_copies.sh"
deck_of_copies "$(realpath -- "$1")" "$scratch" "" 0

# A box of copies under the servo: grows.lmp for a number of steps, with the memory of each rank; whole.lmp until it
# is at rest, with the snapshot.
printf '%s\n' 'variable servo_steps index ${steps}' 'include copies.lmp' 'include servo.lmp' 'info memory' >grows.lmp
printf '%s\n' 'include copies.lmp' 'include servo.lmp' 'include rest.lmp' 'variable name string copies${copies}' \
  'include snapshot.lmp' >whole.lmp

# CPU seconds of all loops, and their steps, of one output of LAMMPS: "seconds steps".
loops() {
  awk '/^Loop time of/ { time = $4; ranks = $6; steps = $9 }
       /CPU use with/ { sub("%", "", $1); cpu += time * ranks * $1 / 100; all += steps }
       END { printf "%.4g %d\n", cpu, all }' "$1"
}

echo "grains,ranks,steps,cpu_us_per_grain_step,memory_rank_MB" >"$results"
for copies in 1 2 4; do
  grains=$((1000 * copies ** 3))
  steps=$((work / grains))
  for ranks in 1 2; do
    : >loops.txt
    for ((run = 0; run < runs; ++run)); do
      mpirun --oversubscribe --mca mpi_yield_when_idle 1 -np $ranks lmp -in grows.lmp -var copies $copies \
        -var steps $steps >grows.out
      loops grows.out >>loops.txt
    done
    read -r cpu all < <(sort -g loops.txt)
    memory=$(awk '/Maximum resident set size/ { print $5 }' grows.out)
    awk -v g=$grains -v r=$ranks -v s="$all" -v c="$cpu" -v m="$memory" \
      'BEGIN { printf "%d,%d,%d,%.4g,%s\n", g, r, s, 1e6 * c / (g * s), m }' >>"$results"
    tail -n 1 "$results" >&2
  done
done

# From 100 to 200 kPa and to rest: steps, and what the state takes on disk.
for copies in 1 2; do
  lmp -in whole.lmp -var copies $copies >whole.out
  read -r cpu steps[copies] < <(loops whole.out)
  echo "$((1000 * copies ** 3)) grains from 100 to 200 kPa: ${steps[copies]} steps" >&2
done
bytes() { echo $(($(stat -c %s "$1") / 8000)); }
dumps=$(($(bytes atoms.copies2.dump) + $(bytes contacts.copies2.dump)))
restart=$(bytes state.copies2.restart)

# Memory grows by what two sizes on one rank differ; steps of a pressure as the edge of the box, grains^(1/3).
awk -F, -v s1="${steps[1]}" -v s2="${steps[2]}" -v dumps=$dumps -v restart=$restart '
  $2 == 1 { memory[$1] = $5; time[$1] = $4 }
  $1 == 64000 && $2 == 2 { two = $4 }
  END {
    each = (memory[64000] - memory[8000]) / 56000 * 1e6
    printf "memory %.0f bytes a grain and rank-independent %.0f MB\n", each, memory[8000] - 8000 * each / 1e6
    printf "time %.3g us a grain and step on 1 rank, %.3g on 2\n", time[64000], two
    printf "steps of a pressure: 1,000 grains %d, 8,000 grains %d\n", s1, s2
    printf "disk %d bytes a grain for both dumps of a state, %d for its restart\n", dumps, restart
    for (power = 7; power <= 8; ++power) {
      grains = 10 ^ power
      far = s2 * (grains / 8000) ^ (1 / 3)
      printf "10^%d grains: %.0f GB memory; a pressure %.2g steps, %.0f core-hours; a state %.0f GB of dumps, %.1f GB restart\n",
        power, grains * each / 1e9, far, far * grains * two / 1e6 / 3600, grains * dumps / 1e9, grains * restart / 1e9
    }
  }' "$results"
