#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Time and memory of the engine and of the network, 1e3 to 1e6 grains, of analyse from file to 6x6, and time to make a dense specimen:
#   bench/growth.sh [--rounds 5] [--largest 1000000] [--seed 1] [--out bench/results] [--packings FOLDER] [--program PROGRAM] [--granum GRANUM] [--force]
# Writes growth.csv (every run) and growth.md (medians) into the folder --out; --force replaces them. --seed makes other
# packings; --packings keeps them for the next time, five minutes' work. --program, --granum: bench_growth and granum,
# built already. Linux alone (memory by /proc).
# The network of 1e5 and 1e6 grains is solved once for each number of threads; a million grains take some 5 GB. Iterations
# depend on the packing: they are taken of five loose packings, the next four seeds among them.
# Each round makes eight specimens of 1e3 grains and three of 1e4 of its own: how many steps one takes is chance.
# Exit codes: 0 done, 1 a run failed, 2 usage.
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
root=$(cd -- "$here/.." && pwd)

rounds=5
largest=1000000
seed=1
out=$here/results
packings=
program=
granum=
force=no
usage() {
  echo "bench/growth.sh: $1" >&2
  sed -n '4s/^# *//p' "${BASH_SOURCE[0]}" >&2
  exit 2
}
while [ "$#" -gt 0 ]; do
  if [ "$1" = --force ]; then
    force=yes
    shift
    continue
  fi
  [ "$#" -ge 2 ] || usage "$1 is no option, or lacks its value"
  case $1 in
    --rounds) rounds=$2 ;;
    --largest) largest=$2 ;;
    --seed) seed=$2 ;;
    --out) out=$2 ;;
    --packings) packings=$2 ;;
    --program) program=$2 ;;
    --granum) granum=$2 ;;
    *) usage "no option $1" ;;
  esac
  shift 2
done
[[ $rounds =~ ^[1-9][0-9]?$ ]] || usage "--rounds $rounds"
[[ $seed =~ ^[1-9][0-9]{0,8}$ && $seed -le 999999995 ]] || usage "--seed $seed: 1 to 999999995"
[[ $largest =~ ^1000(0{0,3})$ ]] || usage "--largest $largest: 1000, 10000, 100000 or 1000000"
for file in growth.csv growth.md; do
  [ "$force" = yes ] || ! [ -e "$out/$file" ] || usage "$out/$file exists; --force replaces it"
done
if [ -z "$program" ]; then
  (cd -- "$root" && cmake --preset bench && cmake --build build/bench --target bench_growth) >&2
  program=$root/build/bench/bench/bench_growth
fi
if [ -z "$granum" ]; then
  (cd -- "$root" && cmake --preset release && cmake --build build/release) >&2
  granum=$root/build/release/granum
fi
program=$(realpath -- "$program")
granum=$(realpath -- "$granum")
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
packings=${packings:-$scratch}
mkdir -p -- "$out" "$packings"
make_packing() { # DENSITY SIZE SEED
  [ -e "$packings/$1-$2-$3.data" ] || {
    echo "packing $2 grains, $1, seed $3" >&2
    "$program" pack "$1" "$2" "$3" "$packings/$1-$2-$3.data"
  }
}
for size in 1000 10000; do
  make_packing dense $size "$seed"
  for ((of = seed; of < seed + 5; ++of)); do
    make_packing loose $size $of
  done
done

rows=$scratch/growth.csv
echo density,what,grains,threads,wall,cpu,bytes_a_grain,count,residual,C_n >"$rows"
line() { # DENSITY ARGUMENTS of bench_growth
  local density=$1
  shift
  printf '%s,%s\n' "$density" "$("$program" "$@")" | tee -a "$rows" >&2
}
row() { # DENSITY ARGUMENTS of bench_growth, the size of a packing in place of its file
  local density=$1 what=$2 size=$3
  shift 3
  line "$density" "$what" "$packings/$density-$size-$seed.data" "$@"
}
from_file() { # DENSITY SIZE X Y Z THREADS: analyse, to the 6x6
  local data=$scratch/copies.data start end
  "$program" copies "$packings/$1-$2-$seed.data" "$3" "$4" "$5" "$data"
  start=$EPOCHREALTIME
  "$granum" analyse "$data" --grain-shear-modulus 30GPa --grain-poisson-ratio 0.15 --threads "$6" >"$scratch/analysed"
  end=$EPOCHREALTIME
  printf '%s,analyse,%d,%d,%s,,,,,\n' "$1" $(($2 * $3 * $4 * $5)) "$6" \
    "$(awk -v s="$start" -v e="$end" 'BEGIN { printf "%.4g", e - s }')" | tee -a "$rows" >&2
}
for ((round = 1; round <= rounds; ++round)); do
  for density in dense loose; do
    for threads in 1 2; do
      from_file $density 1000 1 1 1 $threads
      from_file $density 10000 1 1 1 $threads
      [ "$largest" -lt 100000 ] || [ $round -gt 1 ] || from_file $density 10000 5 2 1 $threads
      row $density network 1000 1 1 1 $threads
      row $density network 10000 1 1 1 $threads
      [ "$largest" -lt 100000 ] || [ $round -gt 1 ] || row $density network 10000 5 2 1 $threads
    done
  done
  for ((specimen = 8 * round - 7; specimen <= 8 * round; ++specimen)); do
    line dense specimen 1000 $specimen
  done
  for ((specimen = 3 * round - 2; specimen <= 3 * round; ++specimen)); do
    line dense specimen 10000 $specimen
  done
  for threads in 1 2; do
    row dense engine 1000 1 1 1 10000 $threads
    row dense engine 10000 1 1 1 1000 $threads
    [ "$largest" -lt 100000 ] || row dense engine 10000 5 2 1 100 $threads
    [ "$largest" -lt 1000000 ] || row dense engine 10000 5 5 4 20 $threads
  done
done
for density in dense loose; do
  [ "$largest" -lt 1000000 ] || row $density network 10000 5 5 4 1
  [ "$largest" -lt 1000000 ] || row $density network 10000 5 5 4 2
  [ "$largest" -lt 1000000 ] || from_file $density 10000 5 5 4 2
done
# Iterations of five packings; those of the first are in the rows above.
awk -F, -v OFS=, -v name="loose $seed" '$1 == "loose" && $2 == "network" && $4 == 2 { $1 = name; last[$3] = $0 }
  END { for (grains in last) print last[grains] }' "$rows" >"$scratch/first"
cat "$scratch/first" >>"$rows"
for ((of = seed + 1; of < seed + 5; ++of)); do
  line "loose $of" network "$packings/loose-1000-$of.data" 1 1 1 2
  line "loose $of" network "$packings/loose-10000-$of.data" 1 1 1 2
  [ "$largest" -lt 100000 ] || line "loose $of" network "$packings/loose-10000-$of.data" 5 2 1 2
  [ "$largest" -lt 1000000 ] || line "loose $of" network "$packings/loose-10000-$of.data" 5 5 4 2
done
python3 "$here/growth_table.py" "$rows" "$scratch/growth.md"
mv -- "$rows" "$out/growth.csv"
mv -- "$scratch/growth.md" "$out/growth.md"
