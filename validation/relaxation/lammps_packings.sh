#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Packs grains by LAMMPS, each packing by the deck that `granum export lammps --start scattered` writes, and adds a row of
# each state at rest to codes.csv. Can be stopped and started again; packings take some 5 minutes each on one core and are
# deleted when their rows are written.
#
#     validation/relaxation/lammps_packings.sh BUILD FOLDER
set -eu
if [ $# -ne 2 ]; then
  echo "usage: $0 BUILD FOLDER" >&2
  exit 2
fi
root=$(cd "$(dirname "$0")/../.." && pwd)
build=$(cd "$1" && pwd)
table=$root/validation/relaxation/codes.csv
mkdir -p "$2"
cd "$2"

# pack SIZES PREPARATION FRICTION_ANGLE SEED; dense: without friction up to 25 kPa, else with it all the way from a gas
pack() {
  sizes=$1 preparation=$2 angle=$3 seed=$4
  name=$(echo "${sizes}_${preparation}_$seed" | tr ':' '_')
  [ ! -e "$name.done" ] || return 0
  density=loose
  [ "$preparation" != dense ] || density=dense
  rm -rf "$name"
  "$build/granum" export lammps --start scattered --grains 2000 --set study.contacts=sphere \
    --set study.densities=$density --set "grain.friction_angle=$angle" --set "grain.sizes=$sizes" \
    --set study.pressures=25kPa,50kPa,200kPa --set study.probe_pressures=50kPa --set "study.first_seed=$seed" \
    --out "$name" > "$name.log"
  (
    cd "$name/$density-$seed"
    for part in in.prepare in.iso; do
      lmp -in $part -var rest_tolerance 1e-6 -log none > part.log || exit 1
    done
    for pressure in 50kPa 200kPa; do
      "$build/validation/relaxation_codes" "$table" lammps sphere "$sizes" "$preparation" "$seed" \
        atoms.$pressure.dump contacts.$pressure.dump
    done
  )
  rm -rf "$name"
  touch "$name.done"
}

for seed in 11 12 13 14; do
  pack uniform:1:3 dense 26.5deg $seed
  pack lognormal:0.35 mu0.5 26.5deg $seed
  pack equal dense 26.5deg $seed
  pack equal mu0.3 16.7deg $seed
  pack uniform:1:3 mu0.5 26.5deg $seed
  pack lognormal:0.35 dense 26.5deg $seed
  pack equal mu0.1 5.71deg $seed
  pack uniform:1:3 mu0.1 5.71deg $seed
  pack bidisperse:1.4:0.5 dense 26.5deg $seed
  pack lognormal:0.35 mu0.3 16.7deg $seed
done
