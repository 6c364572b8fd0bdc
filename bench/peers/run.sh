#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Grain-steps a second of granum, LAMMPS, LIGGGHTS and YADE on the same packed grains, side by side in every round:
#   bench/peers/run.sh [--sizes 1000,10000,100000,1000000] [--rounds 5] [--cores 1,2] [--work 2e7]
#                      [--out bench/results] [--packings FOLDER] [--engine PROGRAM] [--force]
# Writes peers.csv and peers.md into the folder --out; --force replaces them. --work: grain-steps of a run, of
# YADE a tenth. --packings keeps them for the next time. --engine: bench_peer_engine, built already.
# README.md says what is compared. Installs nothing (Debian: lammps, liggghts, yade, openmpi-bin); what is
# missing is named and left out.
# Exit codes: 0 done, 1 a run failed or the codes disagree on the state, 2 usage, 3 none of the others is here.
set -euo pipefail
export PATH OMP_NUM_THREADS=1
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 # Open MPI in a machine that only has root
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
root=$(cd -- "$here/../.." && pwd)

sizes=1000,10000,100000,1000000
rounds=5
cores=1,2
work=2e7
out=$root/bench/results
packings=
engine=
force=no
largest_of_peers=100000
cell=10000           # larger specimens are copies of one of this many grains
strain=2e-5          # of a run, whatever its steps
skin=5e-5            # of the neighbour lists, a twentieth of a diameter [m]
restitution=0.5      # of LAMMPS's pair granular and of LIGGGHTS

usage() {
  echo "bench/peers/run.sh: $1" >&2
  sed -n '4,5s/^# *//p' "${BASH_SOURCE[0]}" >&2
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
    --sizes) sizes=$2 ;;
    --rounds) rounds=$2 ;;
    --cores) cores=$2 ;;
    --work) work=$2 ;;
    --out) out=$2 ;;
    --packings) packings=$2 ;;
    --engine) engine=$2 ;;
    *) usage "no option $1" ;;
  esac
  shift 2
done
[[ $rounds =~ ^[1-9][0-9]{0,2}$ ]] || usage "--rounds $rounds"
[[ $sizes =~ ^[1-9][0-9]{1,7}(,[1-9][0-9]{1,7})*$ ]] || usage "--sizes $sizes"
[[ $cores =~ ^1(,[1-9][0-9]?)*$ ]] || usage "--cores $cores: a list that begins with 1"
[[ $work =~ ^[1-9][0-9.]*(e[0-9]+)?$ ]] || usage "--work $work"
for size in ${sizes//,/ }; do
  [ "$size" -le $cell ] || [ $((size % cell)) = 0 ] || usage "--sizes: $size is above $cell and no multiple of it"
done
for file in peers.csv peers.md; do
  [ "$force" = yes ] || ! [ -e "$out/$file" ] || usage "$out/$file exists; --force replaces it"
done

# Which codes are there, and their versions.
declare -A version
peers=()
have() { # CODE PROGRAM PACKAGE
  if command -v "$2" >/dev/null; then
    peers+=("$1")
  else
    echo "$1 is left out: no $2 here (Debian: $3)" >&2
  fi
}
have LAMMPS lmp lammps
have LIGGGHTS liggghts liggghts
have YADE yade yade
if [ "${#peers[@]}" = 0 ]; then
  echo "bench/peers/run.sh: nothing to compare with" >&2
  exit 3
fi
have_mpi=yes
if ! command -v mpirun >/dev/null; then
  have_mpi=no
  echo "LAMMPS and LIGGGHTS run on one core alone: no mpirun here (Debian: openmpi-bin)" >&2
fi
version[granum]=$(sed -n 's/^project(granum VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt")
if commit=$(git -C "$root" describe --always --dirty 2>/dev/null); then version[granum]+=" ($commit)"; fi
for peer in "${peers[@]}"; do # LIGGGHTS ends its help with an error
  case $peer in
    LAMMPS) version[LAMMPS]=$(lmp -h | sed -n 's/.*Parallel Simulator - *//p') ;;
    LIGGGHTS) version[LIGGGHTS]=$({ liggghts -log none -h 2>&1 || true; } | sed -n 's/.*PUBLIC \([^,]*\),.*/\1/p') ;;
    YADE) version[YADE]=$(yade --version 2>&1 | sed -n 's/^Yade version: *\([^ ]*\).*/\1/p') ;;
  esac
done

if [ -z "$engine" ]; then
  (cd -- "$root" && cmake --preset bench && cmake --build build/bench --target bench_peer_engine) >&2
  engine=$root/build/bench/bench/bench_peer_engine
