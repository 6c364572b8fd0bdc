#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# check_empty_fields.sh <program> <scratch folder>: a row that leaves fields empty has the answer of a table without these
# columns, whatever the row before it gives.
program=$1 folder=$2
rm -rf -- "$folder" && mkdir -p -- "$folder" && cd -- "$folder" || exit 1
echo 'e,p_kPa
0.6,100' >bare.csv
echo 'e,p_kPa,a,contact,slope,grain,grain_shear_modulus_GPa,grain_poisson_ratio,radius_mm,saturation,grain_density_kg/m3,C_n
0.6,100,0.2,cone,0.3,steel,70,0.3,2,1,2700,5
0.6,100,,,,,,,,,,' >empty.csv
for columns in usual all; do
  bare=$("$program" sweep --table bare.csv --columns $columns 2>said | tail -1)
  empty=$("$program" sweep --table empty.csv --columns $columns 2>said | tail -1)
  [[ $empty == "0.6,100,,,,,,,,,,,${bare#0.6,100,}" && ${#bare} -gt 50 ]] || {
    printf '%s\n%s\n' "$bare" "$empty"
    exit 1
  }
done
