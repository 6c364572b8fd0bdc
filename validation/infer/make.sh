#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes states.csv anew:  make.sh path/to/granum > states.csv   (1.5 minutes on two cores)
set -euo pipefail
granum=$1
scene=$(cd "$(dirname "$0")" && pwd)/packings.toml
out=$(mktemp -d)
trap 'rm -r "$out"' EXIT
"$granum" verify --scene "$scene" --out "$out/usual" >&2
opened() { # name, settings
  local name=$1
  shift
  "$granum" verify --scene "$scene" --set study.densities=loose "$@" --out "$out/$name" >&2
}
opened slippery --set grain.friction_angle=5.71deg
opened opened --set specimen.unjamming_strain=0.01 --set specimen.agitation=0.1
opened wide --set specimen.unjamming_strain=0.04 --set specimen.agitation=0.3
echo "contact,recipe,seed,p_Pa,e,C_n,z_star,rattler_fraction,G_network_Pa,K_network_Pa"
for run in usual slippery opened wide; do
  awk -F, -v run=$run '/^#/ { next } !named { for (k = 1; k <= NF; ++k) at[$k] = k; named = 1; next }
    { printf "%s,%s,%d,%d,%.7g,%.7g,%.7g,%.7g,%.7g,%.7g\n", $at["contact"], run == "usual" ? $at["density"] : run,
        $at["seed"], $at["p_Pa"], $at["e"], $at["C_n"], $at["z_star"], $at["rattler_fraction"], $at["G_network_Pa"],
        $at["K_network_Pa"] }' \
    "$out/$run/states.csv"
done
