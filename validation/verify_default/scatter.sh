#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# s of single specimens of the default study, seeds 1 to 16 and 101 to 116, as CSV on standard output:
#   validation/verify_default/scatter.sh build/release/granum > validation/verify_default/scatter.csv
set -euo pipefail
granum=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
echo "# program: validation/verify_default/scatter.sh"
echo "contact,density,seed,closed_form,network,probe"
for seed in {1..16} {101..116}; do
  # Exit code 4 where a specimen did not come to rest: it has no row then; 1 where a check fails.
  code=0
  "$granum" verify --quiet --set "study.first_seed=$seed" --out "$folder/$seed" >/dev/null 2>&1 || code=$?
  [[ $code =~ ^[014]$ ]]
  awk -F, -v seed="$seed" '
    /^#/ { next }
    !($1 == "cone" || $1 == "sphere" || $1 == "flat") { for (k = 1; k <= NF; ++k) column[$k] = k; next }
    $column["probe"] != "" {
      printf "%s,%s,%d,%.5f,%.5f,%.5f\n", $1, $2, seed, $column["closed_form"], $column["network"], $column["probe"]
    }' "$folder/$seed/exponents.csv"
done
