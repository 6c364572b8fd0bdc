#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# granum's network solver beside those of libraries, on dense and loose packings:
#   bench/solvers/run.sh [--rounds 3] [--sizes "1000 10000 100000"] [--methods "NAME..."] [--limit 900] [--out bench/results] [--packings FOLDER] [--program FOLDER] [--add]
# Writes solvers.csv (every run) and solvers.md (medians) into the folder --out; --add keeps the runs that are there.
# 100,000 grains are ten copies of 10,000 with random factors on their stiffnesses. In each round every method runs
# once, granum on one thread and on two; a run may take --limit seconds of processor. Exact factors are left out above
# 20,000 grains, where they take more memory than most machines have. --packings keeps the packings for the next time;
# --program is the folder of bench_solvers and bench_growth, built already. Libraries: scripts/setup.sh solvers. Linux alone.
# Exit codes: 0 done, 1 a packing or the table failed, 2 usage.
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
root=$(cd -- "$here/../.." && pwd)
export OPENBLAS_NUM_THREADS=1 # of CHOLMOD: one thread, as the others

rounds=3
sizes="1000 10000 100000"
methods=
limit=900
out=$root/bench/results
packings=
program=
add=no
usage() {
  echo "bench/solvers/run.sh: $1" >&2
  sed -n '4s/^# *//p' "${BASH_SOURCE[0]}" >&2
  exit 2
}
while [ "$#" -gt 0 ]; do
  if [ "$1" = --add ]; then
    add=yes
    shift
    continue
  fi
  [ "$#" -ge 2 ] || usage "$1 is no option, or lacks its value"
  case $1 in
  --rounds) rounds=$2 ;;
  --sizes) sizes=$2 ;;
  --methods) methods=$2 ;;
  --limit) limit=$2 ;;
  --out) out=$2 ;;
  --packings) packings=$2 ;;
  --program) program=$2 ;;
  *) usage "no option $1" ;;
  esac
  shift 2
done
[[ $rounds =~ ^[1-9][0-9]?$ ]] || usage "--rounds $rounds"
[[ $limit =~ ^[1-9][0-9]{0,5}$ ]] || usage "--limit $limit"
for size in $sizes; do
  [[ $size =~ ^1000(0{0,2})$ ]] || usage "--sizes $size: 1000, 10000 or 100000"
done
if [ -z "$program" ]; then
  (cd -- "$root" && cmake --preset bench && cmake --build build/bench --target bench_growth bench_solvers) >&2
  program=$root/build/bench/bench
  PATH=$PATH:$program:$program/solvers
else
  PATH=$(realpath -- "$program"):$PATH
fi
known=$(bench_solvers list)
methods=${methods:-$known}
for method in $methods; do
  grep -qx -- "$method" <<<"$known" || usage "--methods $method: not built; there are" $known
done
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
packings=${packings:-$scratch}
mkdir -p -- "$out" "$packings"
rows=$out/solvers.csv
[ "$add" = yes ] && [ -e "$rows" ] ||
  echo density,method,grains,threads,assembly,setup,solution,cpu,bytes_a_grain,iterations,residual,difference >"$rows"

run() { # DENSITY SIZE METHOD THREADS
  local stored=$2 copies="1 1 1" line
  [ "$2" -lt 100000 ] || { stored=10000; copies="5 2 1"; }
  # shellcheck disable=SC2086 # three counts
  line=$(ulimit -t "$limit" && bench_solvers "$3" "$packings/$1-$stored-1.data" $copies "$4") ||
    line=$(printf '%s,%s,%s,,,,,,,,' "$3" "$2" "$4")
  printf '%s,%s\n' "$1" "$line" | tee -a "$rows" >&2
}
for size in $sizes; do
  for density in dense loose; do
    stored=$size
    [ "$size" -lt 100000 ] || stored=10000
    [ -e "$packings/$density-$stored-1.data" ] ||
      bench_growth pack $density "$stored" 1 "$packings/$density-$stored-1.data"
  done
done
for size in $sizes; do
  for ((round = 1; round <= rounds; ++round)); do
    for density in dense loose; do
      for method in $methods; do
        case $method in
        granum)
          run $density "$size" granum 1
          run $density "$size" granum 2
          ;;
        cholmod*) [ "$size" -gt 20000 ] || run $density "$size" "$method" 1 ;;
        *) run $density "$size" "$method" 1 ;;
        esac
      done
    done
  done
done
python3 "$here/table.py" "$rows" "$out/solvers.md"
