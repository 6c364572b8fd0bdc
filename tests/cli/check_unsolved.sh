#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# check_unsolved.sh <program> <scratch folder>: networks that `analyse` does not solve decide its exit code, and stand in its
# JSON: 0 if all are solved, 1 if some are not, 4 if none is. Whether a perfect lattice is solved is not asked here.
program=$1 folder=$2
rm -rf -- "$folder" && mkdir -p -- "$folder" && cd -- "$folder" || exit 1

# frame <cells on an edge> <largest displacement, in radii>: a face-centred cubic packing as a frame of a dump
frame() {
  awk -v n="$1" -v shift="$2" 'BEGIN {
    R = 1e-3; a = 2 * sqrt(2) * R * 0.999; seed = 1
    printf "ITEM: TIMESTEP\n%d\nITEM: NUMBER OF ATOMS\n%d\nITEM: BOX BOUNDS pp pp pp\n", n, 4 * n^3
    for (k = 0; k < 3; ++k) printf "0 %.17g\n", n * a
    print "ITEM: ATOMS id radius x y z"
    split("0 0 0 .5 .5 0 .5 0 .5 0 .5 .5", place, " ")
    for (i = 0; i < n; ++i) for (j = 0; j < n; ++j) for (l = 0; l < n; ++l) for (m = 0; m < 4; ++m) {
      cell[0] = i; cell[1] = j; cell[2] = l
      printf "%d %.17g", ++id, R
      for (k = 0; k < 3; ++k) {
        seed = (seed * 16807) % 2147483647
        printf " %.17g", (cell[k] + place[3 * m + k + 1] + .25) * a + R * shift * (2 * seed / 2147483647 - 1)
      }
      print ""
    }
  }'
}
frame 6 0 >lattice
frame 2 0.0003 >disturbed
cat disturbed lattice >both

for name in disturbed lattice both; do
  "$program" analyse "$name" --grain-shear-modulus 30GPa --threads 1 --json >answer 2>said
  code=$?
  solved=$(grep -c '"converged": true' answer)
  unsolved=$(grep -c '"converged": false' answer)
  expected=0
  [[ $unsolved -gt 0 ]] && expected=$((solved > 0 ? 1 : 4))
  printf '%s: %s solved, %s not, exit code %s\n' "$name" "$solved" "$unsolved" "$code"
  [[ $code == "$expected" && $((solved + unsolved)) -gt 0 ]] || { cat said; exit 1; }
  [[ $unsolved == 0 ]] || grep -q '^granum: error: ' said || { echo "no error is said"; exit 1; }
done
[[ $solved -gt 0 ]] || { echo "no frame of two is solved"; exit 1; }