fi
engine=$(realpath -- "$engine")
mkdir -p -- "$out"
out=$(cd -- "$out" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
packings=${packings:-$scratch}
mkdir -p -- "$packings"
packings=$(cd -- "$packings" && pwd)
cd -- "$scratch"

# $packings/$1.data and $1.scene: the grains, and the numbers that the other codes need.
specimen() {
  local size=$1 x y
  if ! [ -e "$packings/$size.data" ]; then
    echo "packing $size grains" >&2
    if [ "$size" -le $cell ]; then
      "$engine" pack "$size" "$packings/$size.data"
    else
      [ -e "$packings/$cell.data" ] || "$engine" pack $cell "$packings/$cell.data"
      # As cubic as three whole factors allow, the largest first.
      read -r x y < <(awk -v n=$((size / cell)) 'BEGIN {
        best = n + 2; x = n; y = 1
        for (a = 1; a <= n; ++a)
          for (b = 1; b <= a && a * b <= n; ++b)
            if (n % (a * b) == 0 && n / (a * b) <= b && a + b + n / (a * b) < best) {
              best = a + b + n / (a * b); x = a; y = b
            }
        print x, y
      }')
      "$engine" repeat "$packings/$cell.data" "$x" "$y" $((size / cell / x / y)) "$packings/$size.data"
    fi
  fi
  "$engine" scene "$packings/$size.data" >"$size.scene"
  printf '%s\n' "skin=$skin" "restitution=$restitution" >>"$size.scene"
}

# One run: a row of rounds.csv.
row() { # ROUND CODE STYLE CORES GRAINS
  local round=$1 code=$2 style=$3 on=$4 size=$5 steps share=1
  local mpi=()
  if [ "$code" = YADE ]; then share=0.1; fi
  steps=$(awk -v w="$work" -v g="$size" -v s=$share \
    'BEGIN { n = int(w * s / g); print n < 100 ? 100 : n }')
  case $code in
    LAMMPS | LIGGGHTS)
      sed 's/\([^=]*\)=\(.*\)/variable \1 index \2/' "$size.scene" >scene.lmp
      if [ "$on" -gt 1 ]; then mpi=(mpirun --oversubscribe --bind-to none -np "$on"); fi
      ;;
  esac
  case $code in
    granum) set -- "$engine" run "$packings/$size.data" "$steps" $strain "$on" ;;
    LAMMPS)
      set -- "${mpi[@]}" lmp -in "$here/in.lammps" -log none -var law "$style" -var data "$packings/$size.data" \
        -var steps "$steps" -var strain $strain
      ;;
    LIGGGHTS)
      set -- "${mpi[@]}" liggghts -in "$here/in.liggghts" -log none -var data "$packings/$size.data" -var steps "$steps" \
        -var strain $strain
      ;;
    YADE) set -- yade "-j$on" -n -x "$here/yade_run.py" "$size.scene" "$packings/$size.data" "$steps" $strain ;;
  esac
  if ! "$@" >run.out 2>run.err </dev/null; then
    tail -n 20 run.out run.err >&2
    echo "bench/peers/run.sh: failed: $*" >&2
    exit 1
  fi
  # LAMMPS says what share of its cores it got; LIGGGHTS does not.
  awk -v row="$round,$code,$style,${version[$code]},$on,$size,$steps" -v cores="$on" '
    $1 == "state" { ++states; contacts[states] = $2; pressure[states] = $3 }
    $1 == "took" { seconds = $2; share = $3 / (seconds * cores) }
    /^Loop time of/ { timed = $9 > 0; if (timed) seconds = $4 }
    /CPU use with/ && timed { share = $1 / 100 }
    END {
      if (states != 2 || seconds <= 0) exit 1
      print row "," contacts[1] "," pressure[1] "," contacts[2] "," pressure[2] "," seconds "," share
    }' run.out >>rounds.csv || {
    tail -n 20 run.out >&2
    echo "bench/peers/run.sh: no result: $*" >&2
    exit 1
  }
  tail -n 1 rounds.csv >&2
}

printf '%s%s\n' round,engine,style,version,cores,grains,steps,contacts,pressure_Pa, \
  contacts_after,pressure_after_Pa,seconds,cpu_share >rounds.csv
for size in ${sizes//,/ }; do
  specimen "$size"
done
for ((round = 1; round <= rounds; ++round)); do
  for size in ${sizes//,/ }; do
    for on in ${cores//,/ }; do
      row $round granum "hertz + mindlin" "$on" "$size"
      [ "$size" -le $largest_of_peers ] || continue
      for peer in "${peers[@]}"; do
        if [ "$on" -gt 1 ] && [ $have_mpi = no ] && [ "$peer" != YADE ]; then continue; fi
        case $peer in
          LAMMPS)
            for style in granular gran/hertz/history gran/hooke/history; do
              row $round LAMMPS $style "$on" "$size"
            done
            ;;
          LIGGGHTS) row $round LIGGGHTS "gran model hertz tangential history" "$on" "$size" ;;
          YADE) row $round YADE "MindlinPhys Mindlin" "$on" "$size" ;;
        esac
      done
    done
  done
done
python3 "$here/table.py" rounds.csv "$out"
