#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# From a deck of granum to a stiffness at a size that granum did not make: 1,000 dense spheres, which LAMMPS replicates,
# brings to 200 kPa and to rest on 2 ranks, freezes, and probes as the deck says; then `granum analyse` of the frozen
# state, and LAMMPS' probed moduli beside its 6x6:
#   bench/peers/lammps_replicated.sh GRANUM COPIES [FOLDER]     COPIES along each axis; FOLDER: scratch
# 20 copies along each axis need a cluster; 3 (27,000 grains) take two cores some minutes. Needs lmp, mpirun and python3.
# Exit codes: 0 the moduli agree within 1 %, 1 they do not, 2 usage, 3 a program is missing.
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
if [ "$#" -lt 2 ] || [ "$#" -gt 3 ] || ! [ -x "$1" ] || ! [[ $2 =~ ^[1-9][0-9]*$ ]]; then
  echo "usage: bench/peers/lammps_replicated.sh GRANUM COPIES [FOLDER]" >&2
  exit 2
fi
for program in lmp mpirun python3; do
  if ! command -v "$program" >/dev/null; then
    echo "lammps_replicated.sh: $program is needed (Debian: lammps, openmpi-bin, python3)" >&2
    exit 3
  fi
done
granum=$(realpath -- "$1")
copies=$2
scratch=${3:-$(mktemp -d)}
mkdir -p -- "$scratch"
on_2=(mpirun --oversubscribe --bind-to none --mca mpi_yield_when_idle 1 -np 2 lmp)

source "$here/deck_of_copies.sh"
deck_of_copies "$granum" "$scratch" 200kPa 0.1
cat >whole.lmp <<'END'
include copies.lmp
print "pressure_Pa,state,step,sigma_xx_Pa,sigma_yy_Pa,sigma_zz_Pa,sigma_xy_Pa,sigma_xz_Pa,sigma_yz_Pa,&
volume_m3,unbalanced_force_ratio" file states.csv screen no
include servo.lmp
include rest.lmp
variable name string copies
include snapshot.lmp
END
cat >probe.lmp <<'END'
variable probe_state index copies
variable probed_states index 1
include in.probe
END
for part in whole probe; do
  "${on_2[@]}" -in $part.lmp -var copies "$copies" >$part.out
  awk -v part=$part '/^Loop time of/ { time = $4; ranks = $6; steps = $9; grains = $12 }
    /CPU use with/ { sub("%", "", $1); cpu += time * ranks * $1 / 100; all += steps }
    END { printf "%s: %d grains, %d steps, %.0f CPU s\n", part, grains, all, cpu }' $part.out
done
"$granum" analyse atoms.copies.frozen.dump contacts.copies.frozen.dump --grain-shear-modulus 30GPa --json >analysis.json

python3 - <<'END'
import csv, json, sys
probed = {row["modulus"]: float(row["value_Pa"]) for row in csv.DictReader(open("moduli.csv"))}
C = json.load(open("analysis.json"))["frames"][0]["network"]["relaxed"]["C"]
network = {"G_vh": C[4][4], "G_hh": C[5][5], "K": sum(C[i][j] for i in range(3) for j in range(3)) / 9}
worst = 0
for name, value in probed.items():
    off = value / network[name] - 1
    worst = max(worst, abs(off))
    print(f"{name}: LAMMPS {value / 1e6:.2f} MPa, granum analyse {network[name] / 1e6:.2f} MPa, off by {100 * off:.2f} %")
sys.exit(0 if len(probed) == 3 and worst < 0.01 else 1)
END
