#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Writes codes.csv: packings that LAMMPS made (in the tree), and packings that YADE makes here (an hour on one core; those
# that stand in FOLDER already are not made again).
#
#     validation/relaxation/codes.sh BUILD FOLDER
set -eu
if [ $# -ne 2 ]; then
  echo "usage: $0 BUILD FOLDER" >&2
  exit 2
fi
root=$(cd "$(dirname "$0")/../.." && pwd)
program=$(cd "$1" && pwd)/validation/relaxation_codes
table=$root/validation/relaxation/codes.csv
mkdir -p "$2"
cd "$2"

# lammps SIZES PREPARATION PATH, without the endings of the two files
lammps() {
  "$program" "$table" lammps sphere "$1" "$2" 1 "$root/$3.atoms.gz" "$root/$3.contacts.gz"
}
lammps equal loose examples/data/lammps_loose_p50
for preparation in dense loose; do
  lammps lognormal:0.35 $preparation validation/sizes/lognormal_$preparation
  lammps uniform:1:3 $preparation validation/sizes/uniform_$preparation
done

# yade CONTACT SIZES PREPARATION SEED OPTIONS...
yade() {
  contact=$1 sizes=$2 preparation=$3 seed=$4
  name=${contact}_$(echo "$sizes" | cut -d: -f1)_${preparation}_$seed
  shift 4
  if [ ! -e "$name.rested" ]; then
    command yade -j1 -n -x "$root/tests/peer/yade/make_packing.py" "$name" "$root/share/yade" --grains 600 \
      --pressure 1e5 --sizes "$sizes" --seed "$seed" --rate 0.5 --rest-at 1e-6 "$@"
    touch "$name.rested"
  fi
  "$program" "$table" yade "$contact" "$sizes" "$preparation" "$seed" "$name.grains" "$name.contacts"
}
for seed in 1 2; do
  for sizes in equal lognormal:0.35 uniform:1:3; do
    yade sphere $sizes dense $seed --step 3 --friction 0 --friction-at-rest 0.46
    yade sphere $sizes loose $seed --step 3 --friction 0.46
  done
  yade flat equal loose $seed --law linear --step 0.6 --friction 0.46
done
