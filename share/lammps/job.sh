#!/bin/bash
#SBATCH --job-name=granum
#SBATCH --ntasks=64
#SBATCH --mem-per-cpu=500M
#SBATCH --time=24:00:00
# The deck as a batch job: sbatch job.sh. Elsewhere: LAUNCH="mpirun -np 8" LAMMPS=lmp bash job.sh
# Each part that ends leaves a file PART.done. A job that is started again begins with the first part without it.
set -euo pipefail
for part in in.prepare in.iso in.probe in.path in.path-probe; do
  [ -e "$part.done" ] && continue
  ${LAUNCH-srun} "${LAMMPS:-lmp}" -in "$part" -log "$part.log"
  touch "$part.done"
done
